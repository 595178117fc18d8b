// SPDX-License-Identifier: MIT

#include "flown_world.hpp"
#include "sim/deflection_range.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

using core::CanardVerdict;
using core::Phase;
using core::PhaseReason;

constexpr double fault_s = 2.0;      // after ignition, in the middle of control
constexpr double liftoff_s = 0.013;  // after ignition
constexpr double seen_s = fault_s - liftoff_s;
constexpr std::size_t broken = 1;  // the second canard

FlownWorld fly_with(const Fault& fault, const std::vector<std::string>& changes = {}) {
  Scenario s = scenario("tasha3_launch2", changes);
  s.faults = {fault};
  return fly(s);
}

FlownWorld fly_with(ServoFault fault, const std::vector<std::string>& changes = {}) {
  return fly_with({.device = Device::servo, .canard = broken, .how = GearFault{fault}, .from_s = fault_s}, changes);
}

FlownWorld fly_with_these(const std::vector<Fault>& faults) {
  Scenario s = scenario("tasha3_launch2");
  s.faults = faults;
  return fly(s);
}

double encoder_deg(const Tick& tick, std::size_t canard) {
  return static_cast<double>(tick.record.encoders[canard]->radians()) / degree;
}

/// Every verdict on the broken canard that is not healthy comes after the fault; its neighbours stay healthy.
void expect_noticed_on_the_broken_canard_only(const FlownWorld& flown) {
  bool noticed = false;
  for (const Tick& tick : flown.ticks) {
    for (std::size_t i = 0; i < tick.record.verdicts.size(); ++i) {
      const bool bad = tick.record.verdicts[i] != CanardVerdict::healthy;
      ASSERT_TRUE(!bad || i == broken) << "canard " << i + 1 << " at " << tick.time_s << " s";
      ASSERT_TRUE(!bad || tick.time_s > seen_s) << tick.time_s;
      noticed = noticed || bad;
    }
  }
  EXPECT_TRUE(noticed);
}

TEST(CanardFault, StuckStandsStillAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::stuck);
  const double stands_deg = encoder_deg(flown.at(seen_s + 0.01), broken);
  for (double time_s = seen_s + 0.01; time_s < 9.0; time_s += 0.01) {
    ASSERT_NEAR(encoder_deg(flown.at(time_s), broken), stands_deg, 0.2) << time_s;
  }
  expect_noticed_on_the_broken_canard_only(flown);
}

TEST(CanardFault, HardoverRunsToThePositiveStopAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::hardover);
  EXPECT_NEAR(encoder_deg(flown.at(seen_s + 0.2), broken), 25.0, 0.2);
  EXPECT_NEAR(encoder_deg(flown.at(9.0), broken), 25.0, 0.2);
  expect_noticed_on_the_broken_canard_only(flown);
  // The other three take over: the mean of the four still balances the fin offset.
  EXPECT_NEAR(flown.at(1.5).truth.canard_rad / degree, 4.9, 2.5);
}

TEST(CanardFault, DeadIsTurnedToZeroByTheAirAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::dead);
  for (double time_s = seen_s + 0.3; time_s < 9.0; time_s += 0.01) {
    ASSERT_NEAR(encoder_deg(flown.at(time_s), broken), 0.0, 0.2) << time_s;
  }
  expect_noticed_on_the_broken_canard_only(flown);
}

TEST(CanardFault, SlippingLosesItsPlaceAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::slipping);
  double largest_deg = 0.0;
  for (double time_s = seen_s + 0.1; time_s < 9.0; time_s += 0.01) {
    const Tick& tick = flown.at(time_s);
    largest_deg = std::max(largest_deg, std::abs(encoder_deg(tick, broken) - encoder_deg(tick, 0)));
  }
  EXPECT_GT(largest_deg, 1.5);
  expect_noticed_on_the_broken_canard_only(flown);
}

TEST(CanardFault, ReversedMirrorsItsNeighboursAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::reversed);
  for (double time_s = seen_s + 0.3; time_s < 9.0; time_s += 0.01) {
    const Tick& tick = flown.at(time_s);
    ASSERT_NEAR(encoder_deg(tick, broken), -encoder_deg(tick, 0), 0.6) << time_s;
  }
  expect_noticed_on_the_broken_canard_only(flown);
}

