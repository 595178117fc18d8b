// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "faults/fault_table.hpp"
#include "sim/units.hpp"

// How the faults of the table are made, and which of them a scenario can have.
namespace fantail::faults {
namespace {

constexpr double for_good_s = 3600.0;
constexpr double between_resets_s = 0.2;

bool is_of_one_canard(const Recipe& recipe) {
  return recipe.kind == sim::FaultKind::device ? sim::is_of_canard(recipe.device)
                                               : !sim::is_of_sensor(recipe.kind) && !sim::is_reset(recipe.kind);
}

bool is_of_second_imu(const Recipe& recipe) {
  return recipe.kind == sim::FaultKind::device ? recipe.device == sim::Device::second_imu
                                               : sim::is_of_second_imu(recipe.kind);
}

}  // namespace

std::string_view name(Phase phase) {
  constexpr std::array<std::string_view, phases> names{"pad", "armed", "launched", "controlling", "after_control"};
  return names[static_cast<std::size_t>(phase)];
}

std::string_view meaning(Phase phase) {
  constexpr std::array<std::string_view, phases> meanings{"from power-up to arming", "from arming to ignition",
                                                          "from ignition to the beginning of control", "under control",
                                                          "from the end of control to the end of the flight"};
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
  const bool is_fitted =
      scenario.vehicle.second_imu_is_fitted && scenario.plan.sensors.gyros == core::GyroRule::two_agree;
  return is_of_second_imu(row.recipe) && !is_fitted ? "the rocket does not fly on a second IMU" : "";
}

double end_of(const Recipe& recipe, double begin_s) {
  if (sim::is_reset(recipe.kind)) {
    return begin_s + between_resets_s * (recipe.times - 1) + recipe.reset.gap_s;
  }
  return recipe.lasts_s > 0.0 ? begin_s + recipe.lasts_s : for_good_s;
}

std::string FaultRow::shaft_sentence() const {
  return std::string{recipe.all_canards ? "the canards may stand " : "the canard that fails may stand "}.append(
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
  sim::Fault fault{.kind = recipe.kind,
                   .canard = run % hal::canards,
                   .from_s = begin_s,
                   .until_s = end_of(recipe, begin_s),
                   .rate_offset_rad_s = recipe.offset_deg_s * sim::radians_per_degree,
                   .reset = recipe.reset,
                   .misbehaviour = {.device = recipe.device,
                                    .behaviour = recipe.behaviour,
                                    .on_s = recipe.on_s,
                                    .off_s = recipe.off_s,
                                    .delay_s = recipe.delay_s,
                                    .variant = run}};
  if (recipe.angle_deg != 0.0) {
    fault.angle_rad = std::clamp(recipe.angle_deg * sim::radians_per_degree, -scenario.vehicle.servo.stop_rad,
                                 scenario.vehicle.servo.stop_rad);
  }
  std::vector<sim::Fault> faults{fault};
  for (int i = 1; i < recipe.times; ++i) {
    faults.push_back(fault);
    faults.back().from_s = begin_s + between_resets_s * i;
  }
  for (std::size_t canard = 0; recipe.all_canards && canard < hal::canards; ++canard) {
    faults.resize(hal::canards, fault);
    faults[canard].canard = canard;
  }
  if (!is_of_one_canard(recipe)) {
    for (sim::Fault& each : faults) {
      each.canard = 0;
    }
  }
  return faults;
}

}  // namespace fantail::faults
