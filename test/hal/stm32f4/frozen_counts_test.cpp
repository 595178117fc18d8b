// SPDX-License-Identifier: MIT
#include "hal/stm32f4/frozen_counts.hpp"

#include "noisy_counts.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::LowPassedNoise;

constexpr FrozenCounts::Limits gyro_limits{.one_axis = 200, .three_axes = 64};
constexpr FrozenCounts::Limits accelerometer_limits{.one_axis = 64, .three_axes = 20};
constexpr int all_six_axes = 12;
constexpr FrozenCounts::Limits second_limits{.one_axis = 1'100, .three_axes = 110};

// DS-000347 sections 3.1 and 3.2: 0.0028 deg/s/sqrt(Hz) and 65 ug/sqrt(Hz), in the 1.11 * 258 Hz that a second-order
// low-pass lets through; 2000 deg/s and 16 g are 32768 counts.
constexpr double imu_cutoff_hz = 258.0;
const double gyro_counts = 0.0028 * std::sqrt(1.11 * imu_cutoff_hz) * 32768.0 / 2000.0;
const double accelerometer_counts = 65e-6 * std::sqrt(1.11 * imu_cutoff_hz) * 32768.0 / 16.0;
constexpr double second_cutoff_hz = 1600.0 / 9.0;

/// The probability that a long run of equal counts grows by one, with the true value in the middle of a count, where it
/// is largest: of many that have stayed so far, the part that stays.
double growth(double noise_counts, double cutoff_hz) {
  constexpr std::size_t many = 20'000;
  LowPassedNoise noise{cutoff_hz, 1};
  std::vector<LowPassedNoise::State> states(many);
  for (auto& state : states) {
    state = noise.begin();
  }
  double sum = 0.0;
  constexpr int steps = 30, settled = 10;
  for (int step = 0; step < steps; ++step) {
    std::vector<LowPassedNoise::State> staying;
    for (const auto& state : states) {
      if (std::abs(state.value) * noise_counts < 0.5) {
        staying.push_back(state);
      }
    }
    sum += step < settled ? 0.0 : std::log(static_cast<double>(staying.size()) / many);
    std::uniform_int_distribution<std::size_t> any{0, staying.size() - 1};
    for (auto& state : states) {
      state = noise.after(staying[any(noise.random())]);
    }
  }
  return std::exp(sum / (steps - settled));
}

/// False alarms in an hour at 1 kHz, of an axis or of so many together. Each sample may begin a run.
double per_hour(double growth_of_a_run, int limit, int groups) {
  return 3.6e6 * groups * std::pow(growth_of_a_run, limit);
}

TEST(FrozenCounts, TheLimitsOfTheImuHoldWithHalfOfTheNoiseOfItsDataSheet) {
  EXPECT_NEAR(gyro_counts, 0.776, 0.001);
  EXPECT_NEAR(accelerometer_counts, 2.253, 0.001);
  EXPECT_NEAR(growth(gyro_counts, imu_cutoff_hz), 0.52, 0.01);
  EXPECT_NEAR(growth(gyro_counts / 4, imu_cutoff_hz), 0.99, 0.005);
  const double gyro = growth(gyro_counts / 2, imu_cutoff_hz);
  const double accelerometer = growth(accelerometer_counts / 2, imu_cutoff_hz);
  EXPECT_NEAR(gyro, 0.826, 0.005);
  EXPECT_NEAR(accelerometer, 0.379, 0.01);
  const double each_hour = per_hour(gyro, gyro_limits.one_axis, 3) +
                           per_hour(std::pow(gyro, 3), gyro_limits.three_axes, 1) +
                           per_hour(accelerometer, accelerometer_limits.one_axis, 3) +
                           per_hour(std::pow(accelerometer, 3), accelerometer_limits.three_axes, 1) +
                           per_hour(std::pow(gyro * accelerometer, 3), all_six_axes, 1);
  EXPECT_LT(each_hour, 1e-9);
}

TEST(FrozenCounts, TheLimitsOfTheSecondAccelerometerHoldWithAQuarterAndAThirdOfACount) {
  EXPECT_LT(per_hour(growth(0.25, second_cutoff_hz), second_limits.one_axis, 3), 1e-9);
  EXPECT_LT(per_hour(std::pow(growth(0.35, second_cutoff_hz), 3), second_limits.three_axes, 1), 1e-9);
}

TEST(FrozenCounts, TenMinutesOnThePadWithHalfOfTheNoiseAreNoFreeze) {
  LowPassedNoise noise{imu_cutoff_hz, 7};
  std::array<LowPassedNoise::State, 3> states{noise.begin(), noise.begin(), noise.begin()};
  FrozenCounts frozen{gyro_limits};
  for (int i = 0; i < 600'000; ++i) {
    Counts counts{};
    for (std::size_t axis = 0; axis < counts.size(); ++axis) {
      states[axis] = noise.after(states[axis]);
      counts[axis] = static_cast<std::int16_t>(std::lround(states[axis].value * gyro_counts / 2));
    }
    ASSERT_FALSE(frozen.update(counts)) << i;
  }
}

/// Counts that move on every axis.
Counts moving(int i) {
  const auto count = static_cast<std::int16_t>(i % 2);
  return {count, static_cast<std::int16_t>(7 + count), static_cast<std::int16_t>(-3 - count)};
}

TEST(FrozenCounts, AnAxisThatStandsStillIsFoundWhateverTheOthersDo) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    FrozenCounts frozen{gyro_limits};
    for (int i = 0; i <= 200; ++i) {
      EXPECT_FALSE(frozen.frozen());
      Counts counts = moving(i);
      counts[axis] = 5;
      EXPECT_EQ(frozen.update(counts), i == 200);
    }
    EXPECT_TRUE(frozen.frozen());
  }
}

TEST(FrozenCounts, ThreeAxesThatStandStillAreFoundSooner) {
  FrozenCounts frozen{gyro_limits};
  for (int i = 0; i <= 64; ++i) {
    EXPECT_FALSE(frozen.frozen());
    EXPECT_EQ(frozen.update({1, 2, 3}), i == 64);
    EXPECT_EQ(frozen.repeated(), i > 0);
  }
  EXPECT_TRUE(frozen.frozen());
}

TEST(FrozenCounts, AnAxisIsBelievedAgainWhenItHasMovedTenTimes) {
  FrozenCounts frozen{gyro_limits};
  for (int i = 0; i <= 64; ++i) {
    static_cast<void>(frozen.update({10, 10, 10}));
  }
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(frozen.frozen());
    static_cast<void>(frozen.update(moving(i)));
  }
  EXPECT_FALSE(frozen.frozen());
}

TEST(FrozenCounts, OneJumpFromOneStandingValueToAnotherIsNoMotion) {
  FrozenCounts frozen{gyro_limits};
  for (int i = 0; i < 1'000; ++i) {
    const auto count = static_cast<std::int16_t>(1 + i / 120);
    static_cast<void>(frozen.update({count, count, count}));
    EXPECT_EQ(frozen.frozen(), i >= 64);
  }
}

TEST(FrozenCounts, TheEndOfTheRangeIsNoFreeze) {
  FrozenCounts frozen{gyro_limits};
  for (const std::int16_t end : {std::int16_t{32767}, std::int16_t{-32768}}) {
    for (int i = 0; i < 10'000; ++i) {
      Counts counts = moving(i);
      counts[0] = end;
      EXPECT_FALSE(frozen.update(counts));
      EXPECT_FALSE(frozen.update({end, end, end}));
    }
  }
}

}  // namespace
}  // namespace fantail::hal::stm32f4
