// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/flight_plan.hpp"
#include "core/flight_plan_fields.hpp"
#include "fantail/verbs.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/plan_block.hpp"
#include "report/output_folder.hpp"
#include "sim/plan_file.hpp"
#include "sim/shipped.hpp"

namespace fantail::tool {
namespace {

struct PlanOptions {
  std::optional<std::string> plan;  ///< only `show` goes without
  std::string out;
  bool json = false;
};

struct NamedPlan {
  std::filesystem::path file;
  core::FlightPlan plan;
};

NamedPlan load(const PlanOptions& options) {
  const std::filesystem::path file = sim::find_input(sim::Shipped::plan, *options.plan);
  return {.file = file, .plan = sim::read_plan(sim::Document::load(file))};
}

nlohmann::ordered_json field_value(const core::PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  const float value = field.get(plan, slot);
  switch (field.kind) {
    case core::FieldKind::flag: return value != 0.0F;
    case core::FieldKind::choice: return std::string{field.choices[static_cast<std::size_t>(value)]};
    case core::FieldKind::integer: return static_cast<std::int64_t>(value);
    case core::FieldKind::number: break;
  }
  // The shortest decimal that reads back as the same single-precision number.
  return nlohmann::ordered_json::parse(fmt::format("{}", value));
}

std::string plan_json(const core::FlightPlan& plan) {
  nlohmann::ordered_json json;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    auto& place = json[std::string{field.section}][std::string{field.key}];
    if (field.slots == 1) {
      place = field_value(field, plan, 0);
      continue;
    }
    place = nlohmann::ordered_json::array();
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      place.push_back(field_value(field, plan, slot));
    }
  }
  return json.dump(2) + "\n";
}

void check(const PlanOptions& options) {
  const NamedPlan named = load(options);
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"plan", named.file.string()}, {"may_fly", true}}.dump());
  } else {
    fmt::print("{}: every field is known and within its range; this plan may fly\n", named.file.string());
  }
}

void show(const PlanOptions& options) {
  const core::FlightPlan plan = options.plan ? load(options).plan : core::default_plan();
  fmt::print("{}", options.json ? plan_json(plan) : sim::plan_table(plan));
}

void compile(const PlanOptions& options) {
  const NamedPlan named = load(options);
  std::array<std::byte, protocol::largest_plan_block> block{};
  const std::size_t size = protocol::write_plan_block(named.plan, block);
  const std::string content(reinterpret_cast<const char*>(block.data()), size);

  const std::filesystem::path file{options.out.empty() ? named.file.stem().string() + ".ftpl" : options.out};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
  const std::array<report::NamedFile, 1> files{{{file.filename().string(), content}}};
  report::OutputFolder{folder}.write(files);
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"plan", named.file.string()},
                                              {"block", file.string()},
                                              {"bytes", size},
                                              {"schema", fmt::format("{:08x}", protocol::plan_schema_hash())}}
                           .dump());
  } else {
    fmt::print("{}: {} bytes, format {}, schema {:08x}\n", file.string(), size, protocol::plan_block_version,
               protocol::plan_schema_hash());
  }
}

using Action = void (*)(const PlanOptions&);

struct Verb {
  const char* name;
  const char* meaning;
  bool needs_plan;
  Action action;
  const char* examples;
};

constexpr Verb checking{
    "check", "Say whether a plan may fly", true, check,
    "Examples:\n"
    "  fantail plan check my_plan.toml         may it fly? If not: file, line, value, allowed range\n"
    "  fantail plan check tasha3_launch1       a shipped plan\n"
    "  fantail plan check my_plan.toml --json  for a script, which also gets the exit code"};
constexpr Verb showing{
    "show", "Print every field, defaults included", false, show,
    "Examples:\n"
    "  fantail plan show                                 every field with its default, unit, range and meaning\n"
    "  fantail plan show tasha3_launch2 > my_plan.toml   a plan of your own to begin with\n"
    "  fantail plan show my_plan.toml --json             every number of a plan, for a script"};
constexpr Verb packing{
    "compile", "Write the packed block a board is loaded with", true, compile,
    "Examples:\n"
    "  fantail plan compile tasha3_launch2                  into tasha3_launch2.ftpl\n"
    "  fantail plan compile my_plan.toml --out load/p.ftpl  into a file of your choice\n"
    "  fantail plan compile my_plan.toml --json             size and format of the block, for a script"};

CLI::App* add_verb(CLI::App* parent, const Verb& verb, const std::shared_ptr<PlanOptions>& options) {
  CLI::App* sub = parent->add_subcommand(verb.name, verb.meaning);
  const std::string plan = "A shipped name (tasha3_launch1, tasha3_launch2, tunnel_steps) or a path";
  sub->add_option("PLAN", options->plan, verb.needs_plan ? plan : plan + "; left out: every default")
      ->required(verb.needs_plan);
  sub->add_flag("--json", options->json, "Print one JSON object");
  sub->footer(verb.examples);
  sub->callback([options, action = verb.action] { action(*options); });
  return sub;
}

}  // namespace

void add_plan(CLI::App& program) {
  auto* plan = program.add_subcommand("plan", "Check, show or pack a flight plan");
  plan->require_subcommand(1);
  plan->footer(
      "Examples:\n"
      "  fantail plan check my_plan.toml                   may it fly? If not: file, line, value, allowed range\n"
      "  fantail plan show tasha3_launch2                  every number with its unit, range and meaning\n"
      "  fantail plan compile tasha3_launch2 --out p.ftpl  the block of bytes that a board is loaded with");
  auto options = std::make_shared<PlanOptions>();
  add_verb(plan, checking, options);
  add_verb(plan, showing, options);
  add_verb(plan, packing, options)->add_option("--out", options->out, "File to write [PLAN.ftpl]");
}

}  // namespace fantail::tool