TEST(CanardFault, SlowLagsBehindItsNeighboursAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::slow);
  double largest_deg = 0.0;
  for (double time_s = seen_s + 0.1; time_s < 9.0; time_s += 0.01) {
    const Tick& tick = flown.at(time_s);
    largest_deg = std::max(largest_deg, std::abs(encoder_deg(tick, broken) - encoder_deg(tick, 0)));
  }
  EXPECT_GT(largest_deg, 2.0);
  expect_noticed_on_the_broken_canard_only(flown);
}

TEST(CanardFault, WrongTrimStandsBesideItsNeighboursAndIsNoticed) {
  const FlownWorld flown = fly_with(ServoFault::wrong_trim);
  for (double time_s = seen_s + 0.01; time_s < 9.0; time_s += 0.01) {
    const Tick& tick = flown.at(time_s);
    ASSERT_NEAR(encoder_deg(tick, broken) - encoder_deg(tick, 0), 2.5, 0.3) << time_s;
  }
  expect_noticed_on_the_broken_canard_only(flown);
}

// 25 takes the place of 3 for good: a fault that were applied again and again would bring the canard back.
TEST(CanardFault, IsAppliedOnceAndALaterOneTakesItsPlaceInWhateverOrderTheyAreWritten) {
  const Fault stuck{
      .device = Device::servo, .canard = broken, .how = GearFault{ServoFault::stuck, 3 * degree}, .from_s = 1};
  const Fault hardover{.device = Device::servo, .canard = broken, .how = GearFault{ServoFault::hardover}, .from_s = 2};
  for (const FlownWorld& flown : {fly_with_these({stuck, hardover}), fly_with_these({hardover, stuck})}) {
    EXPECT_NEAR(encoder_deg(flown.at(1.0 - liftoff_s), broken), 3.0, 0.1);
    EXPECT_NEAR(encoder_deg(flown.at(1.9), broken), 3.0, 0.1);
    EXPECT_NEAR(encoder_deg(flown.at(2.5), broken), 25.0, 0.1);
    EXPECT_NEAR(encoder_deg(flown.at(9.0), broken), 25.0, 0.1);
  }
}

TEST(CanardFault, OfLongBeforePowerUpIsThereFromTheFirstTick) {
  const FlownWorld flown = fly_with_these(
      {{.device = Device::servo, .canard = 0, .how = GearFault{ServoFault::stuck, 3 * degree}, .from_s = -600},
       {.device = Device::servo, .canard = 1, .how = GearFault{ServoFault::wrong_trim}, .from_s = -600},
       {.device = Device::encoder, .canard = 2, .how = Behaviour::dead, .from_s = -600}});
  for (const std::size_t tick : {0U, 500U}) {
    EXPECT_NEAR(encoder_deg(flown.ticks[tick], 0), 3.0, 0.1) << tick;
    EXPECT_NEAR(encoder_deg(flown.ticks[tick], 1), 2.5, 0.1) << tick;
    EXPECT_FALSE(flown.ticks[tick].record.encoders[2].has_value()) << tick;
    EXPECT_NEAR(encoder_deg(flown.ticks[tick], 3), 0.0, 0.1) << tick;
  }
}

TEST(CanardFault, EndsControlOnlyWhenThePlanSaysSo) {
  const FlownWorld goes_on = fly_with(ServoFault::hardover);
  EXPECT_EQ(goes_on.first_in(Phase::finished)->record.reason, PhaseReason::apogee);
  const FlownWorld ends = fly_with(ServoFault::hardover, {"run.canard_fault=end_control"});
  EXPECT_EQ(ends.first_in(Phase::finished)->record.reason, PhaseReason::canard_fault);
  EXPECT_LT(ends.first_in(Phase::finished)->time_s, seen_s + 0.3);
}

double sum_of_encoders_deg(const Tick& tick) {
  double sum = 0.0;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    sum += encoder_deg(tick, i);
  }
  return sum;
}

