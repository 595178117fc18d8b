// SPDX-License-Identifier: MIT

#include "avionics/sensor_scaling.hpp"
#include "sim/sensor_models.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double count_rad = 2.0 * std::numbers::pi / 16384.0;
constexpr std::uint64_t seed = 9;

TEST(EncoderModel, CountsSixteenThousandThreeHundredAndEightyFourATurn) {
  EncoderModel encoder{{}, {.noise_counts = 0.0}, {seed, 0}};
  const hal::EncoderReading reading =
      encoder.sample(hal::Microseconds{7}, {0.0, count_rad, 100.4 * count_rad, 100.6 * count_rad});
  EXPECT_EQ(reading.time.count(), 7);
  EXPECT_EQ(reading.each[0].counts, 0);
  EXPECT_EQ(reading.each[1].counts, 1);
  EXPECT_EQ(reading.each[2].counts, 100);
  EXPECT_EQ(reading.each[3].counts, 101);
  for (const hal::EncoderSample& each : reading.each) {
    EXPECT_EQ(each.status, hal::Status::ok);
  }
}

TEST(EncoderModel, ACoarserOneReadsTheNearestOfItsSteps) {
  EncoderModel encoder{{}, {.noise_counts = 0.0, .resolution_bits = 10}, {seed, 0}};  // 16 counts a step
  const auto counts = [&](double count) {
    const double angle_rad = count * 2.0 * std::numbers::pi / 16384.0;
    return encoder.sample(hal::Microseconds{0}, {angle_rad, 0.0, 0.0, 0.0}).each[0].counts;
  };
  EXPECT_EQ(counts(7.9), 0);
  EXPECT_EQ(counts(8.1), 16);
  EXPECT_EQ(counts(1000.0), 1008);  // 62.5 steps, rounded up
  EXPECT_EQ(counts(-7.9), 0);
  EXPECT_EQ(counts(-8.1), 16368);
}

TEST(EncoderModel, NegativeAnglesAndWholeTurnsWrap) {
  EncoderModel encoder{{}, {.noise_counts = 0.0}, {seed, 0}};
  const hal::EncoderReading reading =
      encoder.sample({}, {-count_rad, -0.4 * count_rad, -0.6 * count_rad, 2.0 * std::numbers::pi});
  EXPECT_EQ(reading.each[0].counts, 16383);
  EXPECT_EQ(reading.each[1].counts, 0);
  EXPECT_EQ(reading.each[2].counts, 16383);
  EXPECT_EQ(reading.each[3].counts, 0);
}

TEST(EncoderModel, NoiseHasTheGivenStandardDeviationInCounts) {
  EncoderModel encoder{{}, {.noise_counts = 3.0}, {seed, 0}};
  double sum = 0.0;
  double squares = 0.0;
  constexpr double ticks = 100'000;
  for (int tick = 0; tick < static_cast<int>(ticks); ++tick) {
    for (const hal::EncoderSample& each : encoder.sample({}, {1.0, 1.0, 1.0, 1.0}).each) {
      const double error = each.counts - 1.0 / count_rad;
      sum += error;
      squares += error * error;
    }
  }
  // Rounding adds a twelfth of a count squared.
  const double n = 4.0 * ticks;
  EXPECT_NEAR(sum / n, 0.0, 4.0 * 3.0 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 9.0 + 1.0 / 12.0, 4.0 * 9.0 * std::sqrt(2.0 / n));
}

TEST(EncoderModel, ANoisyEncoderHasItsOwnStandardDeviationAndTheOthersKeepTheirs) {
  EncoderModel whole{{}, {.noise_counts = 2.0}, {seed, 0}};
  EncoderModel broken{{}, {.noise_counts = 2.0}, {seed, 0}};
  broken.set_noise(2, 60.0);
  double squares = 0.0;
  constexpr int ticks = 100'000;
  for (int tick = 0; tick < ticks; ++tick) {
    const std::array<double, 4> angles{1.0, 1.0, 1.0, 1.0};
    const hal::EncoderReading expected = whole.sample({}, angles);
    const hal::EncoderReading reading = broken.sample({}, angles);
    for (const std::size_t i : {0U, 1U, 3U}) {
      ASSERT_EQ(reading.each[i].counts, expected.each[i].counts);
    }
    const double error = reading.each[2].counts - 1.0 / count_rad;
    squares += error * error;
  }
  EXPECT_NEAR(squares / ticks, 3600.0 + 1.0 / 12.0, 4.0 * 3600.0 * std::sqrt(2.0 / ticks));
  EXPECT_THROW(broken.set_noise(0, -1.0), std::invalid_argument);
  EXPECT_THROW(broken.set_noise(0, 1001.0), std::invalid_argument);
  EXPECT_THROW(broken.set_noise(0, std::nan("")), std::invalid_argument);
}

// What the firmware understands, when its plan knows the zeros, is the angle of the shaft, in size and in sign.
TEST(EncoderModel, TheFirmwareReadsTheShaftAngleBackWithinHalfACount) {
  const std::array<double, 4> zeros_deg{0.0, 170.0, -170.0, -35.5};
  std::array<double, 4> zeros_rad{};
  core::CanardsPlan plan{};
  for (std::size_t i = 0; i < 4; ++i) {
    zeros_rad[i] = zeros_deg[i] * radians_per_degree;
    plan.each[i].encoder_zero = core::Angle::from_degrees(static_cast<float>(zeros_deg[i]));
  }
  EncoderModel encoder{zeros_rad, {.noise_counts = 0.0}, {seed, 0}};
  for (double angle_deg = -90.0; angle_deg <= 90.0; angle_deg += 0.37) {
    const double angle_rad = angle_deg * radians_per_degree;
    const auto angles =
        avionics::encoder_angles(encoder.sample({}, {angle_rad, angle_rad, angle_rad, -angle_rad}), plan);
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(angles[i]);
      EXPECT_NEAR(angles[i]->radians(), i == 3 ? -angle_rad : angle_rad, 0.5 * count_rad + 2e-6) << angle_deg;
    }
  }
}

TEST(EncoderModel, RefusesNoiseAndZerosThatCannotBe) {
  EXPECT_THROW((EncoderModel{{}, {.noise_counts = -1.0}, {seed, 0}}), std::invalid_argument);
  EXPECT_THROW((EncoderModel{{}, {.noise_counts = std::nan("")}, {seed, 0}}), std::invalid_argument);
  EXPECT_THROW((EncoderModel{{}, {.resolution_bits = 15}, {seed, 0}}), std::invalid_argument);
  EXPECT_THROW((EncoderModel{{}, {.resolution_bits = 3}, {seed, 0}}), std::invalid_argument);
  EXPECT_THROW((EncoderModel{{0.0, 7.0, 0.0, 0.0}, {}, {seed, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace fantail::sim
