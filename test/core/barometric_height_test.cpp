// SPDX-License-Identifier: MIT
#include "core/barometric_height.hpp"

#include <cmath>

#include "core/flight_plan_fields.hpp"
#include "core/pressure_height.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace std::chrono_literals;

constexpr float pad_pa = 101'325.0F;

/// Pressure at a height of the standard atmosphere whose temperature at the pad is another one, in double precision.
double pressure_at(double height_m, double pad_temperature_k = 288.15) {
  return static_cast<double>(pad_pa) *
         std::pow(1.0 - 0.0065 * height_m / pad_temperature_k, 9.80665 / (287.053 * 0.0065));
}

/// A rocket that goes straight up, its accelerometer, and a barometer that has something new every 10 ms.
struct Climb {
  FlightPlan plan = default_plan();
  BarometricHeight height{plan.sensors, plan.dormancy};
  Microseconds now{};
  Motion motion{};
  double pad_temperature_k = 288.15;

  Climb() {
    motion.accelerometer = SensorState::fresh;
    motion.at_rest_for = 1s;
    for (int i = 0; i < 500; ++i) {
      tick(false, pad_pa);
    }
    motion.at_rest_for = Microseconds{0};
    motion.thrust_since = now;
    height.begin_flight();
  }
  void tick(bool flies, std::optional<double> pressure_pa) {
    now += 10ms;
    Inputs inputs{};
    inputs.time = now;
    if (pressure_pa) {
      inputs.barometer = PressureSample{.time = now - 5ms, .pressure_pa = static_cast<float>(*pressure_pa)};
    }
    height.update(inputs, flies, motion);
  }
  /// At a steady speed, for so long. The accelerometer believes `off_m` more than the truth, the barometer reads
  /// `more_pa` more.
  void climb(double for_s, double speed_m_s, double off_m = 0.0, double more_pa = 0.0) {
    for (int i = 0; i < static_cast<int>(for_s * 100.0); ++i) {
      true_m += 0.01 * speed_m_s;
      motion.height_m = static_cast<float>(true_m + off_m);
      motion.vertical_speed_m_s = static_cast<float>(speed_m_s);
      motion.speed_squared_m2_s2 = static_cast<float>(speed_m_s * speed_m_s);
      tick(true, pressure_at(true_m - 0.005 * speed_m_s, pad_temperature_k) + more_pa);
    }
  }
  [[nodiscard]] double corrected_m() const {
    Motion both = motion;
    height.correct(both);
    return static_cast<double>(both.height_m);
  }
  double true_m = 0.0;
};

// The standard atmosphere's own table (ISO 2533): 89 875, 70 109, 54 020 and 26 436 Pa.
TEST(BarometricHeight, OfAPressureIsThatOfTheStandardAtmosphere) {
  for (const auto& [pressure_pa, height_m] :
       {std::pair{89'875.0F, 1'000.0F}, {70'109.0F, 3'000.0F}, {54'020.0F, 5'000.0F}, {26'436.0F, 10'000.0F}}) {
    EXPECT_NEAR(pressure_height_m(pressure_pa / pad_pa, 288.15F), height_m, 0.001F * height_m);
  }
  EXPECT_EQ(pressure_height_m(1.0F, 288.15F), 0.0F);
  EXPECT_NEAR(pressure_height_m(static_cast<float>(pressure_at(8.0)) / pad_pa, 288.15F), 8.0F, 0.1F);
}

TEST(BarometricHeight, ScalesWithTheTemperatureOfThePad) {
  const float standard_m = pressure_height_m(0.7F, 288.15F);
  EXPECT_NEAR(pressure_height_m(0.7F, 0.9F * 288.15F), 0.9F * standard_m, 0.1F);
}

// Over the first ten seconds the accelerometer may be wrong by 1 % and 60 mg: 7 m and 29 m of 50 g s2. It is by 20 m.
TEST(BarometricHeight, TakesTheAccelerometersErrorAway) {
  Climb flight;
  flight.climb(10.0, 30.0);
  flight.climb(10.0, 30.0, 20.0);
  EXPECT_EQ(flight.height.state(), BarometerState::used);
  EXPECT_NEAR(flight.corrected_m(), flight.true_m, 1.5);
}

TEST(BarometricHeight, MovesNothingByMoreThanTheAccelerometerMayBeWrong) {
  Climb flight;
  for (int i = 0; i < 60; ++i) {
    flight.climb(0.25, 40.0, 0.0, -12.0 * i / 4.0);  // a metre is 12 Pa: it drifts up by 1 m/s
    const MotionError most = motion_error(flight.plan.dormancy, flight.now, flight.motion);
    Motion both = flight.motion;
    flight.height.correct(both);
    EXPECT_LE(std::abs(both.height_m - flight.motion.height_m), most.height_m + 0.001F);
    EXPECT_LE(std::abs(both.vertical_speed_m_s - flight.motion.vertical_speed_m_s), most.vertical_speed_m_s + 0.001F);
  }
}