// u_d is -4.9 degrees: the mean canard comes to 4.9 in the end whatever the law. With one at 0 the others stand
// at 6.53; where they share, the roll command is the mean, and the rocket rests where it does with four: at R + u_d /
// kp.
TEST(CanardFault, OfOneThatStandsStillCostsNothingAtRestWhereThePlanShares) {
  const auto flown_with = [](const char* policy) {
    return fly_with(ServoFault::dead,
                    {std::string{"run.canard_fault="} + policy, "reference.kind=hold", "excitation.form=none"});
  };
  const FlownWorld shared = flown_with("share");
  const FlownWorld alone = flown_with("continue");
  const auto command_deg = [](const Tick& tick) { return static_cast<double>(tick.record.command.degrees()); };
  EXPECT_NEAR(sum_of_encoders_deg(shared.at(8.0)), 4.0 * 4.9, 0.3);
  EXPECT_NEAR(command_deg(shared.at(8.0)), 4.9, 0.1);
  EXPECT_NEAR(shared.at(8.0).truth.roll_angle_rad / degree, -4.9 / 0.5, 0.3);
  EXPECT_NEAR(sum_of_encoders_deg(alone.at(8.0)), 4.0 * 4.9, 0.3);
  EXPECT_NEAR(command_deg(alone.at(8.0)), 4.9 * 4.0 / 3.0, 0.15);
  EXPECT_NEAR(alone.at(8.0).truth.roll_angle_rad / degree, -4.9 / 0.5 * 4.0 / 3.0, 0.4);
}

TEST(CanardFault, LeavesTheLoopItsGainWhereThePlanShares) {
  for (const auto& [policy, effectiveness] : {std::pair{"continue", 0.75}, std::pair{"share", 1.0}}) {
    Scenario s = scenario("tasha3_launch2", {std::string{"run.canard_fault="} + policy});
    s.faults = {{.device = Device::servo, .canard = broken, .how = GearFault{ServoFault::dead}}};
    EXPECT_NEAR(canard_response(s).effectiveness, effectiveness, 1e-6) << policy;
  }
}

// Nobody flies by an encoder that is silent, so the flight itself is the same to the last bit.
TEST(EncoderUnplugged, IsEmptyAndDeadAndChangesNothingElse) {
  const FlownWorld flown =
      fly_with({.device = Device::encoder, .canard = broken, .how = Behaviour::dead, .from_s = fault_s});
  const FlownWorld whole = fly("tasha3_launch2");
  ASSERT_EQ(flown.ticks.size(), whole.ticks.size());
  for (std::size_t i = 0; i < flown.ticks.size(); ++i) {
    const Tick& tick = flown.ticks[i];
    ASSERT_EQ(tick.record.encoders[broken].has_value(), tick.time_s < seen_s - 1e-9) << tick.time_s;
    ASSERT_TRUE(tick.record.encoders[0].has_value());
    ASSERT_EQ(tick.truth.roll_angle_rad, whole.ticks[i].truth.roll_angle_rad);
  }
  EXPECT_EQ(flown.at(seen_s + 0.019).record.verdicts[broken], CanardVerdict::healthy);
  EXPECT_EQ(flown.at(seen_s + 0.021).record.verdicts[broken], CanardVerdict::dead);  // 20 ms of patience
}

// 60 counts are 1.32 deg. Before anybody arms it, a canard stands still.
TEST(EncoderNoisy, IsSoFromItsBeginningAndChangesNothingElse) {
  constexpr double from_s = -9.5;  // after ignition: half a second after power-up
  const FlownWorld flown = fly_with({.device = Device::encoder, .canard = broken, .how = Noisy{}, .from_s = from_s});
  const FlownWorld whole = fly("tasha3_launch2");
  ASSERT_EQ(flown.ticks.size(), whole.ticks.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < flown.ticks.size(); ++i) {
    ASSERT_EQ(flown.ticks[i].truth.roll_angle_rad, whole.ticks[i].truth.roll_angle_rad);
    ASSERT_EQ(encoder_deg(flown.ticks[i], 0), encoder_deg(whole.ticks[i], 0));
    if (i < 500) {
      ASSERT_EQ(encoder_deg(flown.ticks[i], broken), encoder_deg(whole.ticks[i], broken));
    } else if (i < 1000) {
      squares += std::pow(encoder_deg(flown.ticks[i], broken), 2);
    }
  }
  EXPECT_NEAR(std::sqrt(squares / 500.0), 60.0 * 360.0 / 16384.0, 4.0 * 1.32 / std::sqrt(2.0 * 500.0));
}

