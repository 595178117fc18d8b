// SPDX-License-Identifier: MIT
// Where the sensors sit and how they are shaken, as far as their counts.

#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

/// A tick as the devices showed it.
struct Seen {
  double from_ignition_s;
  hal::ImuSample imu;
  hal::AccelerometerSample accelerometer;
};

struct Watched {
  std::vector<Seen> ticks;
  double liftoff_s;  ///< after ignition, as the next
  double burnout_s;
  hal::ImuScale imu_scale;
  double accelerometer_scale_m_s2;

  [[nodiscard]] double mean(double from_s, double until_s, const std::function<double(const Seen&)>& value) const {
    double sum = 0.0;
    int count = 0;
    for (const Seen& seen : ticks) {
      if (seen.from_ignition_s > from_s && seen.from_ignition_s < until_s) {
        sum += value(seen);
        ++count;
      }
    }
    return sum / count;
  }
};

Watched watch(const Scenario& scenario) {
  World world{scenario};
  const auto from_ignition = [&](core::Microseconds time) {
    return 1e-6 * static_cast<double>(time.count()) - scenario.pad_time_s;
  };
  Watched watched{};
  while (!world.over()) {
    world.tick();
    const hal::sim::WorldSide& shown = world.hardware();
    watched.ticks.push_back({from_ignition(world.now()), shown.imu, shown.accelerometer});
    world.advance();
  }
  watched.liftoff_s = from_ignition(world.events().liftoff.value_or(world.now()));
  watched.burnout_s = from_ignition(world.events().burnout.value());
  watched.imu_scale = world.hardware().imu_scale;
  watched.accelerometer_scale_m_s2 = static_cast<double>(world.hardware().accelerometer_scale_m_s2);
  return watched;
}

/// Its canards move it no more, so that what the avionics makes of its sensors changes nothing of the flight.
Scenario flight_without_authority(const std::vector<std::string>& changes = {}) {
  Scenario s = scenario("tasha3_launch2", changes);
  s.vehicle.roll_plant.torque_m = 0.0;
  return s;
}

// 10 rad/s, 50 mm off the axis, is 5 m/s2 inwards; each sensor has its own place.
TEST(WorldSensors, FeelTheSpinEachAtItsOwnPlace) {
  Scenario s = flight_without_authority();
  s.vehicle.roll_plant.damping_m2 = 0.0;
  s.imposed_roll = {.time_s = 0.0, .angle_rad = 0.0, .rate_rad_s = 10.0};
  s.vehicle.imu_feels.across_m = 0.05;
  s.vehicle.accelerometer_feels.across_m = -0.02;
  const Watched w = watch(s);
  const double from_s = w.liftoff_s + 0.1;
  EXPECT_NEAR(w.mean(from_s, w.burnout_s,
                     [&](const Seen& seen) { return w.imu_scale.specific_force_m_s2 * seen.imu.specific_force[1]; }),
              -5.0, 0.05);
  EXPECT_NEAR(
      w.mean(from_s, w.burnout_s,
             [&](const Seen& seen) { return w.accelerometer_scale_m_s2 * seen.accelerometer.specific_force[1]; }),
      2.0, 0.05);
}

// The rates that shake a sensor are its own, and carry nothing round the arm to the centre of gravity: a shaking of 500
// deg/s about each axis would else pull at a sensor 50 mm off the axis with 2 0.05 (8.7 rad/s)^2 = 7.6 m/s2 all along.
TEST(WorldSensors, AreNotPulledByVibration) {
  Scenario s = flight_without_authority();
  s.vehicle.imu_feels.across_m = 0.05;
  const Watched still = watch(s);
  s.vehicle.vibration.rate_rad_s = 500.0 * degree;
  const Watched shaken = watch(s);
  const auto across = [&](const Seen& seen) {
    return still.imu_scale.specific_force_m_s2 * seen.imu.specific_force[1];
  };
  EXPECT_NEAR(shaken.mean(0.1, still.burnout_s, across), still.mean(0.1, still.burnout_s, across), 0.01);
}

TEST(WorldSensors, AreShakenFromIgnitionOnToo) {
  Scenario s = scenario("tasha3_launch2", {"body.mass_kg=100"});  // never lifts off
  s.vehicle.vibration.specific_force_m_s2 = 20.0;
  const Watched w = watch(s);
  const auto square = [&](const Seen& seen) {
    return std::pow(w.imu_scale.specific_force_m_s2 * seen.imu.specific_force[1], 2);
  };
  EXPECT_NEAR(std::sqrt(w.mean(0.1, w.burnout_s, square)), 20.0, 3.0);
  EXPECT_LT(std::sqrt(w.mean(-1.0, 0.0, square)), 0.5);
  EXPECT_LT(std::sqrt(w.mean(w.burnout_s + 0.1, w.burnout_s + 1.0, square)), 0.5);
}

TEST(WorldSensors, HaveVibrationOfAStreamOfItsOwnSoThatNoNoiseShifts) {
  Scenario s = flight_without_authority();
  const Watched still = watch(s);
  s.vehicle.vibration = {.specific_force_m_s2 = 20.0, .rate_rad_s = 10.0 * degree, .frequency_hz = 120.0};
  const Watched shaken = watch(s);
  ASSERT_EQ(still.ticks.size(), shaken.ticks.size());
  std::size_t differ = 0;
  for (std::size_t i = 0; i < still.ticks.size(); ++i) {
    const Seen& one = still.ticks[i];
    const Seen& other = shaken.ticks[i];
    if (one.from_ignition_s > 0.0 && one.from_ignition_s <= still.burnout_s) {
      differ += one.imu.rate != other.imu.rate ? 1U : 0U;
    } else {
      ASSERT_EQ(one.imu.rate, other.imu.rate) << one.from_ignition_s;
      ASSERT_EQ(one.imu.specific_force, other.imu.specific_force) << one.from_ignition_s;
      ASSERT_EQ(one.accelerometer.specific_force, other.accelerometer.specific_force) << one.from_ignition_s;
    }
  }
  EXPECT_GT(differ, 1000U);
}

}  // namespace
}  // namespace fantail::sim
