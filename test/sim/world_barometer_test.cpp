// SPDX-License-Identifier: MIT
// The barometer of a flight: what it makes of the truth, its faults, and that nothing else changes with it.

#include "flown_world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double wrong_from_s = 2.0;
constexpr double wrong_until_s = 2.5;

struct Instant {
  double time_s;  ///< after ignition
  core::Microseconds now;
  Truth truth;
  hal::sim::WorldSide hardware;
  bool is_down;
  [[nodiscard]] const hal::BarometerSample& sample() const { return hardware.barometer; }
  [[nodiscard]] bool in_fault() const { return time_s > wrong_from_s - 1e-6 && time_s < wrong_until_s - 1e-6; }
};

std::vector<Instant> watch_barometer(const Scenario& scenario) {
  World world{scenario};
  std::vector<Instant> all;
  while (!world.over()) {
    world.tick();
    all.push_back({1e-6 * static_cast<double>(world.now().count()) - scenario.pad_time_s, world.now(), world.truth(),
                   world.hardware(), world.is_down()});
    world.advance();
  }
  return all;
}

Scenario with_barometer(std::vector<std::string> changes = {}, const std::string& name = "tasha3_launch2") {
  changes.emplace_back("barometer.fitted=yes");
  return scenario(name, changes);
}

/// No error of its own.
Scenario with_ideal_barometer(std::vector<std::string> changes = {}) {
  changes.insert(changes.begin(), {"barometer.noise_pa=0", "barometer.port_error=0", "barometer.vent_lag_s=0"});
  return with_barometer(std::move(changes));
}

std::vector<Instant> watch_fault(Behaviour behaviour, double on_s = 0.0, double off_s = 0.0) {
  Scenario s = with_ideal_barometer({"barometer.noise_pa=1.5"});
  s.faults = {{.device = Device::barometer,
               .how = behaviour,
               .from_s = wrong_from_s,
               .until_s = wrong_until_s,
               .on_s = on_s,
               .off_s = off_s}};
  return watch_barometer(s);
}

double true_pressure_pa(const std::vector<Instant>& all, std::size_t ticks_ago, std::size_t i) {
  return Atmosphere{}.pressure_pa(all[i - ticks_ago].truth.height_m);
}