TEST(BarometricHeight, IsNotUsedWhileTheRocketIsFasterThan100MetresASecond) {
  Climb flight;
  flight.climb(2.0, 99.0);
  EXPECT_EQ(flight.height.state(), BarometerState::used);
  const double added_m = flight.corrected_m() - static_cast<double>(flight.motion.height_m);
  flight.climb(2.0, 101.0, 0.0, 5'000.0);  // Mach shock on the ports, too
  EXPECT_EQ(flight.height.state(), BarometerState::too_fast);
  EXPECT_FALSE(flight.height.least_height_m());
  EXPECT_NEAR(flight.corrected_m() - static_cast<double>(flight.motion.height_m), added_m, 1e-3);
  flight.climb(0.4, 60.0);
  EXPECT_EQ(flight.height.state(), BarometerState::too_fast) << "half a second";
  flight.climb(0.2, 60.0);
  EXPECT_EQ(flight.height.state(), BarometerState::used);
}

// Each by what field reports tell: a port that is blocked or a device that stands still; an ejection charge; sunlight,
// which reads as 125 m more.
TEST(BarometricHeight, OneThatLiesIsNotUsed) {
  Climb blocked;
  for (int i = 0; i < 300; ++i) {
    blocked.motion.height_m = 0.5F * static_cast<float>(i);
    blocked.motion.vertical_speed_m_s = 50.0F;
    blocked.motion.speed_squared_m2_s2 = 2'500.0F;
    blocked.tick(true, pad_pa);
  }
  EXPECT_EQ(blocked.height.state(), BarometerState::disagrees);
  EXPECT_FLOAT_EQ(static_cast<float>(blocked.corrected_m()), blocked.motion.height_m);
  for (const double more_pa : {5'000.0, -1'500.0}) {
    Climb flight;
    flight.climb(4.0, 60.0);
    ASSERT_EQ(flight.height.state(), BarometerState::used);
    flight.climb(0.03, 60.0, 0.0, more_pa);
    EXPECT_EQ(flight.height.state(), BarometerState::disagrees);
    EXPECT_FALSE(flight.height.least_height_m());
    flight.climb(0.6, 60.0);
    EXPECT_EQ(flight.height.state(), BarometerState::used);
  }
}

TEST(BarometricHeight, OneThatFallsSilentIsNotUsed) {
  Climb flight;
  flight.climb(4.0, 60.0);
  for (int i = 0; i < 11; ++i) {
    flight.tick(true, std::nullopt);
  }
  EXPECT_EQ(flight.height.state(), BarometerState::silent);
  EXPECT_FALSE(flight.height.least_height_m());
}

TEST(BarometricHeight, AloneItCountsForNothing) {
  for (const bool failed : {true, false}) {
    Climb flight;
    flight.climb(4.0, 60.0, 5.0);
    flight.motion.accelerometer = failed ? SensorState::failed : SensorState::fresh;
    flight.motion.speed_is_lower_bound = !failed;
    flight.tick(true, pressure_at(flight.true_m));
    EXPECT_EQ(flight.height.state(), BarometerState::alone);
    EXPECT_FLOAT_EQ(static_cast<float>(flight.corrected_m()), flight.motion.height_m);
    EXPECT_FALSE(flight.height.least_height_m());
  }
}

TEST(BarometricHeight, WithoutThePressureOfThePadThereIsNothingToCompareWith) {
  const FlightPlan plan = default_plan();
  BarometricHeight height{plan.sensors, plan.dormancy};
  Motion motion{};
  motion.accelerometer = SensorState::fresh;
  Inputs inputs{};
  inputs.time = 1s;
  inputs.barometer = PressureSample{.time = 1s, .pressure_pa = 90'000.0F};
  height.update(inputs, true, motion);
  EXPECT_EQ(height.state(), BarometerState::silent);
}

// The gate opens by the low end: on any day within the plan's error of its temperature it is below the truth, and never
// above what the accelerometer has.
TEST(BarometricHeight, ItsLowEndIsBelowTheTruthOnTheColdestAndTheHottestDayThatThePlanAllows) {
  for (const double more_k : {-29.9, 0.0, 29.9}) {
    Climb flight;
    flight.pad_temperature_k += more_k;
    for (int i = 0; i < 100; ++i) {
      flight.climb(0.5, 60.0);
      const auto least_m = flight.height.least_height_m();
      if (least_m) {
        EXPECT_LT(static_cast<double>(*least_m), flight.true_m) << more_k;
        EXPECT_LE(*least_m, flight.motion.height_m) << more_k;
      }
    }
  }
}

TEST(BarometricHeight, APressureThatNoAirHasIsNoSample) {
  for (const float pressure_pa : {0.0F, 999.0F, 120'001.0F, std::nanf(""), INFINITY}) {
    Climb flight;
    flight.climb(4.0, 60.0);
    for (int i = 0; i < 11; ++i) {
      flight.tick(true, static_cast<double>(pressure_pa));
    }
    EXPECT_EQ(flight.height.state(), BarometerState::silent) << pressure_pa;
  }
}

}  // namespace
}  // namespace fantail::core
