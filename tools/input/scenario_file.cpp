// SPDX-License-Identifier: MIT
#include "input/scenario_file.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

#include "input/fault_file.hpp"
#include "input/file_checks.hpp"
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
                                  std::to_string(values) + "; allowed: the same number of each");
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
  if (tunnel_plan != (scenario.surroundings != sim::Surroundings::flight)) {
    Section{document, "environment"}.refuse(
        "surroundings", tunnel_plan ? "must be \"tunnel\" or \"gimbal\": the plan starts with run.start = \"tunnel\""
                                    : "must be \"flight\": the plan starts with run.start = \"launch\"");
  }
}

void warn_of_instability(sim::Scenario& scenario) {
  constexpr double no_distance_m = 1e-6;
  const sim::Airframe& airframe = *scenario.vehicle.airframe;
  for (const auto& [mass, when] :
       {std::pair{airframe.at_liftoff, "at lift-off"}, {airframe.after_burnout, "after burn-out"}}) {
    const double margin_m = static_margin_m(airframe, mass);
    if (margin_m <= -no_distance_m) {
      scenario.warnings.push_back("The rocket is unstable " + std::string{when} + ": its centre of pressure is " +
                                  about(-1e3 * margin_m) + " mm in front of its centre of gravity.");
    } else if (margin_m <= 0.0) {
      scenario.warnings.push_back("The rocket is not stable " + std::string{when} +
                                  ": its centre of pressure is at its centre of gravity.");
    }
  }
}

// What is not simulated along a straight line must not look as if it were.
void check_motion(const Document& document, const Document& vehicle, sim::Scenario& scenario) {
  if (scenario.vehicle.airframe && scenario.surroundings == sim::Surroundings::flight) {
    warn_of_instability(scenario);
  }
  if (scenario.motion == sim::FlightMotion::six_dof) {
    const Section flight{document, "flight"};
    if (scenario.surroundings != sim::Surroundings::flight) {
      flight.refuse("motion", "= \"six_dof\" has no meaning in the tunnel or on the gimbal; allowed: \"straight\"");
    }
    if (!scenario.vehicle.airframe) {
      flight.refuse("motion", "= \"six_dof\" needs the section [airframe], which the vehicle does not have");
    }
    check_balance(vehicle, scenario.vehicle);
    return;
  }
  const auto refuse = [&](const char* name, std::initializer_list<const char*> keys) {
    Section section{document, name};
    for (const char* key : keys) {
      if (section.has(key)) {
        section.refuse(key, "has no effect on a straight line; allowed: with flight.motion = \"six_dof\"");
      }
    }
  };
  refuse("launch_guide", {"azimuth_deg", "friction", "tip_off_deg_s", "roll"});
  refuse("wind", {"from_deg", "reference_height_m", "exponent", "gust_m_s", "gust_time_s", "gust_duration_s",
                  "turbulence", "speed_spread_m_s", "direction_spread_deg"});
}

void check_pin(const Document& document, const sim::Scenario& scenario) {
  if (!scenario.pin) {
    return;
  }
  check_points(document, "tunnel_pin", "kick_times_s", "kick_rates_deg_s", scenario.pin->kicks);
  if (scenario.surroundings != sim::Surroundings::tunnel) {
    Section{document, "environment"}.refuse("surroundings",
                                            "must be \"tunnel\", because there is a section [tunnel_pin]");
  }
  if (!scenario.vehicle.airframe) {
    Section{document, ""}.refuse("vehicle", "has no section [airframe], which [tunnel_pin] needs");
  }
}

void check_gimbal(const Document& document, const sim::Scenario& scenario) {
  for (const char* key : {"turn_durations_s", "turn_roll_deg", "turn_pitch_deg", "turn_yaw_deg"}) {
    check_points(document, "gimbal", "turn_times_s", key, scenario.hand_turns);
  }
  const auto overlap = std::ranges::adjacent_find(
      scenario.hand_turns, [](const auto& a, const auto& b) { return b.time_s < a.time_s + a.duration_s; });
  if (overlap != scenario.hand_turns.end()) {
    Section{document, "gimbal"}.refuse("turn_times_s", "a turn begins before the previous one has ended");
  }
  if (scenario.gimbal_friction_n_m && !scenario.vehicle.airframe) {
    Section{document, ""}.refuse("vehicle", "has no section [airframe], which gimbal.friction_n_m needs");
  }
  if ((!scenario.hand_turns.empty() || scenario.gimbal_friction_n_m) &&
      scenario.surroundings != sim::Surroundings::gimbal) {
    Section{document, "environment"}.refuse("surroundings", "must be \"gimbal\", because there is a section [gimbal]");
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
      environment.refuse(key, "has no effect in the tunnel; allowed: tunnel.density_kg_m3 instead");
    }
  }
  scenario.atmosphere = {.model = sim::DensityModel::constant, .constant_kg_m3 = scenario.tunnel.density_kg_m3};
}

