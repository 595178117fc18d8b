// SPDX-License-Identifier: MIT
#include <algorithm>
#include <variant>

#include "faults/fault_table.hpp"

// How the faults of the table are made, and which of them a scenario can have.
namespace fantail::faults {
namespace {

constexpr double for_good_s = 3600.0;
constexpr double between_resets_s = 0.2;

}  // namespace

std::string_view name(Phase phase) {
  constexpr std::array<std::string_view, phases> names{"pad", "armed", "launched", "controlling", "after_control"};
  return names[static_cast<std::size_t>(phase)];
}

std::string_view meaning(Phase phase) {
  constexpr std::array<std::string_view, phases> meanings{
      "from power-up to arming", "from arming to ignition", "from ignition to the beginning of control, dormant or not",
      "under control", "from the end of control to the end of the flight"};
  return meanings[static_cast<std::size_t>(phase)];
}

std::vector<std::string_view> device_names() {
  std::vector<std::string_view> names;
  for (const FaultRow& row : fault_table()) {
    if (names.empty() || names.back() != row.device) {
      names.push_back(row.device);
    }
  }
  return names;
}

std::string why_not(const FaultRow& row, const sim::Scenario& scenario) {
  const sim::Device device = row.recipe.fault.device;
  const bool two_imus =
      scenario.vehicle.second_imu_is_fitted && scenario.plan.sensors.gyros == core::GyroRule::two_agree;
  if (device == sim::Device::abort_input && scenario.plan.run.abort_input == core::AbortInput::none) {
    return "the plan fits no abort input (run.abort_input)";
  }
  if (device == sim::Device::second_imu && !two_imus) {
    return "the rocket does not use a second IMU";
  }
  const bool has_barometer =
      scenario.vehicle.barometer.is_fitted && scenario.plan.sensors.barometer != core::BarometerUse::none;
  return device == sim::Device::barometer && !has_barometer ? "the rocket does not use a barometer" : "";
}

double end_of(const Recipe& recipe, double begin_s) {
  if (const auto* reset = std::get_if<sim::Reset>(&recipe.fault.how)) {
    return begin_s + between_resets_s * (recipe.times - 1) + reset->gap_s;
  }
  return recipe.lasts_s > 0.0 ? begin_s + recipe.lasts_s : for_good_s;
}

std::string FaultRow::shaft_sentence() const {
  return std::string{recipe.all_canards ? "the canards may stand " : "the failed canard may stand "}.append(
      faults::meaning(shaft));
}

Shafts shafts_of(const FaultRow& row, std::uint64_t run) {
  Shafts shafts{};
  if (row.recipe.all_canards) {
    shafts.fill(row.shaft);
  } else {
    shafts[run % hal::canards] = row.shaft;
  }
  return shafts;
}

std::vector<sim::Fault> faults_of(const Recipe& recipe, double begin_s, std::uint64_t run,
                                  const sim::Scenario& scenario) {
  sim::Fault fault = recipe.fault;
  fault.from_s = begin_s;
  if (fault.until_s) {
    fault.until_s = end_of(recipe, begin_s);
  }
  if (auto* gear = std::get_if<sim::GearFault>(&fault.how); gear != nullptr && gear->angle_rad) {
    const double stop_rad = scenario.vehicle.servo.stop_rad;
    gear->angle_rad = std::clamp(*gear->angle_rad, -stop_rad, stop_rad);
  }
  std::vector<sim::Fault> faults(recipe.all_canards ? hal::canards : static_cast<std::size_t>(recipe.times), fault);
  for (std::size_t i = 0; i < faults.size(); ++i) {
    if (recipe.all_canards) {
      faults[i].canard = i;
    } else {
      faults[i].canard = sim::is_of_canard(fault.device) ? run % hal::canards : 0;
      faults[i].from_s = begin_s + between_resets_s * static_cast<double>(i);
    }
  }
  return faults;
}

}  // namespace fantail::faults
