// SPDX-License-Identifier: MIT
#include "playground/controls.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "core/flight_plan_fields.hpp"
#include "input/fault_file.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "json/value.hpp"
#include "playground/flown.hpp"
#include "playground/shipped_texts.hpp"
#include "sim/fault.hpp"
#include "sim/scenario.hpp"
#include "sim/vehicle.hpp"

namespace fantail::playground {
namespace {

/// One slider. Its ends are those of what is worth trying; a number that is typed may go as far as the key allows.
struct Control {
  std::string_view section;
  std::string_view key;
  std::string_view label;
  double low;
  double high;
  double step;
  std::optional<sim::Surroundings> only{};  ///< empty: of any scenario
};

constexpr std::array offered{
    Control{"controller", "proportional_gain", "Proportional gain", 0.0, 2.0, 0.01},
    Control{"controller", "derivative_gain_s", "Derivative gain", 0.0, 0.3, 0.005},
    Control{"controller", "canard_limit_deg", "Canard limit", 1.0, 15.0, 0.5},
    Control{"disturbance", "angles_deg", "Fin offset", -12.0, 12.0, 0.1},
    Control{"motor", "thrust_factor", "Thrust (launch speed)", 0.5, 1.5, 0.01, sim::Surroundings::flight},
    Control{"tunnel", "fan_rpm", "Fan speed", 0.0, 2000.0, 10.0, sim::Surroundings::tunnel},
    Control{"excitation", "amplitude_deg", "Chirp", 0.0, 9.0, 0.1},
    Control{"servo", "lag_s", "Servo lag", 0.001, 0.1, 0.001},
};

struct Described {
  std::string_view unit;
  std::string_view meaning;
  std::optional<double> usual{};
};

template <typename Thing>
std::optional<Described> described(std::span<const input::Field<Thing>> fields, const Control& control,
                                   const Thing& usual) {
  for (const input::Field<Thing>& field : fields) {
    if (field.section == control.section && field.key == control.key) {
      const bool has_usual = !field.allowed.is_list && field.place.get != nullptr;
      return Described{field.allowed.unit.name, field.meaning,
                       has_usual ? std::optional{field.allowed.unit.in_file(field.place.get(usual, 0))} : std::nullopt};
    }
  }
  return std::nullopt;
}

Described described(const Control& control) {
  for (const core::PlanField& field : core::flight_plan_fields()) {
    if (field.section == control.section && field.key == control.key) {
      return {field.unit, field.meaning, input::usual_in_plan(field)};
    }
  }
  if (const auto found = described(input::scenario_fields(), control, sim::Scenario{})) {
    return *found;
  }
  return described(input::vehicle_fields(), control, sim::Vehicle{}).value_or(Described{});
}

/// What the files say; of a list, where it has one value only.
std::optional<double> value_of(const input::ScenarioFiles& files, const Control& control) {
  const input::Document* document = files.with_section(control.section);
  const input::TomlNode node = document->root()[control.section][control.key];
  const auto elements = node.elements();
  return elements ? (elements->size() == 1 ? elements->front().number() : std::nullopt) : node.number();
}

/// The kinds that numbers alone describe, with those that have to be there.
json::Value faults() {
  json::Value all = json::Value::array();
  for (const input::FaultWords& words : input::fault_kinds()) {
    json::Value numbers = json::Value::array();
    bool has_words = false;
    for (const auto& [field, belongs_to] : input::fault_fields().subspan(1)) {  // behind the kind
      if (field.presence == input::Presence::may || !belongs_to(words)) {
        continue;
      }
      has_words = has_words || field.allowed.kind == input::FieldKind::choice;
      numbers.push_back({{"key", field.key}, {"unit", field.allowed.unit.name}, {"meaning", field.meaning}});
    }
    if (!has_words && words.fault.device != sim::Device::second_imu) {
      all.push_back({{"kind", words.kind}, {"meaning", words.meaning}, {"fields", std::move(numbers)}});
    }
  }
  return all;
}

}  // namespace

std::string controls(const std::string& scenario) {
  append_to_scenarios({});
  const input::ScenarioFiles files = input::ScenarioFiles::load(scenario);
  const sim::Scenario read = files.read();
  json::Value all = json::Value::array();
  for (const Control& control : offered) {
    const bool is_of_a_chirp = control.section == "excitation";
    if ((control.only && *control.only != read.surroundings) ||
        (is_of_a_chirp && read.plan.excitation.form == core::ExcitationForm::none)) {
      continue;  // it would change nothing
    }
    const Described about = described(control);
    const bool is_there = static_cast<bool>(files.with_section(control.section)->root()[control.section][control.key]);
    all.push_back({{"key", std::string{control.section} + "." + std::string{control.key}},
                   {"label", control.label},
                   {"unit", about.unit},
                   {"meaning", about.meaning},
                   {"value", is_there ? value_of(files, control) : about.usual},
                   {"low", control.low},
                   {"high", control.high},
                   {"step", control.step}});
  }
  constexpr std::array surroundings{"flight", "tunnel", "gimbal"};
  json::Value answer{{"surroundings", surroundings[static_cast<std::size_t>(read.surroundings)]},
                     {"seed", read.seed},
                     {"controls", std::move(all)},
                     {"faults", faults()}};
  return answer.dump();
}

std::string names() {
  std::string all;
  for (const std::string& name : input::shipped_names(input::Shipped::scenario)) {
    all += name + '\n';
  }
  return all + '\n' + std::string{column_names()};
}

}  // namespace fantail::playground
