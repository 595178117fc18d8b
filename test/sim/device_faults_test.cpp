// SPDX-License-Identifier: MIT
// Faults of devices: what the avionics is shown, and what the servos hear.

#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double begin_s = 2.0;
constexpr double end_s = 2.5;
constexpr std::size_t broken = 1;
constexpr std::int16_t most = std::numeric_limits<std::int16_t>::max();

Fault misbehaves(Device device, How how) {
  return {.device = device, .canard = broken, .how = how, .from_s = begin_s, .until_s = end_s};
}

/// What is shown in each tick from 1.9 s to 2.6 s after ignition.
struct Shown {
  double time_s;
  core::Microseconds now;
  hal::sim::WorldSide hardware;
  [[nodiscard]] bool in_fault() const { return time_s > begin_s - 1e-6 && time_s < end_s - 1e-6; }
};

std::vector<Shown> watch(const Fault& fault, const std::vector<std::string>& changes = {}) {
  Scenario s = scenario("tasha3_launch2", changes);
  s.faults = {fault};
  World world{s};
  std::vector<Shown> all;
  while (world.now() < core::Microseconds{12'600'000}) {
    world.tick();
    const double time_s = 1e-6 * static_cast<double>(world.now().count()) - s.pad_time_s;
    if (time_s > 1.9) {
      all.push_back({time_s, world.now(), world.hardware()});
    }
    world.advance();
  }
  return all;
}

/// True of every tick of the fault, and of none outside of it.
void expect_only_in_the_fault(const Fault& fault, const std::function<bool(const Shown&)>& what) {
  for (const Shown& shown : watch(fault)) {
    ASSERT_EQ(what(shown), shown.in_fault()) << shown.time_s;
  }
}

TEST(DeviceFault, ASensorThatIsDeadSaysNothingAndIsAsBeforeAfterwards) {
  expect_only_in_the_fault(misbehaves(Device::imu, Behaviour::dead),
                           [](const Shown& s) { return s.hardware.imu.status == hal::Status::no_reading; });
  expect_only_in_the_fault(misbehaves(Device::accelerometer, Behaviour::dead),
                           [](const Shown& s) { return s.hardware.accelerometer.status == hal::Status::no_reading; });
  expect_only_in_the_fault(misbehaves(Device::encoder, Behaviour::dead), [](const Shown& s) {
    return s.hardware.encoders.each[broken].status == hal::Status::no_reading;
  });
}

TEST(DeviceFault, OneThatIsSaturatedStandsAtTheUpperEndOfItsXAxis) {
  expect_only_in_the_fault(misbehaves(Device::imu, Behaviour::saturated), [](const Shown& s) {
    return s.hardware.imu.rate[0] == most && s.hardware.imu.specific_force[0] == most;
  });
  expect_only_in_the_fault(misbehaves(Device::encoder, Behaviour::saturated),
                           [](const Shown& s) { return s.hardware.encoders.each[broken].counts == 16383; });
}

TEST(DeviceFault, OneWithoutANumberShowsTheCountsThatStandForNone) {
  expect_only_in_the_fault(misbehaves(Device::imu, Behaviour::nan), [](const Shown& s) {
    return s.hardware.imu.rate == hal::no_counts && s.hardware.imu.status == hal::Status::ok;
  });
  expect_only_in_the_fault(misbehaves(Device::encoder, Behaviour::nan),
                           [](const Shown& s) { return s.hardware.encoders.each[broken].counts == 65535; });
}

TEST(DeviceFault, StuckRepeatsTheCountsAsNewOnesAndRepeatedTheWholeSampleWithItsOldTime) {
  for (const Behaviour behaviour : {Behaviour::stuck, Behaviour::repeated}) {
    const std::vector<Shown> all = watch(misbehaves(Device::imu, behaviour));
    for (std::size_t i = 1; i < all.size(); ++i) {
      const hal::ImuSample& before = all[i - 1].hardware.imu;
      const hal::ImuSample& now = all[i].hardware.imu;
      const bool same = now.rate == before.rate && now.specific_force == before.specific_force;
      ASSERT_EQ(same, all[i].in_fault()) << all[i].time_s;
      ASSERT_EQ(now.time == before.time, all[i].in_fault() && behaviour == Behaviour::repeated) << all[i].time_s;
    }
  }
}

TEST(DeviceFault, GarbageIsAnotherInEveryTickAndTheSameWithTheSameSeed) {
  const Fault fault = misbehaves(Device::imu, Behaviour::garbage);
  const std::vector<Shown> all = watch(fault);
  double largest = 0.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i].in_fault()) {
      ASSERT_NE(all[i].hardware.imu.rate, all[i - 1].hardware.imu.rate);
      ASSERT_EQ(all[i].hardware.imu.status, hal::Status::ok);
      largest = std::max(largest, std::abs(static_cast<double>(all[i].hardware.imu.rate[0])));
    }
  }
  EXPECT_GT(largest, 30000.0);
  const std::vector<Shown> again = watch(fault);
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(again[i].hardware.imu.rate, all[i].hardware.imu.rate);
  }
}

TEST(DeviceFault, ADelayedSampleIsTheOneMeasuredThenWithItsOwnTime) {
  const std::vector<Shown> all = watch(misbehaves(Device::imu, Delayed{0.03}));
  const std::vector<Shown> whole = watch(misbehaves(Device::flash, Behaviour::dead));
  for (std::size_t i = 30; i < all.size(); ++i) {
    const std::size_t from = all[i].in_fault() ? i - 30 : i;
    ASSERT_EQ(all[i].hardware.imu.time, whole[from].now) << all[i].time_s;
  }
}

