// SPDX-License-Identifier: MIT
#include "sim/scenario.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/document.hpp"
#include "sim/input_error.hpp"
#include "sim/plan_file.hpp"
#include "sim/shipped.hpp"
#include "sim/shown.hpp"
#include "sim/units.hpp"

namespace fantail::sim {
namespace {

const std::vector<std::string>& scenario_sections() {
  static const std::vector<std::string> names{"environment", "tunnel", "disturbance", "imposed_roll", "timing"};
  return names;
}

void read_environment(const Document& document, Scenario& scenario) {
  Section section{document, "environment"};
  constexpr std::array<std::string_view, 2> surroundings{"flight", "tunnel"};
  constexpr std::array<std::string_view, 3> densities{"exponential", "isa", "constant"};
  scenario.surroundings = static_cast<Surroundings>(section.choice("surroundings", surroundings, 0));
  scenario.atmosphere.model = static_cast<DensityModel>(section.choice("density", densities, 0));
  scenario.atmosphere.constant_kg_m3 = section.number("density_kg_m3", {0.01, 5}, scenario.atmosphere.constant_kg_m3);
  scenario.guide_tilt_rad = radians_per_degree * section.number("guide_tilt_deg", {0, 15}, 0.0);
  section.finish();
}

// Two lists of one length, the times increasing.
struct TimedValues {
  std::vector<double> times_s;
  std::vector<double> values;
};

TimedValues read_timed_values(Section& section, std::string_view times_key, std::string_view values_key,
                              Limits time_limits, Limits value_limits) {
  const TimedValues read{section.numbers(times_key, time_limits, 1000),
                         section.numbers(values_key, value_limits, 1000)};
  if (read.times_s.size() != read.values.size()) {
    section.refuse(times_key, "has " + std::to_string(read.times_s.size()) + " values and " + std::string{values_key} +
                                  " has " + std::to_string(read.values.size()) + "; allowed: as many of each");
  }
  if (std::ranges::adjacent_find(read.times_s, [](double a, double b) { return a >= b; }) != read.times_s.end()) {
    section.refuse(times_key, "must increase");
  }
  return read;
}

void read_fan_programme(Section& section, Scenario& scenario) {
  const TimedValues read = read_timed_values(section, "fan_times_s", "fan_rpms", {0, 3600}, {0, 3000});
  for (std::size_t i = 0; i < read.times_s.size(); ++i) {
    scenario.fan_programme.push_back({read.times_s[i], read.values[i]});
  }
}

void read_tunnel(const Document& document, Scenario& scenario) {
  Section section{document, "tunnel"};
  WindTunnelParameters& p = scenario.tunnel;
  p.fan_rpm = section.number("fan_rpm", {0, 3000}, p.fan_rpm);
  p.speed_per_rpm_m_s = section.number("speed_per_rpm_m_s", {0.001, 0.1}, p.speed_per_rpm_m_s);
  p.turbulence = section.number("turbulence", {0, 0.5}, p.turbulence);
  p.turbulence_time_s = section.number("turbulence_time_s", {0.01, 60}, p.turbulence_time_s);
  p.fan_lag_s = section.number("fan_lag_s", {0.1, 600}, p.fan_lag_s);
  p.swirl_rad = radians_per_degree * section.number("swirl_deg", {-20, 20}, p.swirl_rad / radians_per_degree);
  p.density_kg_m3 = section.number("density_kg_m3", {0.01, 5}, p.density_kg_m3);
  read_fan_programme(section, scenario);
  WindSensor& sensor = scenario.wind_sensor;
  sensor.period_s = section.number("wind_sensor_period_s", {0.001, 600}, sensor.period_s);
  sensor.resolution_m_s = section.number("wind_sensor_resolution_m_s", {0, 5}, sensor.resolution_m_s);
  section.finish();
}

void read_disturbance(const Document& document, Scenario& scenario) {
  Section section{document, "disturbance"};
  const TimedValues read = read_timed_values(section, "times_s", "angles_deg", {0, 600}, {-45, 45});
  for (std::size_t i = 0; i < read.times_s.size(); ++i) {
    scenario.disturbance.push_back({read.times_s[i], radians_per_degree * read.values[i]});
  }
  section.finish();
}

void read_imposed_roll(const Document& document, Scenario& scenario) {
  if (!document.root()["imposed_roll"]) {
    return;
  }
  Section section{document, "imposed_roll"};
  scenario.imposed_roll = {.time_s = section.number("time_s", {0, 600}),
                           .angle_rad = radians_per_degree * section.number("angle_deg", {-3600, 3600}),
                           .rate_rad_s = radians_per_degree * section.number("rate_deg_s", {-3600, 3600})};
  section.finish();
}

void read_timing(const Document& document, Scenario& scenario) {
  Section section{document, "timing"};
  scenario.pad_time_s = section.number("pad_time_s", {1, 600}, scenario.pad_time_s);
  scenario.arm_time_s = section.number("arm_time_s", {0.1, 600}, scenario.arm_time_s);
  scenario.time_after_end_s = section.number("time_after_end_s", {0, 3600}, scenario.time_after_end_s);
  scenario.log_period_s = section.number("log_period_s", {0.001, 1}, scenario.log_period_s);
  if (std::abs(scenario.log_period_s * 1e3 - std::round(scenario.log_period_s * 1e3)) > 1e-9) {
    section.refuse("log_period_s", "= " + shown(scenario.log_period_s) + " is not a whole number of milliseconds");
  }
  if (scenario.arm_time_s >= scenario.pad_time_s) {
    const std::string arm = shown(scenario.arm_time_s);
    const std::string pad = shown(scenario.pad_time_s);
    if (section.has("arm_time_s")) {
      section.refuse("arm_time_s", "= " + arm + " must be earlier than pad_time_s = " + pad);
    }
    section.refuse("pad_time_s", "= " + pad + " must be later than arm_time_s = " + arm);
  }
  section.finish();
}

void read_scenario_document(const Document& document, Scenario& scenario) {
  read_environment(document, scenario);
  read_tunnel(document, scenario);
  read_disturbance(document, scenario);
  read_imposed_roll(document, scenario);
  read_timing(document, scenario);
  scenario.faults = read_faults(document, scenario.vehicle.servo.stop_rad);
  const bool tunnel_plan = scenario.plan.run.start == core::Start::tunnel;
  if (tunnel_plan != (scenario.surroundings == Surroundings::tunnel)) {
    Section{document, "environment"}.refuse(
        "surroundings", tunnel_plan ? "must be \"tunnel\": the plan starts with run.start = \"tunnel\""
                                    : "must be \"flight\": the plan starts with run.start = \"launch\"");
  }
}

}  // namespace

Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes) {
  const std::filesystem::path file = find_input(Shipped::scenario, name_or_path);
  Document scenario_document = Document::load(file);
  Section top{scenario_document, ""};
  Scenario scenario;
  scenario.name = file.stem().string();
  scenario.vehicle_name = top.text("vehicle");
  scenario.plan_name = top.text("plan");
  scenario.seed = static_cast<std::uint64_t>(top.integer("seed", {0, 9e15}, 1));
  scenario.assumed = top.texts("assumed", 100);
  if (top.has("tunnel_result")) {
    scenario.tunnel_result = find_named_input(Shipped::tunnel_result, scenario_document, top, "tunnel_result");
  }
  Document plan_document = Document::load(find_named_input(Shipped::plan, scenario_document, top, "plan"));
  Document vehicle_document = Document::load(find_named_input(Shipped::vehicle, scenario_document, top, "vehicle"));

  std::vector<std::string> sections = scenario_sections();
  const std::vector<std::string> of_plan = plan_sections();
  const std::vector<std::string> of_vehicle = vehicle_sections();
  for (const Override& change : changes) {
    auto names = [&](const std::vector<std::string>& list) {
      return std::ranges::find(list, change.section) != list.end();
    };
    if (names(of_plan)) {
      plan_document.apply(change);
    } else if (names(of_vehicle)) {
      vehicle_document.apply(change);
    } else if (names(sections)) {
      scenario_document.apply(change);
    } else {
      std::vector<std::string> all = sections;
      all.insert(all.end(), of_plan.begin(), of_plan.end());
      all.insert(all.end(), of_vehicle.begin(), of_vehicle.end());
      std::string message = change.text() + ": unknown section " + change.section;
      if (const auto meant = suggestion(change.section, all)) {
        message += "; did you mean " + *meant + "?";
      }
      throw InputError{InputFault::bad_configuration, message};
    }
  }
  sections.insert(sections.end(), {"vehicle", "plan", "seed", "assumed", "tunnel_result", "faults"});
  refuse_unknown_sections(scenario_document, sections);
  scenario.plan = read_plan(plan_document);
  scenario.vehicle = read_vehicle(vehicle_document);
  read_scenario_document(scenario_document, scenario);
  return scenario;
}

}  // namespace fantail::sim
