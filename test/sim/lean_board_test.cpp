// SPDX-License-Identifier: MIT
#include "sim/lean_board.hpp"

#include <filesystem>
#include <tuple>

#include "input/scenario_file.hpp"
#include "sim/simulated_board.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

Scenario changed(const std::string& name, const std::vector<std::string>& changes) {
  return input::load_scenario(name, input::parse_overrides(changes));
}

/// All that a record says of a tick.
auto everything_in(const core::TickRecord& record) {
  const core::Motion& motion = record.motion;
  const auto vector = [](const core::Vector3& v) { return std::array{v.x, v.y, v.z}; };
  std::array<std::tuple<float, float, bool, bool>, core::canard_count> canards;
  std::array<std::optional<float>, core::canard_count> encoders;
  for (std::size_t i = 0; i < canards.size(); ++i) {
    const core::CanardCommand& canard = record.canards[i];
    canards[i] = {canard.angle.radians(), canard.pulse_us, canard.driven, canard.limited};
    encoders[i] = record.encoders[i] ? std::optional{record.encoders[i]->radians()} : std::nullopt;
  }
  return std::tuple{
      std::tuple{record.time, record.phase, record.reason, record.detection, record.command_status, record.timing_fault,
                 record.overruns, record.gyro_vote, record.barometer_state, record.saturated, record.verdicts},
      std::tuple{record.reference.radians(), record.excitation.radians(), record.offset_estimate.radians(),
                 record.unclamped_command.radians(), record.command.radians(), canards, encoders},
      std::tuple{motion.roll_angle.radians(), motion.roll_rate_rad_s, vector(motion.gyro_bias_rad_s),
                 vector(motion.specific_force_m_s2), motion.height_m, motion.horizontal_distance_m,
                 motion.distance_along_guide_m, motion.speed_m_s, motion.vertical_speed_m_s, motion.speed_squared_m2_s2,
                 motion.tilt.radians()},
      std::tuple{motion.gyro, motion.accelerometer, motion.rate_is_lower_bound, motion.roll_is_bridged,
                 motion.speed_is_lower_bound, motion.at_rest_for, motion.has_moved, motion.has_fallen,
                 motion.thrust_since}};
}

/// Both in step until the world ends, or for a minute, and the phases that were seen.
std::vector<core::Phase> expect_the_same_ticks(const Scenario& scenario) {
  World whole{scenario};
  World lean{scenario, World::small_flash, unrecorded_board(scenario)};
  std::vector<core::Phase> phases;
  for (int ticks = 0; !whole.over() && ticks < 60'000; ++ticks) {
    const core::TickRecord& one = whole.tick();
    const core::TickRecord& other = lean.tick();
    if (everything_in(one) != everything_in(other) || whole.hardware().pulses != lean.hardware().pulses) {
      ADD_FAILURE() << scenario.name << ": another record in tick " << ticks;
      return phases;
    }
    if (phases.empty() || phases.back() != one.phase) {
      phases.push_back(one.phase);
    }
    whole.advance();
    lean.advance();
  }
  EXPECT_EQ(whole.over(), lean.over());
  EXPECT_EQ(whole.refusal_to_arm(), lean.refusal_to_arm());
  EXPECT_EQ(whole.events().apogee, lean.events().apogee);
  return phases;
}

class EveryScenario : public testing::TestWithParam<std::string> {};

TEST_P(EveryScenario, HasTheSameTicksWithoutItsRecord) {
  const auto phases = expect_the_same_ticks(changed(GetParam(), {}));
  EXPECT_GT(phases.size(), 2U) << "it was armed";
}

std::vector<std::string> shipped() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{FANTAIL_TEST_SCENARIOS}) {
    const std::string name = entry.path().stem().string();
    if (!name.starts_with("bench_")) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryScenario, testing::ValuesIn(shipped()),
                         [](const auto& name) { return name.param; });

TEST(LeanBoard, HasTheSameTicksWithTwoGyrosInSixDegreesOfFreedomAndWithABarometer) {
  expect_the_same_ticks(changed("tasha3_launch2", {"sensors.gyros=two_agree", "second_imu.fitted=yes"}));
  expect_the_same_ticks(changed("tasha3_launch2", {"flight.motion=six_dof", "wind.speed_m_s=6", "wind.turbulence=0.2",
                                                   "launch_guide.tilt_deg=5"}));
  expect_the_same_ticks(changed("tasha3_launch2", {"sensors.barometer=fused", "barometer.fitted=yes"}));
}

TEST(LeanBoard, IsRefusedByTheCrewWhereTheWholeOneIsAndHasTheSameTicks) {
  const auto phases = expect_the_same_ticks(changed("tasha3_launch2", {"imu.rate_bias_deg_s=20"}));
  EXPECT_EQ(phases, std::vector{core::Phase::safe});
}

TEST(LeanBoard, GivesWayToTheWholeOneWhereTheScenarioHasFaults) {
  Scenario scenario = changed("tasha3_launch2", {});
  const auto is_whole = [](const MakeFlightComputer& make) {
    using Make =
        std::unique_ptr<FlightComputer> (*)(const core::FlightPlan&, const BoardPorts&, const avionics::Identity&);
    const auto* const function = make.target<Make>();
    return function != nullptr && *function == &simulated_board;
  };
  EXPECT_FALSE(is_whole(unrecorded_board(scenario)));
  scenario.faults.push_back({});
  EXPECT_TRUE(is_whole(unrecorded_board(scenario)));
}

}  // namespace
}  // namespace fantail::sim