TEST(DeviceFault, ThatComesAndGoesIsThereForOnAndGoneForOff) {
  Fault fault = misbehaves(Device::imu, Behaviour::dead);
  fault.on_s = 0.003;
  fault.off_s = 0.027;
  for (const Shown& shown : watch(fault)) {
    const auto ms = std::llround(1e3 * (shown.time_s - begin_s));
    const bool there = shown.in_fault() && ms % 30 < 3;
    ASSERT_EQ(shown.hardware.imu.status == hal::Status::no_reading, there) << shown.time_s;
  }
}

TEST(DeviceFault, ASupplyThatSagsAndASwitchThatOpensAreSeenByTheAvionics) {
  expect_only_in_the_fault(misbehaves(Device::supply, Behaviour::sagging),
                           [](const Shown& s) { return s.hardware.board.faults.has(hal::BoardFault::supply_low); });
  expect_only_in_the_fault(misbehaves(Device::arm_switch, Behaviour::dead),
                           [](const Shown& s) { return !s.hardware.arm_switch_closed; });
}

TEST(DeviceFault, AProcessorThatStandsHasNoTicksAndTheServosKeepTheirPulses) {
  const std::vector<Shown> all = watch(misbehaves(Device::processor, Behaviour::dead));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const bool fed = all[i].hardware.watchdog_fed == all[i].now;
    ASSERT_EQ(fed, !all[i].in_fault()) << all[i].time_s;
    if (all[i].in_fault()) {
      ASSERT_EQ(all[i].hardware.pulses, all[i - 1].hardware.pulses);
    }
  }
}

double encoder_deg(const FlownWorld& flown, double time_s, std::size_t canard) {
  return static_cast<double>(flown.at(time_s).record.encoders[canard]->radians()) / degree;
}

FlownWorld fly_servo(How how) {
  Scenario s = scenario("tasha3_launch2");
  s.faults = {misbehaves(Device::servo, how)};
  return fly(s);
}

// Lift-off is at 0.013 s after ignition.
TEST(DeviceFault, AServoWithoutPulsesStandsStillAndFollowsAgainAfterwards) {
  const FlownWorld flown = fly_servo(Behaviour::dead);
  const double stands_deg = encoder_deg(flown, 2.02, broken);
  for (double time_s = 2.02; time_s < 2.48; time_s += 0.01) {
    ASSERT_NEAR(encoder_deg(flown, time_s, broken), stands_deg, 0.2) << time_s;
  }
  EXPECT_NEAR(encoder_deg(flown, 8.5, broken), encoder_deg(flown, 8.5, 0), 0.3);
}

TEST(DeviceFault, AServoAtItsStopComesBackAndOneWithRandomPulsesDoesNotFollow) {
  const FlownWorld flown = fly_servo(GearFault{ServoFault::hardover});
  EXPECT_NEAR(encoder_deg(flown, 2.4, broken), 25.0, 0.2);
  EXPECT_NEAR(encoder_deg(flown, 8.5, broken), encoder_deg(flown, 8.5, 0), 0.3);
  const FlownWorld random = fly_servo(Behaviour::garbage);
  double apart_deg = 0.0;
  for (double time_s = 2.05; time_s < 2.48; time_s += 0.01) {
    apart_deg = std::max(apart_deg, std::abs(encoder_deg(random, time_s, broken) - encoder_deg(random, time_s, 0)));
  }
  EXPECT_GT(apart_deg, 5.0);
}

TEST(DeviceFault, ABusThatIsDeadWhileThePadCrewWorksKeepsTheRocketFromBeingArmed) {
  Scenario s = scenario("tasha3_launch2");
  s.faults = {misbehaves(Device::bus, Behaviour::dead)};
  s.faults[0].from_s = -600.0;
  s.faults[0].until_s = 60.0;
  EXPECT_EQ(fly(s).first_in(core::Phase::armed), nullptr);
}

TEST(DeviceFault, AFlashThatIsDeadAtPowerUpKeepsTheRocketFromBeingArmed) {
  for (const Behaviour behaviour : {Behaviour::dead, Behaviour::stuck}) {
    Scenario s = scenario("tasha3_launch2");
    s.faults = {misbehaves(Device::flash, behaviour)};
    s.faults[0].from_s = -600.0;
    s.faults[0].until_s = 60.0;
    EXPECT_EQ(fly(s).first_in(core::Phase::armed), nullptr);
  }
}

TEST(DeviceFault, AFlippedBitOfThePlanEndsControl) {
  Scenario s = scenario("tasha3_launch2");
  s.faults = {misbehaves(Device::memory, Behaviour::plan_bit_flipped)};
  const FlownWorld flown = fly(s);
  ASSERT_NE(flown.first_in(core::Phase::finished), nullptr);
  EXPECT_EQ(flown.first_in(core::Phase::finished)->record.reason, core::PhaseReason::memory_fault);
  EXPECT_LT(flown.first_in(core::Phase::finished)->time_s, 2.1);
}

// A run of the same seed, in which a fault is announced but never comes.
TEST(DeviceFault, ThatNeverComesChangesNothing) {
  Scenario s = scenario("tasha3_launch2");
  s.faults = {misbehaves(Device::imu, Behaviour::garbage)};
  s.faults[0].from_s = 100.0;
  s.faults[0].until_s = 101.0;
  const FlownWorld flown = fly(s);
  const FlownWorld whole = fly("tasha3_launch2");
  ASSERT_EQ(flown.ticks.size(), whole.ticks.size());
  for (std::size_t i = 0; i < flown.ticks.size(); i += 7) {
    ASSERT_EQ(flown.ticks[i].truth.roll_angle_rad, whole.ticks[i].truth.roll_angle_rad);
  }
}

}  // namespace
}  // namespace fantail::sim
