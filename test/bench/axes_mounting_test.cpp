// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "bench/axes.hpp"
#include "bench/turned_rocket.hpp"
#include "core/flight_plan_members.hpp"

namespace fantail::bench {
namespace {

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
