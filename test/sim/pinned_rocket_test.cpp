// SPDX-License-Identifier: MIT
#include "sim/pinned_rocket.hpp"

#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr double degrees = std::numbers::pi / 180.0;

// I_y 0.6 kg m2, CN 10 on a body of 80 mm, margin 0.12 m; the spread makes the damping ratio 0.139.
Airframe airframe() {
  return {.diameter_m = 0.08,
          .length_m = 1.51,
          .normal_force_slope_per_rad = 10.0,
          .centre_of_pressure_m = 1.02,
          .parts_spread_m = 0.644,
          .at_liftoff = {.centre_of_gravity_m = 0.90, .transverse_inertia_kg_m2 = 0.6}};
}

struct Swing {
  double omega_rad_s;  ///< of the undamped swing
  double damping_ratio;
};

// From the times and sizes of the maxima.
Swing swing(const PinParameters& pin, const Airframe& frame, double speed_m_s, double step_s = 1e-3) {
  PinnedRocket rocket{pin, frame, 3.99};
  std::vector<double> times_s;
  std::vector<double> sizes_rad;
  double before_rad_s = 0.0;
  double last_rad = 0.0;
  for (int i = 1; times_s.size() < 3 && i < 100'000; ++i) {
    rocket.step(step_s * i, step_s, 1.2, speed_m_s);
    if (before_rad_s > 0.0 && rocket.rate_rad_s() <= 0.0) {
      const double share = before_rad_s / (before_rad_s - rocket.rate_rad_s());
      times_s.push_back(step_s * (i - 1 + share));
      sizes_rad.push_back(std::max(last_rad, rocket.angle_rad()));
    }
    before_rad_s = rocket.rate_rad_s();
    last_rad = rocket.angle_rad();
  }
  const double decrement = std::log(sizes_rad[0] / sizes_rad[1]);
  const double damped_rad_s = 2.0 * std::numbers::pi / (times_s[1] - times_s[0]);
  const double ratio = decrement / std::hypot(2.0 * std::numbers::pi, decrement);
  return {.omega_rad_s = damped_rad_s / std::sqrt(1.0 - ratio * ratio), .damping_ratio = ratio};
}

PinParameters kicked() { return {.kicks = {{.time_s = 0.1, .rate_rad_s = 2.0 * degrees}}}; }

TEST(PinnedRocket, SwingsAsTheClosedFormSaysWithTheSameDampingAtEverySpeed) {
  for (const auto& [speed_m_s, omega_rad_s] : {std::pair{15.0, 1.165}, {20.0, 1.553}, {30.0, 2.330}}) {
    const Swing found = swing(kicked(), airframe(), speed_m_s);
    EXPECT_NEAR(found.omega_rad_s, omega_rad_s, 0.002 * omega_rad_s) << speed_m_s;
    EXPECT_NEAR(found.damping_ratio, 0.1389, 0.0005) << speed_m_s;
  }
}

// 5 mm at 15 m/s are 24 % of the stiffness of the air.
TEST(PinnedRocket, WhatHangsBelowItsPinsHelps) {
  PinParameters pin = kicked();
  pin.in_front_m = 0.005;
  const double air = 0.5 * 1.2 * 15.0 * 15.0 * 10.0 * std::numbers::pi * 0.04 * 0.04;
  const double stiffness = air * 0.125 + 3.99 * gravity_m_s2 * 0.005;
  EXPECT_NEAR(3.99 * gravity_m_s2 * 0.005 / (air * 0.12), 0.24, 0.005);
  EXPECT_NEAR(swing(pin, airframe(), 15.0).omega_rad_s, std::sqrt(stiffness / (0.6 + 3.99 * 0.005 * 0.005)), 0.003);
}

TEST(PinnedRocket, StringsAddTheirStiffnessWithoutWindToo) {
  PinParameters pin = kicked();
  pin.stiffness_n_m_per_rad = 0.3;
  pin.friction_n_m_s = 0.02;
  const Swing found = swing(pin, airframe(), 0.0);
  EXPECT_NEAR(found.omega_rad_s, std::sqrt(0.3 / 0.6), 0.001);
  EXPECT_NEAR(found.damping_ratio, 0.02 / 0.6 / 2.0 / std::sqrt(0.3 / 0.6), 1e-4);
}

TEST(PinnedRocket, ErrorFallsWithTheSquareOfTheStep) {
  const auto angle = [](int steps) {
    const Airframe frame = airframe();
    const PinParameters pin{.kicks = {{.time_s = 0.0, .rate_rad_s = 0.5}}};
    PinnedRocket rocket{pin, frame, 3.99};
    const double step_s = 2.0 / steps;
    for (int i = 1; i <= steps; ++i) {
      rocket.step(step_s * i, step_s, 1.2, 20.0);
    }
    return rocket.angle_rad();
  };
  const double exact = angle(200'000);
  EXPECT_NEAR(std::log2((angle(50) - exact) / (angle(100) - exact)), 2.0, 0.1);
}

TEST(PinnedRocket, AnUnstableOneGoesToTheWall) {
  Airframe frame = airframe();
  frame.centre_of_pressure_m = 0.85;
  const PinParameters pin = {.tether_slack_rad = 2.0, .wall_rad = 0.9, .kicks = {{.time_s = 0.1, .rate_rad_s = 0.01}}};
  PinnedRocket rocket{pin, frame, 3.99};
  for (int i = 1; i < 20'000; ++i) {
    rocket.step(1e-3 * i, 1e-3, 1.2, 30.0);
  }
  EXPECT_EQ(rocket.angle_rad(), 0.9);
}

TEST(PinnedRocket, IsFeltByItsGyroAndByItsAccelerometer) {
  const Airframe frame = airframe();
  const PinParameters pin{.kicks = {{.time_s = 0.0, .rate_rad_s = 1.0}}};
  PinnedRocket rocket{pin, frame, 3.99};
  for (int i = 1; i <= 200; ++i) {
    rocket.step(1e-3 * i, 1e-3, 1.2, 20.0);
  }
  const BodyMotion motion = rocket.motion();
  EXPECT_EQ(motion.rate_rad_s.y, rocket.rate_rad_s());
  EXPECT_NEAR(std::atan2(motion.specific_force_m_s2.z, motion.specific_force_m_s2.x), rocket.angle_rad(), 1e-12);
}

}  // namespace
}  // namespace fantail::sim
