// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
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
  std::string plan;
  std::string out;
  bool json = false;
};

struct NamedPlan {
  std::filesystem::path file;
  core::FlightPlan plan;
};

NamedPlan load(const PlanOptions& options) {
  const std::filesystem::path file = sim::find_input(sim::Shipped::plan, options.plan);
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
  const NamedPlan named = load(options);
  fmt::print("{}", options.json ? plan_json(named.plan) : sim::plan_table(named.plan));
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

CLI::App* add_action(CLI::App* verb, const std::string& name, const std::string& meaning,
                     const std::shared_ptr<PlanOptions>& options, Action action) {
  CLI::App* sub = verb->add_subcommand(name, meaning);
  sub->add_option("PLAN", options->plan, "A shipped name (tasha3_launch1, tasha3_launch2, tunnel_steps) or a path")
      ->required();
  sub->add_flag("--json", options->json, "Print one JSON object");
  sub->callback([options, action] { action(*options); });
  return sub;
}

}  // namespace

void add_plan(CLI::App& program) {
  auto* verb = program.add_subcommand("plan", "Check, show or pack a flight plan");
  verb->require_subcommand(1);
  auto options = std::make_shared<PlanOptions>();
  const std::string examples =
      "Examples:\n"
      "  fantail plan check my_plan.toml                   may it fly? If not: file, line, value, allowed range\n"
      "  fantail plan show tasha3_launch2                  every number with its unit, range and meaning\n"
      "  fantail plan compile tasha3_launch2 --out p.ftpl  the block of bytes that a board is loaded with";
  verb->footer(examples);
  add_action(verb, "check", "Say whether a plan may fly", options, check)->footer(examples);
  add_action(verb, "show", "Print every field, defaults included", options, show)->footer(examples);
  auto* packing = add_action(verb, "compile", "Write the packed block a board is loaded with", options, compile);
  packing->add_option("--out", options->out, "File to write [PLAN.ftpl]");
  packing->footer(examples);
}

}  // namespace fantail::tool
