// SPDX-License-Identifier: MIT

#include "avionics/mounting.hpp"
#include "avionics/sensor_scaling.hpp"
#include "sim/sensor_models.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr std::uint64_t seed = 11;

// No noise: what remains is exact.
InertialParameters quiet() {
  InertialParameters p;
  p.rate_noise_rad_s = 0.0;
  p.specific_force_noise_m_s2 = 0.0;
  return p;
}

hal::Microseconds milliseconds(int count) { return hal::Microseconds{count * 1000}; }

TEST(ImuModel, FullScaleIsThirtyTwoThousandSevenHundredAndSixtyEightCounts) {
  const ImuModel imu{quiet(), {seed, 0}};
  EXPECT_FLOAT_EQ(imu.scale().rate_rad_s, static_cast<float>(2000.0 * radians_per_degree / 32768.0));
  EXPECT_FLOAT_EQ(imu.scale().specific_force_m_s2, static_cast<float>(16.0 * gravity_m_s2 / 32768.0));
}

TEST(ImuModel, RoundsToTheNearestCountOnBothSidesOfZero) {
  ImuModel imu{quiet(), {seed, 0}};
  const double rate = 2000.0 * radians_per_degree / 32768.0;
  const double force = 16.0 * gravity_m_s2 / 32768.0;
  const hal::ImuSample sample = imu.sample(milliseconds(1), {10.4 * rate, 10.6 * rate, -10.4 * rate},
                                           {-10.6 * force, 0.49 * force, -0.49 * force}, false);
  EXPECT_EQ(sample.rate, (hal::Counts{10, 11, -10}));
  EXPECT_EQ(sample.specific_force, (hal::Counts{-11, 0, 0}));
  EXPECT_EQ(sample.status, hal::Status::ok);
  EXPECT_EQ(sample.time, milliseconds(1));
}

TEST(ImuModel, StaysAtTheEndOfItsRangeOnBothSides) {
  ImuModel imu{quiet(), {seed, 0}};
  const hal::ImuSample sample =
      imu.sample({}, {1e6, -1e6, 40.0}, {16.0 * gravity_m_s2, -16.1 * gravity_m_s2, 1e300}, false);
  EXPECT_EQ(sample.rate, (hal::Counts{32767, -32768, 32767}));
  EXPECT_EQ(sample.specific_force, (hal::Counts{32767, -32768, 32767}));
}

TEST(ImuModel, ANaNStandsAtAnEndSoThatNobodyTrustsIt) {
  ImuModel imu{quiet(), {seed, 0}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const hal::ImuSample sample = imu.sample({}, {nan, 0.0, 0.0}, {}, false);
  EXPECT_EQ(sample.rate[0], -32768);
  EXPECT_EQ(avionics::gyro_sample(sample, imu.scale()).quality, core::SampleQuality::invalid);
}

TEST(ImuModel, HoweverItIsMountedAPlanThatKnowsSeesTheSame) {
  using core::SensorAxis;
  const Vector3 rate{1.0, -2.0, 3.0};
  const Vector3 force{gravity_m_s2, 5.0, -7.0};
  InertialParameters parameters = quiet();
  const hal::ImuSample straight = ImuModel{parameters, {seed, 0}}.sample({}, rate, force, false);
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      if (x / 2 == y / 2) {
        continue;
      }
      parameters.mounting = {.to_nose = static_cast<SensorAxis>(x), .along_y = static_cast<SensorAxis>(y)};
      const hal::ImuSample sample = ImuModel{parameters, {seed, 0}}.sample({}, rate, force, false);
      EXPECT_EQ(sample.rate == straight.rate, x == 0 && y == 2);
      EXPECT_EQ(avionics::turned(sample, parameters.mounting).rate, straight.rate);
      EXPECT_EQ(avionics::turned(sample, parameters.mounting).specific_force, straight.specific_force);
    }
  }
}

TEST(ImuModel, BiasShiftsEveryAxis) {
  InertialParameters p = quiet();
  p.rate_bias_rad_s = 3.0 * radians_per_degree;
  p.specific_force_bias_m_s2 = -0.5;
  ImuModel imu{p, {seed, 0}};
  const hal::ImuSample sample = imu.sample({}, {}, {}, false);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(sample.rate[axis] * 2000.0 / 32768.0, 3.0, 0.5 * 2000.0 / 32768.0);
    EXPECT_NEAR(sample.specific_force[axis] * 16.0 * gravity_m_s2 / 32768.0, -0.5, 0.5 * 16.0 * gravity_m_s2 / 32768.0);
  }
}

