// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "core/flight_plan.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/plan_check.hpp"
#include "fantail/run.hpp"
#include "fantail/terminal.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "json/value.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/plan_block.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct PlanOptions {
  std::optional<std::string> plan;  ///< `show` goes without, and `check` with a scenario
  std::optional<std::string> scenario;
  std::optional<std::string> rules;
  std::string out;
  bool json = false;
};

struct NamedPlan {
  std::filesystem::path file;
  core::FlightPlan plan;
};

NamedPlan load(const PlanOptions& options) {
  const std::filesystem::path file = input::find_input(input::Shipped::plan, *options.plan);
  return {.file = file, .plan = input::read_plan(input::Document::load(file))};
}

void check(const PlanOptions& options) {
  check_plan({.plan = options.plan, .scenario = options.scenario, .rules = options.rules, .json = options.json});
}

void show_plan(const PlanOptions& options) {
  const core::FlightPlan plan = options.plan ? load(options).plan : core::default_plan();
  if (options.json) {
    json::Value json = plan_json(plan);
    result::put_answer(json, result::Answer::none, "Every field of the plan, defaults included.",
                       options.plan ? made_with({load(options).file}) : made_with({}));
    fmt::print("{}", json.pretty());
  } else {
    show_text(input::plan_table(plan));
  }
}

void compile(const PlanOptions& options) {
  const NamedPlan named = load(options);
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(named.plan, block);
  const std::string content(reinterpret_cast<const char*>(block.data()), size);

  const std::filesystem::path file{options.out.empty() ? named.file.stem().string() + ".ftpl" : options.out};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
  const std::array<text::NamedFile, 1> files{{{file.filename().string(), content}}};
  text::OutputFolder{folder, {named.file}}.write(files);
  if (options.json) {
    json::Value json{{"plan", named.file.string()},
                     {"block", file.string()},
                     {"bytes", size},
                     {"schema", fmt::format("{:08x}", protocol::plan_schema_hash())},
                     {"crc", fmt::format("{:08x}", protocol::plan_crc(named.plan))}};
    result::put_answer(json, result::Answer::none, fmt::format("Wrote {}: {} bytes.", file.string(), size),
                       made_with({named.file}));
    fmt::print("{}\n", json.dump());
  } else {
    show("{}: {} bytes, format {}, schema {:08x}, checksum {:08x}\n", file.string(), size, protocol::plan_block_version,
         protocol::plan_schema_hash(), protocol::plan_crc(named.plan));
  }
}

struct Action {
  const char* name;
  const char* meaning;
  bool needs_plan;
  const char* without;  ///< what a plan that is left out means
  void (*act)(const PlanOptions&);
  const char* examples;
};

constexpr Action checking{
    "check",
    "Check whether the firmware accepts a plan, and where it is weaker than the shipped plans",
    false,
    "; left out: that of --scenario",
    check,
    "Exit code 0: the firmware accepts it, with or without warnings; 78: it does not. With --rules, 1: a clause fails "
    "or "
    "could not be judged.\n"
    "Examples:\n"
    "  fantail plan check my_plan.toml         may it fly? If not: file, line, value, allowed range\n"
    "  fantail plan check tasha3_launch1       a shipped plan\n"
    "  fantail plan check my_plan.toml --scenario my_rocket/scenario.toml\n"
    "                                          and is its loop stable at every speed under control?\n"
    "  fantail plan check my_rocket/scenario.toml  the same for the scenario's own plan\n"
    "  fantail plan check my_plan.toml --rules irec\n"
    "                                          and does it meet the clauses on plans?\n"
    "  fantail plan check my_plan.toml --json  for a script, which also gets the exit code"};
constexpr Action showing{
    "show",
    "Print every field, defaults included",
    false,
    "; left out: every default",
    show_plan,
    "Examples:\n"
    "  fantail plan show                                 every field with its default, unit, range and meaning\n"
    "  fantail plan show tasha3_launch2 > my_plan.toml   a plan of your own to begin with\n"
    "  fantail plan show my_plan.toml --json             every number of a plan, for a script"};
constexpr Action packing{
    "compile",
    "Write the packed block to load into a board",
    true,
    "",
    compile,
    "Examples:\n"
    "  fantail plan compile tasha3_launch2                  into tasha3_launch2.ftpl\n"
    "  fantail plan compile my_plan.toml --out load/p.ftpl  into a file of your choice\n"
    "  fantail plan compile my_plan.toml --json             size and format of the block, for a script"};

Verb add(const Verb& plan_verb, const Action& action, const std::shared_ptr<PlanOptions>& options) {
  const Verb verb = plan_verb.verb(action.name, action.meaning);
  const std::string plan = "A shipped name (tasha3_launch1, tasha3_launch2, tunnel_steps) or a path";
  verb.option("PLAN", options->plan, plan + action.without)
      .offers(shipped(input::Shipped::plan))
      .required(action.needs_plan);
  verb.flag("--json", options->json, "Print one JSON object");
  verb.examples(action.examples);
  verb.action([options, act = action.act] { act(*options); });
  return verb;
}

void fill(const Verb& plan) {
  plan.needs_verb();
  plan.examples(
      "Examples:\n"
      "  fantail plan check my_plan.toml                   may it fly? If not: file, line, value, allowed range\n"
      "  fantail plan show tasha3_launch2                  every number with its unit, range and meaning\n"
      "  fantail plan compile tasha3_launch2 --out p.ftpl  the block of bytes to load into a board");
  auto options = std::make_shared<PlanOptions>();
  const Verb check = add(plan, checking, options);
  check
      .option(
          "--scenario", options->scenario,
          "A scenario whose rocket is to fly it. The phase margin of the loop is checked from 20 m/s, or control start "
          "if that is slower, to top speed. Below 45 degrees is a warning; an unstable loop is refused")
      .offers(shipped(input::Shipped::scenario));
  check
      .option("--rules", options->rules,
              "A rule pack (irec, euroc, launch_canada, nar_tripoli, or a path): its clauses that need no flight "
              "are judged, too. The others: fantail rules")
      .offers(shipped(input::Shipped::rules));
  add(plan, showing, options);
  add(plan, packing, options).option("--out", options->out, "File to write [PLAN.ftpl]").offers(files);
}

const VerbCode code{"plan", fill};

}  // namespace
}  // namespace fantail::tool
