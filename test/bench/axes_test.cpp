// SPDX-License-Identifier: MIT
#include "bench/axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/turned_rocket.hpp"
#include "core/flight_plan_members.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

AxesResult judged(const Rocket& rocket) { return judge_axes(turned(rocket)); }

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
              "The roll is reversed: 360 degrees clockwise were measured as -360.0.");
  expect_said(judged({.gyro = {{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}}), "The gyro measures the roll about y");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}}),
              "Gyro and accelerometer of the IMU measure opposite turns about y: one of them is reversed.");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1.08}}}}),
              "In a turn about z, the gyro measures 108 % of the angle that the second accelerometer measures.");
  expect_said(judged({.gyro = {{{1.05, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}), "360 degrees of roll were measured as 378.0");
  expect_said(judged({.gyro = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}}), "The gyro does not measure the turn about z");
  expect_said(judged({.second = {{{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}}}), "The second accelerometer reads -1 g along x");
  expect_said(judged({.accelerometer = {{{1.2, 0, 0}, {0, 1.2, 0}, {0, 0, 1.2}}}}), "reads 1.20 g at rest");
  const double c = std::cos(12.0 * degree);
  const double s = std::sin(12.0 * degree);
  const Matrix askew{{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
  expect_said(judged({.gyro = askew}), "The gyro is mounted about 12 degrees askew");
  expect_said(judged({.accelerometer = askew}), "The accelerometer of the IMU is mounted 12 degrees askew");
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

using core::SensorAxis;
using core::SensorMounting;
using core::SensorsPlan;

/// How a sensor of this mounting shows the rocket's axes to an avionics that believes the other one.
Matrix seen_through(const SensorMounting& truth, const SensorMounting& believed) {
  const auto unit = [](SensorAxis axis) {
    Vector3 v{};
    const double sign = static_cast<int>(axis) % 2 == 0 ? 1.0 : -1.0;
    (static_cast<int>(axis) / 2 == 0 ? v.x : static_cast<int>(axis) / 2 == 1 ? v.y : v.z) = sign;
    return v;
  };
  const auto axes = [&](const SensorMounting& m) {
    return std::array{unit(m.to_nose), unit(m.along_y), sim::cross(unit(m.to_nose), unit(m.along_y))};
  };
  Matrix m{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      m[i][k] = sim::dot(axes(believed)[i], axes(truth)[k]);
    }
  }
  return m;
}

std::vector<SensorMounting> all_mountings() {
  std::vector<SensorMounting> all;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      if (x / 2 != y / 2) {
        all.push_back({static_cast<SensorAxis>(x), static_cast<SensorAxis>(y)});
      }
    }
  }
  return all;
}

Rocket built(const SensorsPlan& truth, const SensorsPlan& believed) {
  Rocket rocket;
  rocket.gyro = rocket.accelerometer = seen_through(truth.imu, believed.imu);
  rocket.second = seen_through(truth.accelerometer, believed.accelerometer);
  return rocket;
}

// Up to a turn of all sensors together about the roll axis, which nobody can see.
TEST(AxesMounting, WhateverTheSensorsAreMountedLikeAPlanIsFoundThatIsRight) {
  ASSERT_EQ(all_mountings().size(), 24U);
  SensorsPlan believed = core::default_plan().sensors;
  believed.imu = {SensorAxis::minus_y, SensorAxis::plus_z};
  for (const SensorMounting& imu : all_mountings()) {
    for (const SensorMounting& accelerometer : {all_mountings()[3], all_mountings()[17], believed.accelerometer}) {
      SensorsPlan truth = believed;
      truth.imu = imu;
      truth.accelerometer = accelerometer;
      const auto found = mounting_of(turned(built(truth, believed)), believed);
      ASSERT_TRUE(found.has_value());
      EXPECT_TRUE(judge_axes(turned(built(truth, *found))).right);
      EXPECT_EQ(found->imu.to_nose, truth.imu.to_nose);
      EXPECT_EQ(found->accelerometer.to_nose, truth.accelerometer.to_nose);
    }
  }
}

TEST(AxesMounting, APlanThatIsRightIsLeftAsItIs) {
  const SensorsPlan believed = core::default_plan().sensors;
  const auto found = mounting_of(turned(Rocket{}), believed);
  ASSERT_TRUE(found.has_value());
  EXPECT_EQ(mounting_lines(*found, believed), "");
}

TEST(AxesMounting, OnlyTheLinesThatChangeAreSaid) {
  const SensorsPlan believed = core::default_plan().sensors;
  SensorsPlan found = believed;
  found.imu.to_nose = SensorAxis::minus_z;
  found.accelerometer.along_y = SensorAxis::plus_z;
  EXPECT_EQ(mounting_lines(found, believed), "[sensors]\nimu_to_nose = \"-z\"\naccelerometer_along_y = \"+z\"\n");
}

// Gyro and accelerometer sit in one package: a gyro alone that is turned round is no mounting, and neither is a scale.
TEST(AxesMounting, WhatNoMountingExplainsIsNotAdvised) {
  const SensorsPlan believed = core::default_plan().sensors;
  const Matrix half_turn{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  EXPECT_FALSE(mounting_of(turned({.gyro = half_turn}), believed).has_value());
  EXPECT_FALSE(mounting_of(turned({.gyro = {{{1.1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}), believed).has_value());
  EXPECT_FALSE(mounting_of(turned({.tilt_rad = {.y = 20.0 * degree}}), believed).has_value());
}

}  // namespace

}  // namespace fantail::bench