TEST(ImuModel, NoiseIsWhiteWithTheGivenStandardDeviation) {
  ImuModel imu{{}, {seed, 0}};
  constexpr int ticks = 200'000;
  double rate_squares = 0.0;
  double force_squares = 0.0;
  double from_tick_to_tick = 0.0;
  double across = 0.0;
  double last = 0.0;
  for (int tick = 0; tick < ticks; ++tick) {
    const hal::ImuSample& sample = imu.sample(milliseconds(tick), {}, {}, false);
    const double rate = sample.rate[0] * (2000.0 / 32768.0) / 0.1;
    const double force = sample.specific_force[0] * (16.0 * gravity_m_s2 / 32768.0) / 0.3;
    rate_squares += rate * rate;
    force_squares += force * force;
    from_tick_to_tick += force * last;
    across += rate * force;
    last = force;
  }
  const double rounding = std::pow(2000.0 / 32768.0 / 0.1, 2) / 12.0;
  EXPECT_NEAR(rate_squares / ticks, 1.0 + rounding, 4.0 * std::sqrt(2.0 / ticks) * (1.0 + rounding));
  EXPECT_NEAR(force_squares / ticks, 1.0, 4.0 * std::sqrt(2.0 / ticks));
  EXPECT_NEAR(from_tick_to_tick / ticks, 0.0, 4.0 / std::sqrt(ticks));
  EXPECT_NEAR(across / ticks, 0.0, 4.0 * std::sqrt((1.0 + rounding) / ticks));
}

TEST(ImuModel, MisalignmentPutsTheSineOfItsAngleAcrossAndTheCosineAlong) {
  for (const double angle_deg : {0.0, 1.0, 10.0}) {
    InertialParameters p = quiet();
    p.misalignment_rad = angle_deg * radians_per_degree;
    for (std::uint64_t stream = 0; stream < 20; ++stream) {
      ImuModel imu{p, {seed, stream}};
      const double rate_rad_s = 30.0;
      const double force_m_s2 = 150.0;
      const hal::ImuSample sample = imu.sample({}, {rate_rad_s, 0.0, 0.0}, {force_m_s2, 0.0, 0.0}, false);
      const double rate = rate_rad_s / (2000.0 * radians_per_degree) * 32768.0;
      const double force = force_m_s2 / (16.0 * gravity_m_s2) * 32768.0;
      const double sine = std::sin(p.misalignment_rad);
      EXPECT_NEAR(sample.rate[0], rate * std::cos(p.misalignment_rad), 0.51);
      EXPECT_NEAR(std::hypot(sample.rate[1], sample.rate[2]), rate * sine, 0.75);
      EXPECT_NEAR(sample.specific_force[0], force * std::cos(p.misalignment_rad), 0.51);
      EXPECT_NEAR(std::hypot(sample.specific_force[1], sample.specific_force[2]), force * sine, 0.75);
      // One package: gyro and accelerometer are turned about the same axis.
      EXPECT_NEAR(sample.rate[1] / rate, sample.specific_force[1] / force, 1e-4);
    }
  }
}

TEST(ImuModel, MisalignmentIsARotation) {
  InertialParameters p = quiet();
  p.misalignment_rad = 0.17;
  ImuModel imu{p, {seed, 5}};
  const hal::ImuSample y = imu.sample({}, {}, {0.0, 150.0, 0.0}, false);
  const hal::ImuSample x = imu.sample({}, {}, {150.0, 0.0, 0.0}, false);
  const hal::ImuSample z = imu.sample({}, {}, {0.0, 0.0, 150.0}, false);
  const double length = 150.0 / (16.0 * gravity_m_s2) * 32768.0;
  double determinant = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = x.specific_force[i];
    determinant += a * (y.specific_force[(i + 1) % 3] * static_cast<double>(z.specific_force[(i + 2) % 3]) -
                        y.specific_force[(i + 2) % 3] * static_cast<double>(z.specific_force[(i + 1) % 3]));
  }
  EXPECT_NEAR(determinant / (length * length * length), 1.0, 2e-4);
}

TEST(ImuModel, ADelayedSampleCarriesTheTimeItWasMeasured) {
  for (const int delay_ms : {1, 7, 20}) {
    InertialParameters p = quiet();
    p.delay_s = 0.001 * delay_ms;
    ImuModel imu{p, {seed, 0}};
    const double step = 16.0 * gravity_m_s2 / 32768.0;
    for (int tick = 0; tick < 100; ++tick) {
      const hal::ImuSample sample = imu.sample(milliseconds(tick), {}, {tick * step, 0.0, 0.0}, false);
      if (tick < delay_ms) {
        EXPECT_EQ(sample.status, hal::Status::no_reading);
      } else {
        EXPECT_EQ(sample.status, hal::Status::ok);
        EXPECT_EQ(sample.time, milliseconds(tick - delay_ms));
        EXPECT_EQ(sample.specific_force[0], tick - delay_ms);
      }
    }
  }
}