TEST(ImuDropout, OfMillisecondsIsBridgedAndControlGoesOn) {
  for (const double length_s : {0.003, 0.008, 0.1}) {
    const FlownWorld flown = fly_with({.how = Behaviour::hangs, .from_s = fault_s, .until_s = fault_s + length_s});
    EXPECT_EQ(flown.first_in(Phase::finished)->record.reason, PhaseReason::apogee) << length_s;
  }
}

// One that came just before the dropout is too old at the tick after the longest gap.
TEST(ImuDropout, LongerThanThePlansLongestGapEndsControl) {
  const FlownWorld flown = fly_with({.how = Behaviour::hangs, .from_s = fault_s, .until_s = fault_s + 0.5});
  const Tick* end = flown.first_in(Phase::finished);
  ASSERT_NE(end, nullptr);
  EXPECT_EQ(end->record.reason, PhaseReason::gyro_failed);
  EXPECT_NEAR(end->time_s, seen_s + 0.25, 1e-9);
  EXPECT_EQ(end->record.command.radians(), 0.0F);
  EXPECT_NEAR(flown.at(seen_s + 0.5).truth.canard_rad, 0.0, 0.2 * degree);  // at trim
}

TEST(AccelerometerDropout, OfOneOfTwoStopsDetectionUnlessThePlanAllowsASingleOne) {
  const auto dropped = [](const char* single_allowed) {
    Scenario s = scenario("tasha3_launch2", {std::string{"launch_detection.single_allowed="} + single_allowed});
    s.faults = {{.device = Device::accelerometer, .how = Behaviour::hangs, .from_s = -1.0, .until_s = 20.0}};
    return fly(s);
  };
  const FlownWorld refused = dropped("false");
  EXPECT_EQ(refused.first_in(Phase::launched), nullptr);
  EXPECT_TRUE(refused.events.apogee.has_value());
  const FlownWorld allowed = dropped("true");
  EXPECT_NE(allowed.first_in(Phase::controlling), nullptr);
}

// Two canards built in the other way round, and a plan that knows: the rocket must not notice.
TEST(ReversedMounting, WithAPlanThatKnowsFliesTheSame) {
  const std::string directions = "[\"reversed\",\"normal\",\"reversed\",\"normal\"]";
  const FlownWorld known =
      fly("tasha3_launch2", {"canard_mounting.direction=" + directions, "canards.direction=" + directions});
  const FlownWorld usual = fly("tasha3_launch2");
  ASSERT_EQ(known.ticks.size(), usual.ticks.size());
  for (std::size_t i = 0; i < known.ticks.size(); ++i) {
    ASSERT_NEAR(known.ticks[i].truth.roll_angle_rad, usual.ticks[i].truth.roll_angle_rad, 0.05 * degree);
  }
  EXPECT_LT(known.at(1.5).record.encoders[0]->radians() * known.at(1.5).record.encoders[1]->radians(), 0.0F);
}

// Each axis of a sensor has its own noise, so the two flights differ by what that does.
TEST(TurnedImu, WithAPlanThatKnowsFliesTheSame) {
  const FlownWorld known =
      fly("tasha3_launch2", {"imu.to_nose=-z", "imu.along_y=+x", "sensors.imu_to_nose=-z", "sensors.imu_along_y=+x"});
  const FlownWorld usual = fly("tasha3_launch2");
  ASSERT_EQ(known.ticks.size(), usual.ticks.size());
  for (std::size_t i = 0; i < known.ticks.size(); ++i) {
    ASSERT_NEAR(known.ticks[i].truth.roll_angle_rad, usual.ticks[i].truth.roll_angle_rad, 1.0 * degree);
  }
}

TEST(TurnedImu, WithAPlanThatBelievesOtherwiseIsNeverArmed) {
  const FlownWorld flown = fly("tasha3_launch2", {"imu.to_nose=-z", "imu.along_y=+x"});
  EXPECT_EQ(flown.first_in(Phase::armed), nullptr);
}

TEST(ReversedMounting, WithAPlanThatBelievesOtherwiseSpinsTheRocket) {
  const std::string all = "[\"reversed\",\"reversed\",\"reversed\",\"reversed\"]";
  const FlownWorld flown = fly("tasha3_launch2", {"canard_mounting.direction=" + all});
  EXPECT_GT(std::abs(flown.at(5.0).truth.roll_angle_rad), 360.0 * degree);
}

}  // namespace
}  // namespace fantail::sim
