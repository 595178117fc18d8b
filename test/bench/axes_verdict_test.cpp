// SPDX-License-Identifier: MIT
#include "bench/axes_verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/units.hpp"

namespace fantail::bench {
namespace {

using sim::Vector3;
using sim::operator*;

constexpr double degree = std::numbers::pi / 180.0;

/// What a sensor makes of a vector of the body, row by row.
using Matrix = std::array<std::array<double, 3>, 3>;
constexpr Matrix identity{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Vector3 through(const Matrix& m, const Vector3& v) {
  const auto row = [&](std::size_t i) { return m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z; };
  return {row(0), row(1), row(2)};
}

double determinant(const Matrix& m) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

sim::Quaternion rotation(const Vector3& angle_rad) {
  const double angle = sim::length(angle_rad);
  const double share = angle > 0.0 ? std::sin(0.5 * angle) / angle : 0.5;
  return {.w = std::cos(0.5 * angle), .x = share * angle_rad.x, .y = share * angle_rad.y, .z = share * angle_rad.z};
}

struct Rocket {
  Matrix gyro = identity;
  Matrix accelerometer = identity;
  Matrix second = identity;
  Vector3 roll_rad{.x = 360.0 * degree};
  Vector3 tilt_rad{.y = 90.0 * degree};
  Vector3 tilt_across_rad{.z = 90.0 * degree};
};

AxesResult judged(const Rocket& rocket) {
  const Vector3 up{.x = sim::gravity_m_s2};
  const auto seen_of = [&](const Vector3& turn_rad) {
    const Vector3 after = sim::rotated_back(rotation(turn_rad), up);
    const Vector3 seen_rad = through(rocket.gyro, turn_rad);
    return TurnSeen{.before_m_s2 = {through(rocket.accelerometer, up), through(rocket.second, up)},
                    .after_m_s2 = {through(rocket.accelerometer, after), through(rocket.second, after)},
                    .angle_rad = seen_rad,
                    .turned = rotation(seen_rad)};
  };
  return judge_axes({seen_of(rocket.roll_rad), seen_of(rocket.tilt_rad), TurnSeen{}, seen_of(rocket.tilt_across_rad)});
}

void expect_said(const AxesResult& result, const std::string& words) {
  EXPECT_FALSE(result.right);
  EXPECT_NE(axes_text(result).find(words), std::string::npos) << axes_text(result);
}

/// Every way in which somebody can connect three axes to the wrong ones or turn them round: 48.
std::vector<Matrix> mountings() {
  std::vector<Matrix> all;
  std::array<std::size_t, 3> order{0, 1, 2};
  do {
    for (unsigned signs = 0; signs < 8; ++signs) {
      Matrix m{};
      for (std::size_t i = 0; i < 3; ++i) {
        m[i][order[i]] = ((signs >> i) & 1U) != 0U ? -1.0 : 1.0;
      }
      all.push_back(m);
    }
  } while (std::ranges::next_permutation(order).found);
  return all;
}

// What tilts the rocket about axes of its own between y and z, to each side.
std::vector<Rocket> handled() {
  std::vector<Rocket> all;
  for (const double side : {0.0, 30.0, 45.0, 100.0, 190.0, 280.0}) {
    for (const double angle : {-60.0, 90.0, 120.0}) {
      const double c = std::cos(side * degree);
      const double s = std::sin(side * degree);
      all.push_back({.tilt_rad = angle * degree * Vector3{.y = c, .z = s},
                     .tilt_across_rad = 90.0 * degree * Vector3{.y = -s, .z = c}});
    }
  }
  return all;
}

TEST(AxesVerdict, SensorsAsTheyShouldBeAreRightWhicheverSideTheRocketLiesOn) {
  for (const Rocket& rocket : handled()) {
    const AxesResult result = judged(rocket);
    EXPECT_TRUE(result.right) << axes_text(result);
  }
}

// A turn of all sensors together about the roll axis is what nobody can see, and what changes nothing.
TEST(AxesVerdict, AllSensorsMountedAlikeAreRightOnlyWhenTurnedAboutTheRollAxis) {
  for (const Rocket& hands : handled()) {
    for (const Matrix& m : mountings()) {
      Rocket rocket = hands;
      rocket.gyro = rocket.accelerometer = rocket.second = m;
      const AxesResult result = judged(rocket);
      EXPECT_EQ(result.right, m[0][0] == 1.0 && determinant(m) > 0.0) << axes_text(result);
    }
  }
}

TEST(AxesVerdict, OneSensorMountedOtherwiseThanTheRestIsAlwaysFound) {
  for (const Rocket& hands : handled()) {
    for (const Matrix& m : mountings()) {
      Rocket of_gyro = hands;
      of_gyro.gyro = m;
      EXPECT_EQ(judged(of_gyro).right, m == identity) << axes_text(judged(of_gyro));
      Rocket of_second = hands;
      of_second.second = m;
      EXPECT_EQ(judged(of_second).right, m == identity) << axes_text(judged(of_second));
      Rocket of_imu = hands;
      of_imu.gyro = of_imu.accelerometer = m;
      EXPECT_EQ(judged(of_imu).right, m == identity) << axes_text(judged(of_imu));
    }
  }
}

TEST(AxesVerdict, WhatIsWrongIsNamed) {
  expect_said(judged({.roll_rad = {.x = -360.0 * degree}}),
              "The roll is reversed: 360 degrees clockwise were seen as -360.0.");
  expect_said(judged({.gyro = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}}), "The gyro sees the roll about y");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}}),
              "Gyro and accelerometer of the IMU see opposite turns about y: one of them is reversed.");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1.08}}}}),
              "Of a turn about z the gyro sees 108 % of what the second accelerometer sees.");
  expect_said(judged({.gyro = {{{1.05, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}), "360 degrees of roll were seen as 378.0");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}}), "The gyro does not see the turn about z");
  expect_said(judged({.second = {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}}), "The second accelerometer reads -1 g along x");
  expect_said(judged({.accelerometer = {{{1.2, 0, 0}, {0, 1.2, 0}, {0, 0, 1.2}}}}), "reads 1.20 g at rest");
  const double c = std::cos(12.0 * degree);
  const double s = std::sin(12.0 * degree);
  const Matrix askew{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  expect_said(judged({.gyro = askew}), "The gyro stands askew by about 12 degrees");
  expect_said(judged({.accelerometer = askew}), "The accelerometer of the IMU stands askew by 12 degrees");
}

TEST(AxesVerdict, ErrorsThatASensorMayHaveAreNoFaults) {
  EXPECT_TRUE(judged({.gyro = {{{1.02, 0.01, 0}, {0.02, 0.97, 0}, {0, -0.02, 1.03}}}}).right);
}

TEST(AxesVerdict, TiltsThatProveNothingAreNamed) {
  expect_said(judged({.tilt_rad = {.y = 20.0 * degree}}), "too little to judge");
  expect_said(judged({.tilt_across_rad = {.y = 90.0 * degree, .z = 30.0 * degree}}), "to nearly the same side");
}

TEST(AxesVerdict, ASensorThatGaveNothingIsNotRight) {
  TurnsSeen seen{};
  seen[0].angle_rad = {.x = 360.0 * degree};
  expect_said(judge_axes(seen), "The second accelerometer gave no valid report.");
}

}  // namespace
}  // namespace fantail::bench