TEST(ImuModel, InADropoutTheLastSampleComesAgainWithItsOldTime) {
  for (const int delay_ms : {0, 3}) {
    InertialParameters p;
    p.delay_s = 0.001 * delay_ms;
    ImuModel imu{p, {seed, 0}};
    EXPECT_EQ(imu.sample({}, {}, {}, true).status, hal::Status::no_reading);
    hal::ImuSample last{};
    for (int tick = 0; tick < 10; ++tick) {
      last = imu.sample(milliseconds(tick), {}, {}, false);
    }
    for (int tick = 10; tick < 60; ++tick) {
      const hal::ImuSample hung = imu.sample(milliseconds(tick), {1.0, 0.0, 0.0}, {50.0, 0.0, 0.0}, true);
      EXPECT_EQ(hung.time, milliseconds(9 - delay_ms));
      EXPECT_EQ(hung.rate, last.rate);
      EXPECT_EQ(hung.specific_force, last.specific_force);
    }
    for (int tick = 60; tick < 70; ++tick) {
      const hal::ImuSample back = imu.sample(milliseconds(tick), {}, {}, false);
      EXPECT_EQ(back.time, milliseconds(tick < 60 + delay_ms ? 9 : tick - delay_ms));
    }
  }
}

TEST(AccelerometerModel, HasItsOwnRangeNoiseDelayAndDropout) {
  InertialParameters p = quiet();
  p.full_scale_m_s2 = 32.0 * gravity_m_s2;
  p.delay_s = 0.002;
  AccelerometerModel sensor{p, {seed, 1}};
  EXPECT_FLOAT_EQ(sensor.scale(), static_cast<float>(32.0 * gravity_m_s2 / 32768.0));
  for (int tick = 0; tick < 10; ++tick) {
    const hal::AccelerometerSample sample = sensor.sample(milliseconds(tick), {-gravity_m_s2, 1e9, -1e9}, false);
    if (tick >= 2) {
      EXPECT_EQ(sample.time, milliseconds(tick - 2));
      EXPECT_EQ(sample.specific_force, (hal::Counts{-1024, 32767, -32768}));
    }
  }
  EXPECT_EQ(sensor.sample(milliseconds(10), {}, true).time, milliseconds(7));
}

// Through the scaling of the firmware the true values come back, with their signs.
TEST(ImuModel, TheFirmwareReadsTheTruthBackWithinHalfACount) {
  ImuModel imu{quiet(), {seed, 0}};
  const Vector3 rate{-3.0, 0.5, 20.0};
  const Vector3 force{25.0, -9.0, 0.25};
  const hal::ImuSample sample = imu.sample({}, rate, force, false);
  const core::GyroSample gyro = avionics::gyro_sample(sample, imu.scale());
  const core::AccelerometerSample read = avionics::accelerometer_sample(sample.time, sample.specific_force,
                                                                        sample.status, imu.scale().specific_force_m_s2);
  const double half_rate = 0.501 * 2000.0 * radians_per_degree / 32768.0;
  const double half_force = 0.501 * 16.0 * gravity_m_s2 / 32768.0;
  EXPECT_EQ(gyro.quality, core::SampleQuality::valid);
  EXPECT_NEAR(gyro.rate_rad_s.x, rate.x, half_rate);
  EXPECT_NEAR(gyro.rate_rad_s.y, rate.y, half_rate);
  EXPECT_NEAR(gyro.rate_rad_s.z, rate.z, half_rate);
  EXPECT_NEAR(read.specific_force_m_s2.x, force.x, half_force);
  EXPECT_NEAR(read.specific_force_m_s2.y, force.y, half_force);
  EXPECT_NEAR(read.specific_force_m_s2.z, force.z, half_force);
  const hal::ImuSample high = imu.sample({}, {}, {200.0, 0.0, 0.0}, false);
  EXPECT_EQ(avionics::accelerometer_sample({}, high.specific_force, high.status, 1.0F).quality,
            core::SampleQuality::saturated);
}

TEST(ImuModel, RefusesParametersOutsideTheirRange) {
  const auto refused = [](auto change) {
    InertialParameters p;
    change(p);
    EXPECT_THROW((ImuModel{p, {seed, 0}}), std::invalid_argument);
    EXPECT_THROW((AccelerometerModel{p, {seed, 0}}), std::invalid_argument);
  };
  refused([](InertialParameters& p) { p.delay_s = 0.021; });
  refused([](InertialParameters& p) { p.delay_s = -0.001; });
  refused([](InertialParameters& p) { p.full_scale_m_s2 = 0.0; });
  refused([](InertialParameters& p) { p.misalignment_rad = 0.3; });
  refused([](InertialParameters& p) { p.specific_force_noise_m_s2 = std::nan(""); });
}

}  // namespace
}  // namespace fantail::sim