TEST(WorldBarometer, ReadsTheAirOfTheTrueHeightFiveMillisecondsAgo) {
  const std::vector<Instant> all = watch_barometer(with_ideal_barometer());
  double least_pa = 1e9;
  for (std::size_t i = 10; i < all.size(); i += 10) {
    ASSERT_EQ(all[i].sample().status, hal::Status::ok);
    ASSERT_EQ(all[i].sample().time, all[i].now - core::Microseconds{5'000});
    ASSERT_NEAR(all[i].sample().pressure_pa, true_pressure_pa(all, 5, i), 0.51) << all[i].time_s;
    least_pa = std::min(least_pa, static_cast<double>(all[i].sample().pressure_pa));
  }
  EXPECT_NEAR(least_pa, Atmosphere{}.pressure_pa(422.0), 30.0);  // its apogee
}

TEST(WorldBarometer, KnowsElevationAndAirTemperatureOfTheSite) {
  const std::vector<Instant> all =
      watch_barometer(with_ideal_barometer({"environment.site_elevation_m=1400", "environment.air_temperature_c=-10"}));
  const Atmosphere air{.elevation_m = 1400.0, .air_temperature_c = -10.0};
  for (std::size_t i = 10; i < all.size(); i += 10) {
    ASSERT_NEAR(all[i].sample().pressure_pa, air.pressure_pa(all[i - 5].truth.height_m), 0.51) << all[i].time_s;
  }
}

TEST(WorldBarometer, HasThePortErrorOfTheSpeedThatItFliesAt) {
  const std::vector<Instant> all = watch_barometer(with_ideal_barometer({"barometer.port_error=-0.2"}));
  double largest_pa = 0.0;
  for (std::size_t i = 10; i < all.size(); i += 10) {
    const Truth& then = all[i - 5].truth;
    const double error_pa = -0.2 * 0.5 * Atmosphere{}.density_kg_m3(then.height_m) * then.speed_m_s * then.speed_m_s;
    ASSERT_NEAR(all[i].sample().pressure_pa, true_pressure_pa(all, 5, i) + error_pa, 0.52) << all[i].time_s;
    largest_pa = std::max(largest_pa, std::abs(error_pa));
  }
  EXPECT_GT(largest_pa, 500.0);
}

TEST(WorldBarometer, ThatIsNotFittedIsSilent) {
  for (const Instant& instant : watch_barometer(scenario("tasha3_launch2"))) {
    ASSERT_FALSE(instant.hardware.barometer_is_fitted);
    ASSERT_EQ(instant.sample().status, hal::Status::no_reading);
  }
}

TEST(WorldBarometer, ChangesNoBitOfWhatAnyOtherDeviceShowsOrOfTheFlight) {
  const std::vector<Instant> with = watch_barometer(with_barometer({"environment.air_temperature_c=-20"}));
  const std::vector<Instant> without = watch_barometer(scenario("tasha3_launch2"));
  ASSERT_EQ(with.size(), without.size());
  for (std::size_t i = 0; i < with.size(); ++i) {
    const hal::sim::WorldSide& a = with[i].hardware;
    const hal::sim::WorldSide& b = without[i].hardware;
    ASSERT_EQ(a.imu.rate, b.imu.rate);
    ASSERT_EQ(a.imu.specific_force, b.imu.specific_force);
    ASSERT_EQ(a.accelerometer.specific_force, b.accelerometer.specific_force);
    for (std::size_t canard = 0; canard < hal::canards; ++canard) {
      ASSERT_EQ(a.encoders.each[canard].counts, b.encoders.each[canard].counts);
    }
    ASSERT_EQ(a.pulses, b.pulses);
    ASSERT_EQ(with[i].truth.roll_angle_rad, without[i].truth.roll_angle_rad);
    ASSERT_EQ(with[i].truth.height_m, without[i].truth.height_m);
  }
}

TEST(WorldBarometer, FeelsTheEjectionChargeWhereTheRocketHasARecovery) {
  const Scenario s = with_barometer({"timing.time_after_end_s=5"}, "kestrel");
  ASSERT_TRUE(s.vehicle.recovery.has_value());
  World world{s};
  std::vector<std::pair<core::Microseconds, double>> shown;
  while (!world.over()) {
    world.tick();
    shown.emplace_back(world.now(), world.hardware().barometer.pressure_pa);
    world.advance();
  }
  ASSERT_TRUE(world.events().parachute.has_value());
  const auto mean_pa = [&](int from_ms, int until_ms) {
    double sum = 0.0;
    int count = 0;
    for (const auto& [now, pressure_pa] : shown) {
      const core::Microseconds since = now - *world.events().parachute;
      if (since > core::Microseconds{1000 * from_ms} && since < core::Microseconds{1000 * until_ms}) {
        sum += pressure_pa;
        ++count;
      }
    }
    EXPECT_GT(count, 0);
    return sum / count;
  };
  const double before_pa = mean_pa(-100, 0);
  EXPECT_GT(mean_pa(14, 20), before_pa + 2000.0);
  EXPECT_NEAR(mean_pa(60, 160), before_pa, 50.0);
}

TEST(WorldBarometer, ThatIsDeadSaysNothingAndIsAsBeforeAfterwards) {
  for (const Instant& instant : watch_fault(Behaviour::dead)) {
    if (instant.time_s > 0.0) {
      ASSERT_EQ(instant.sample().status == hal::Status::no_reading, instant.in_fault()) << instant.time_s;
    }
  }
}

TEST(WorldBarometer, ThatIsStuckRepeatsItsPressureWithNewTimes) {
  const std::vector<Instant> all = watch_fault(Behaviour::stuck);
  std::set<core::Microseconds> times;
  std::set<std::uint32_t> pressures;
  for (const Instant& instant : all) {
    if (instant.in_fault()) {
      times.insert(instant.sample().time);
      pressures.insert(instant.sample().pressure_pa);
      ASSERT_EQ(instant.sample().status, hal::Status::ok);
    }
  }
  EXPECT_GE(times.size(), 50U);
  EXPECT_EQ(pressures.size(), 1U);
}

TEST(WorldBarometer, ThatHangsHasNoNewSample) {
  std::set<core::Microseconds> times;
  for (const Instant& instant : watch_fault(Behaviour::hangs)) {
    if (instant.in_fault()) {
      times.insert(instant.sample().time);
      ASSERT_EQ(instant.sample().status, hal::Status::ok);
    }
  }
  EXPECT_EQ(times.size(), 1U);
}

TEST(WorldBarometer, OfGarbageShowsAnotherPossiblePressureWithEachNewSampleAndTheSameWithTheSameSeed) {
  const std::vector<Instant> all = watch_fault(Behaviour::garbage);
  std::map<core::Microseconds, std::set<std::uint32_t>> by_time;
  for (const Instant& instant : all) {
    if (instant.in_fault() && instant.sample().time > instant.now - core::Microseconds{15'000} &&
        instant.time_s > wrong_from_s + 0.01) {
      by_time[instant.sample().time].insert(instant.sample().pressure_pa);
    }
  }
  std::uint32_t lowest = 200'000;
  std::uint32_t highest = 0;
  for (const auto& [time, pressures] : by_time) {
    ASSERT_EQ(pressures.size(), 1U);
    lowest = std::min(lowest, *pressures.begin());
    highest = std::max(highest, *pressures.begin());
  }
  EXPECT_GE(by_time.size(), 49U);
  EXPECT_GE(lowest, 30'000U);
  EXPECT_LT(lowest, 50'000U);
  EXPECT_GT(highest, 90'000U);
  EXPECT_LT(highest, 110'000U);
  const std::vector<Instant> again = watch_fault(Behaviour::garbage);
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_EQ(again[i].sample().pressure_pa, all[i].sample().pressure_pa);
  }
}

TEST(WorldBarometer, WithBlockedPortsKeepsThePressureOfTheMoment) {
  const std::vector<Instant> all = watch_fault(Behaviour::blocked);
  double blocked_at_pa = 0.0;
  for (std::size_t i = 10; i < all.size(); ++i) {
    if (!all[i - 1].in_fault() && all[i].in_fault()) {
      blocked_at_pa = true_pressure_pa(all, 1, i);
    }
    if (all[i].time_s > wrong_from_s + 0.01 && all[i].in_fault()) {
      ASSERT_NEAR(all[i].sample().pressure_pa, blocked_at_pa, 8.0) << all[i].time_s;
    }
  }
  const std::size_t end = all.size() / 10 * 10 - 10;
  EXPECT_NEAR(all[end].sample().pressure_pa, true_pressure_pa(all, 5, end), 8.0);
}

TEST(WorldBarometer, ThatIsLitReadsTooHighWhileTheLightLastsAndComesAndGoesWithIt) {
  const std::vector<Instant> all = watch_fault(Behaviour::lit, 0.1, 0.1);
  std::size_t lit_samples = 0;
  for (std::size_t i = 10; i < all.size(); i += 10) {
    const double measured_s = all[i].time_s - 0.005;
    const bool lit =
        measured_s > wrong_from_s && measured_s < wrong_until_s && std::fmod(measured_s - wrong_from_s, 0.2) < 0.1;
    ASSERT_NEAR(all[i].sample().pressure_pa, true_pressure_pa(all, 5, i) - (lit ? 1500.0 : 0.0), 8.0) << measured_s;
    lit_samples += lit ? 1U : 0U;
  }
  EXPECT_EQ(lit_samples, 30U);
}

// A clock that the avionics takes for 0.1 s ahead.
TEST(WorldBarometer, IsOnTheClockOfTheBoardAfterAReset) {
  Scenario s = with_barometer();
  s.faults = {{.device = Device::processor, .how = Reset{.gap_s = 0.06, .clock_error_s = 0.1}, .from_s = wrong_from_s}};
  const std::vector<Instant> all = watch_barometer(s);
  std::size_t after = 0;
  for (const Instant& instant : all) {
    if (instant.is_down || instant.time_s < 0.0) {
      continue;
    }
    const core::Microseconds old = instant.hardware.time - instant.sample().time;
    ASSERT_GE(old, core::Microseconds{5'000}) << instant.time_s;
    ASSERT_LT(old, core::Microseconds{15'000}) << instant.time_s;
    after += instant.hardware.time - instant.now > core::Microseconds{99'000} ? 1U : 0U;
  }
  EXPECT_GT(after, 1000U);
}

}  // namespace
}  // namespace fantail::sim
