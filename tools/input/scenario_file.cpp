// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"

#include <algorithm>
#include <cmath>

#include "input/copied.hpp"
#include "input/fault_file.hpp"
#include "input/file_kind.hpp"
#include "input/messages.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

// Two keys are the columns of one list, whose first column is the time.
template <typename Point>
void check_points(const Document& document, std::string_view section_name, std::string_view times_key,
                  std::string_view values_key, const std::vector<Point>& points) {
  const Section section{document, std::string{section_name}};
  const auto length = [&](std::string_view key) {
    const auto elements = document.root()[section_name][key].elements();
    return elements ? elements->size() : 0;
  };
  const std::size_t times = length(times_key);
  const std::size_t values = length(values_key);
  if (times != values) {
    section.refuse(times_key, "has " + std::to_string(times) + " values and " + std::string{values_key} + " has " +
                                  std::to_string(values) + "; allowed: as many of each");
  }
  if (std::ranges::adjacent_find(points, std::ranges::greater_equal{}, &Point::time_s) != points.end()) {
    section.refuse(times_key, "must increase");
  }
}

void check_timing(const Document& document, const sim::Scenario& scenario) {
  Section timing{document, "timing"};
  if (std::abs(scenario.log_period_s * 1e3 - std::round(scenario.log_period_s * 1e3)) > 1e-9) {
    timing.refuse("log_period_s",
                  "= " + plain_number(scenario.log_period_s) + " is not a whole number of milliseconds");
  }
  if (scenario.arm_time_s >= scenario.pad_time_s) {
    const std::string arm = plain_number(scenario.arm_time_s);
    const std::string pad = plain_number(scenario.pad_time_s);
    if (timing.has("arm_time_s")) {
      timing.refuse("arm_time_s", "= " + arm + " must be earlier than pad_time_s = " + pad);
    }
    timing.refuse("pad_time_s", "= " + pad + " must be later than arm_time_s = " + arm);
  }
}

void check_surroundings(const Document& document, const sim::Scenario& scenario) {
  const bool tunnel_plan = scenario.plan.run.start == core::Start::tunnel;
  if (tunnel_plan != (scenario.surroundings == sim::Surroundings::tunnel)) {
    Section{document, "environment"}.refuse(
        "surroundings", tunnel_plan ? "must be \"tunnel\": the plan starts with run.start = \"tunnel\""
                                    : "must be \"flight\": the plan starts with run.start = \"launch\"");
  }
}

// A tunnel has air of its own, the same at every height.
void settle_density(const Document& document, sim::Scenario& scenario) {
  if (scenario.surroundings != sim::Surroundings::tunnel) {
    return;
  }
  Section environment{document, "environment"};
  for (const char* key : {"density", "density_kg_m3"}) {
    if (environment.has(key)) {
      environment.refuse(key, "plays no part in the tunnel; allowed: tunnel.density_kg_m3 instead");
    }
  }
  scenario.atmosphere = {.model = sim::DensityModel::constant, .constant_kg_m3 = scenario.tunnel.density_kg_m3};
}

// The three files of a run. A section's name is in one of them only.
struct Documents {
  Document scenario;
  Document plan;
  Document vehicle;

  void apply(const Override& change) {
    std::vector<std::string> known;
    for (const auto& [document, sections] : {std::pair{&scenario, sections_of(scenario_fields())},
                                             {&plan, plan_sections()},
                                             {&vehicle, sections_of(vehicle_fields())}}) {
      if (std::ranges::find(sections, change.section) != sections.end()) {
        document->apply(change);
        return;
      }
      known.insert(known.end(), sections.begin(), sections.end());
    }
    std::string message = change.text() + ": unknown section " + change.section;
    if (const auto meant = suggestion(change.section, known)) {
      message += "; did you mean " + *meant + "?";
    }
    throw text::Error{text::ErrorKind::bad_configuration, message};
  }
};

void refuse_unknown_words_at_the_top(const Document& document) {
  std::vector<std::string> known = sections_of(scenario_fields());
  for (const Field<sim::Scenario>& field : scenario_fields()) {
    if (field.section.empty()) {
      known.emplace_back(field.key);
    }
  }
  known.emplace_back("faults");
  refuse_unknown_sections(document, known);
}

}  // namespace

sim::Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes) {
  const std::filesystem::path file = find_input(Shipped::scenario, name_or_path);
  Documents documents{.scenario = Document::load(file), .plan = {}, .vehicle = {}};
  refuse_other_kind(documents.scenario, Shipped::scenario);
  sim::Scenario scenario;
  scenario.name = file.stem().string();
  read_section(documents.scenario, "", scenario_fields(), scenario);
  Section top{documents.scenario, ""};
  if (top.has("tunnel_result")) {
    scenario.tunnel_result = find_named_input(Shipped::tunnel_result, documents.scenario, top, "tunnel_result");
  }
  documents.plan = Document::load(find_named_input(Shipped::plan, documents.scenario, top, "plan"));
  documents.vehicle = Document::load(find_named_input(Shipped::vehicle, documents.scenario, top, "vehicle"));
  for (const Override& change : changes) {
    documents.apply(change);
  }
  refuse_unknown_words_at_the_top(documents.scenario);
  scenario.plan = read_plan(documents.plan);
  scenario.vehicle = read_vehicle(documents.vehicle);
  for (const std::string& section : sections_of(scenario_fields())) {
    read_section(documents.scenario, section, scenario_fields(), scenario);
  }
  check_points(documents.scenario, "tunnel", "fan_times_s", "fan_rpms", scenario.fan_programme);
  check_points(documents.scenario, "disturbance", "times_s", "angles_deg", scenario.disturbance);
  check_timing(documents.scenario, scenario);
  scenario.faults = read_faults(documents.scenario, scenario.vehicle.servo.stop_rad);
  check_surroundings(documents.scenario, scenario);
  settle_density(documents.scenario, scenario);
  scenario.warnings = questions_about_scenario(documents.scenario, documents.vehicle, scenario);
  return scenario;
}

}  // namespace fantail::input
