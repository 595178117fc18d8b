// SPDX-License-Identifier: MIT
#include "sim/felt_motion.hpp"

#include "sim/rotation.hpp"
#include "sim/vibration.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

FeltMotion sensor(const FeltMotionParameters& parameters) { return FeltMotion{parameters}; }

TEST(FeltMotion, AtTheCentreOfGravityIsTheMotionItself) {
  EXPECT_TRUE(sensor({}).is_ideal());
  EXPECT_FALSE(sensor({.across_m = 0.01}).is_ideal());
}

TEST(FeltMotion, OffTheAxisFeelsTheSpin) {
  const BodyMotion felt =
      sensor({.across_m = 0.02, .specific_force_scale_error = 0.01})
          .felt({.specific_force_m_s2 = {}, .rate_rad_s = {.x = 10.0}, .angular_acceleration_rad_s2 = {}}, {}, {}, 0.0);
  EXPECT_NEAR(felt.specific_force_m_s2.x, 0.0, 1e-12);
  EXPECT_NEAR(felt.specific_force_m_s2.y, -2.02, 1e-12);
  EXPECT_NEAR(felt.specific_force_m_s2.z, 0.0, 1e-12);
}

// In front of the centre of gravity by 0.5 m: a pitch that speeds up with 4 rad/s2 moves it towards -z with 2 m/s2,
// and a pitch rate of 3 rad/s pulls it back with 0.5 3^2.
TEST(FeltMotion, InFrontOfTheCentreOfGravityFeelsThePitch) {
  FeltMotion imu = sensor({.position_m = 0.4});
  const BodyMotion pitch{
      .specific_force_m_s2 = {}, .rate_rad_s = {.y = 3.0}, .angular_acceleration_rad_s2 = {.y = 4.0}};
  const BodyMotion felt = imu.felt(pitch, {}, 0.9, 0.0);
  EXPECT_NEAR(felt.specific_force_m_s2.x, -4.5, 1e-12);
  EXPECT_NEAR(felt.specific_force_m_s2.z, -2.0, 1e-12);
  EXPECT_NEAR(imu.felt(pitch, {}, {}, 0.0).specific_force_m_s2.x, 0.0, 1e-12) << "nobody knows the centre";
}

// A point of a turning disc, its place computed and differentiated twice.
TEST(FeltMotion, IsWhatDifferentiatingThePlaceTwiceGives) {
  constexpr double step_s = 1e-4;
  constexpr double across_m = 0.03;
  const auto angle = [](double t) { return 2.0 * t + 1.5 * t * t; };
  const auto place = [&](double t) {
    return Vector3{0.0, across_m * std::cos(angle(t)), across_m * std::sin(angle(t))};
  };
  const double t = 0.7;
  const Vector3 earth = (1.0 / (step_s * step_s)) * (place(t + step_s) - 2.0 * place(t) + place(t - step_s));
  const Vector3 body{0.0, std::cos(angle(t)) * earth.y + std::sin(angle(t)) * earth.z,
                     std::cos(angle(t)) * earth.z - std::sin(angle(t)) * earth.y};
  const BodyMotion felt = sensor({.across_m = across_m})
                              .felt({.specific_force_m_s2 = {},
                                     .rate_rad_s = {.x = 2.0 + 3.0 * t},
                                     .angular_acceleration_rad_s2 = {.x = 3.0}},
                                    {}, {}, 0.0);
  EXPECT_NEAR(felt.specific_force_m_s2.y, body.y, 1e-6);
  EXPECT_NEAR(felt.specific_force_m_s2.z, body.z, 1e-6);
}

TEST(FeltMotion, AGyroFeelsForceAndWarmth) {
  const BodyMotion felt =
      sensor({.rate_scale_error = 0.02, .rate_per_specific_force_s_m = 1e-3, .rate_drift_rad_s2 = 1e-4})
          .felt({.specific_force_m_s2 = {.x = 50.0}, .rate_rad_s = {.x = 1.0}, .angular_acceleration_rad_s2 = {}}, {},
                {}, 20.0);
  EXPECT_NEAR(felt.rate_rad_s.x, 1.02 + 0.05 + 0.002, 1e-12);
  EXPECT_NEAR(felt.rate_rad_s.y, 0.002, 1e-12);
}

// On an arm of 20 mm a rate of 5 rad/s that lasted would pull with 0.5 m/s2; one that shakes does not.
TEST(FeltMotion, IsShakenWhereTheSensorSitsAndThenMisread) {
  const BodyMotion felt = sensor({.across_m = 0.02, .rate_scale_error = 0.02, .specific_force_scale_error = 0.01})
                              .felt({}, {.specific_force_m_s2 = {.y = 8.0}, .rate_rad_s = {.x = 5.0}}, {}, 0.0);
  EXPECT_NEAR(felt.specific_force_m_s2.y, 8.08, 1e-12);
  EXPECT_NEAR(felt.rate_rad_s.x, 5.1, 1e-12);
}

TEST(Vibration, ShakesInItsBand) {
  Vibration vibration{{.specific_force_m_s2 = 5.0, .rate_rad_s = 0.2, .frequency_hz = 100.0}, Random{11, 3}};
  EXPECT_FALSE((Vibration{{}, Random{11, 3}}.is_there()));
  constexpr int samples = 200'000;
  std::vector<double> x;
  double rates = 0.0;
  for (int i = 0; i < samples; ++i) {
    const Shaking shaking = vibration.next();
    x.push_back(shaking.specific_force_m_s2.x);
    rates += shaking.rate_rad_s.z * shaking.rate_rad_s.z / samples;
  }
  double square = 0.0;
  double half_period = 0.0;  // 5 ms at 100 Hz
  for (std::size_t i = 5; i < x.size(); ++i) {
    square += x[i] * x[i];
    half_period += x[i] * x[i - 5];
  }
  // 200 s in a band of 20 Hz: some 4000 independent pieces.
  EXPECT_NEAR(std::sqrt(square / samples), 5.0, 0.25);
  EXPECT_NEAR(std::sqrt(rates), 0.2, 0.01);
  // Half a period later it is upside down, and less by the width of the band: -0.779, from the sum over its impulse
  // response.
  EXPECT_NEAR(half_period / square, -0.779, 0.03);
}

// What only shakes stays where it is: its speed is that of the shaking, 5 m/s2 / (2 pi 60 Hz) = 13 mm/s, and its angle
// 5 mrad at 2 rad/s. White noise of this size would wander off by 5 sqrt(1 ms 200 s) = 2.2 m/s.
TEST(Vibration, LeavesNoSpeedAndNoAngleBehind) {
  Vibration vibration{{.specific_force_m_s2 = 5.0, .rate_rad_s = 2.0, .frequency_hz = 60.0}, Random{11, 3}};
  double speed_m_s = 0.0;
  double angle_rad = 0.0;
  double most_speed_m_s = 0.0;
  double most_angle_rad = 0.0;
  for (int i = 0; i < 200'000; ++i) {
    const Shaking shaking = vibration.next();
    speed_m_s += 1e-3 * shaking.specific_force_m_s2.x;
    angle_rad += 1e-3 * shaking.rate_rad_s.y;
    most_speed_m_s = std::max(most_speed_m_s, std::abs(speed_m_s));
    most_angle_rad = std::max(most_angle_rad, std::abs(angle_rad));
  }
  EXPECT_LT(most_speed_m_s, 6.0 * 0.0133);
  EXPECT_LT(most_angle_rad, 6.0 * 0.0053);
  EXPECT_GT(most_speed_m_s, 0.0133);
}

}  // namespace
}  // namespace fantail::sim