void refuse_unknown_words_at_the_top(const Document& document) {
  std::vector<std::string> known = sections_of(scenario_fields());
  for (const Field<sim::Scenario>& field : scenario_fields()) {
    if (field.section.empty()) {
      known.emplace_back(field.key);
    }
  }
  known.emplace_back("faults");
  known.emplace_back("spread");  // of a campaign, which reads them; one flight has the values as they stand
  refuse_unknown_sections(document, known);
}

}  // namespace

ScenarioFiles ScenarioFiles::load(const std::string& name_or_path) {
  ScenarioFiles files;
  files.scenario_ = Document::load(find_input(Shipped::scenario, name_or_path));
  refuse_other_kind(files.scenario_, Shipped::scenario);
  Section top{files.scenario_, ""};
  files.plan_ = Document::load(find_named_input(Shipped::plan, files.scenario_, top, "plan"));
  files.vehicle_ = Document::load(find_named_input(Shipped::vehicle, files.scenario_, top, "vehicle"));
  refuse_unknown_words_at_the_top(files.scenario_);
  return files;
}

const Document* ScenarioFiles::with_section(std::string_view section) const {
  for (const auto& [document, sections] : {std::pair{&scenario_, sections_of(scenario_fields())},
                                           {&plan_, plan_sections()},
                                           {&vehicle_, sections_of(vehicle_fields())}}) {
    if (std::ranges::find(sections, section) != sections.end()) {
      return document;
    }
  }
  return nullptr;
}

void ScenarioFiles::apply(const Override& change) {
  for (Document* document : {&scenario_, &plan_, &vehicle_}) {
    if (document == with_section(change.section)) {
      document->apply(change);
      return;
    }
  }
  throw text::Error{text::ErrorKind::bad_configuration, change.text() + ": " + unknown_section(change.section)};
}

sim::Scenario ScenarioFiles::read() const {
  sim::Scenario scenario;
  scenario.name = name_of_file(scenario_.file());
  read_section(scenario_, "", scenario_fields(), scenario);
  Section top{scenario_, ""};
  if (top.has("tunnel_result")) {
    scenario.tunnel_result = find_named_input(Shipped::tunnel_result, scenario_, top, "tunnel_result");
  }
  scenario.plan = read_plan(plan_);
  scenario.vehicle = read_vehicle(vehicle_);
  for (const std::string& section : sections_of(scenario_fields())) {
    read_section(scenario_, section, scenario_fields(), scenario);
  }
  check_points(scenario_, "tunnel", "fan_times_s", "fan_rpms", scenario.fan_programme);
  check_points(scenario_, "disturbance", "times_s", "angles_deg", scenario.disturbance);
  check_timing(scenario_, scenario);
  scenario.faults = read_faults(scenario_, scenario.vehicle, scenario.plan);
  check_surroundings(scenario_, scenario);
  check_motion(scenario_, vehicle_, scenario);
  check_pin(scenario_, scenario);
  check_gimbal(scenario_, scenario);
  settle_density(scenario_, scenario);
  std::ranges::move(questions_about_scenario(scenario_, vehicle_, scenario), std::back_inserter(scenario.warnings));
  return scenario;
}

std::string unknown_section(const std::string& section) {
  std::vector<std::string> known;
  for (const auto& sections : {sections_of(scenario_fields()), plan_sections(), sections_of(vehicle_fields())}) {
    known.insert(known.end(), sections.begin(), sections.end());
  }
  const auto meant = suggestion(section, known);
  return "unknown section " + section + (meant ? "; did you mean " + *meant + "?" : "");
}

std::vector<Override> parse_overrides(std::span<const std::string> texts) {
  std::vector<Override> all(texts.size());
  std::ranges::transform(texts, all.begin(), parse_override);
  return all;
}

sim::Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes) {
  ScenarioFiles files = ScenarioFiles::load(name_or_path);
  for (const Override& change : changes) {
    files.apply(change);
  }
  return files.read();
}

}  // namespace fantail::input
