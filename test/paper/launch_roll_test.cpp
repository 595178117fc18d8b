// SPDX-License-Identifier: MIT
// Roll of the two launches under the published control law, at the canonical speed.
#include <complex>

#include "core/chirp.hpp"
#include "core/flight_plan_fields.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "paper/closed_loop.hpp"
#include "test.hpp"

namespace fantail::paper {
namespace {

// t = 0 at launch detection, 0.21 s after lift-off.
Loop launch1(double limit_deg) {
  const double d = radians_per_degree;
  return {
      .plant = {.inertia_kg_m2 = 0.00361, .reference_area_m2 = reference_area_m2, .damping_m2 = 7.5, .torque_m = 10},
      .controller = gains(1, 0.1, limit_deg),
      .reference = step(0, -15, 1.0),
      .excitation = core::default_plan().excitation,
      .disturbance = sim::Disturbance{{{0, 0.1 * d}, {1.47, -7.3 * d}, {2.94, -7 * d}, {5.97, -7 * d}, {9, -7.3 * d}}},
      .speed_m_s = launch_speed(3.47, 0.21),
      .control_from_s = 0.42,
      .servo_lag_s = 0.020,
      .start = {.angle_rad = -0.6 * d, .rate_rad_s = 51.8 * d}};
}

// t = 0 at control start, 0.64 s after lift-off.
Loop launch2(double proportional_gain, const core::ExcitationPlan& excitation) {
  return {.plant = {.inertia_kg_m2 = 0.00393, .reference_area_m2 = reference_area_m2, .damping_m2 = 23, .torque_m = 9},
          .controller = gains(proportional_gain, 0.1 * proportional_gain, 9),
          .reference = step(0, -20, 2.0),
          .excitation = excitation,
          .disturbance = sim::Disturbance{{{0.0, -4.9 * radians_per_degree}}},
          .speed_m_s = launch_speed(3.99, 0.64),
          .servo_lag_s = 0.020,
          .start = {.rate_rad_s = -20 * radians_per_degree}};
}

core::ExcitationPlan published_chirp() {
  return input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, "tasha3_launch2"))).excitation;
}

TEST(Oracle, Row16TheFirstLaunchSwingsAsMeasured) {
  const auto points = run(launch1(6), 9.0);
  const Point& high = peak(points, 0, 0.8);
  const Point& low = trough(points, 0.6, 1.42);
  EXPECT_NEAR(high.time_s, 0.489, 0.01);
  EXPECT_NEAR(low.time_s, 1.025, 0.02);
  EXPECT_NEAR(high.angle_deg - low.angle_deg, 26.85, 0.4);
}

TEST(Oracle, Row17TheFirstLaunchEndsWithAllCanardsAtTheirLimit) {
  const auto points = run(launch1(6), 9.0);
  const auto last_free = std::find_if(points.rbegin(), points.rend(), [](const Point& p) { return !p.saturated; });
  ASSERT_NE(last_free, points.rend());
  EXPECT_NEAR(last_free->time_s, 1.468, 0.01);
  for (const Point& point : points) {
    if (point.time_s > last_free->time_s) {
      ASSERT_FLOAT_EQ(static_cast<float>(point.command_deg), 6.0F) << point.time_s;
    }
    if (point.time_s > 1.6) {
      ASSERT_LT(point.rate_deg_s, 0.0) << point.time_s;
    }
  }
}

TEST(Oracle, Row18TheFirstLaunchRollsBackwardsThroughTheCoast) {
  const auto points = run(launch1(6), 9.0);
  EXPECT_NEAR(at(points, 3).rate_deg_s, -129.8, 0.005 * 129.8);
  EXPECT_NEAR(at(points, 6).rate_deg_s, -73.1, 0.005 * 73.1);
  EXPECT_NEAR(at(points, 9).rate_deg_s, -41.1, 0.005 * 41.1);
  EXPECT_NEAR(at(points, 9).angle_deg, -674, 1.5);
}

TEST(Oracle, Row19NineDegreesWouldHaveHeldTheFirstLaunch) {
  const auto points = run(launch1(9), 9.0);
  EXPECT_NEAR(mean_angle_deg(points, 4, 8), -22.05, 0.3);
  EXPECT_EQ(saturated_share(points, 2, 9), 0.0);
}

TEST(Oracle, Row20TheSecondLaunchHoldsTheReferencePlusOffsetOverGain) {
  const core::ExcitationPlan off = core::default_plan().excitation;
  const auto soft = run(launch2(0.5, off), 8.0);
  EXPECT_NEAR(mean_angle_deg(soft, 1, 2), -9.80, 0.05);
  EXPECT_NEAR(mean_angle_deg(soft, 4, 7), -29.80, 0.05);
  const auto firm = run(launch2(1, off), 8.0);
  EXPECT_NEAR(mean_angle_deg(firm, 1, 2), -4.90, 0.05);
  EXPECT_NEAR(mean_angle_deg(firm, 4, 7), -24.90, 0.05);
}

TEST(Oracle, Row21TheChirpLeavesTheMeansAndTouchesTheLimit) {
  struct Case {
    double gain, before_step_deg, after_step_deg, saturated;
  };
  for (const Case& c : {Case{0.5, -9.80, -29.80, 0.062}, Case{1, -4.90, -24.90, 0.089}}) {
    const auto points = run(launch2(c.gain, published_chirp()), 8.0);
    EXPECT_NEAR(mean_angle_deg(points, 1, 2), c.before_step_deg, 0.1);
    EXPECT_NEAR(mean_angle_deg(points, 4, 7), c.after_step_deg, 0.1);
    EXPECT_NEAR(saturated_share(points, 0.4, 7), c.saturated, 0.015);
    double largest = 0.0;
    for (const Point& point : points) {
      largest = std::max(largest, std::abs(point.command_deg));
    }
    EXPECT_FLOAT_EQ(static_cast<float>(largest), 9.0F);
  }
}

TEST(Oracle, Row22TheProductChirpAsPublished) {
  const auto excitation_deg = [](int milliseconds) {
    core::Chirp chirp{published_chirp()};
    return static_cast<double>(chirp.update(core::Microseconds{1000 * milliseconds}).degrees());
  };
  EXPECT_NEAR(excitation_deg(400), 3.6193, 1e-4);
  EXPECT_NEAR(excitation_deg(500), 0.0, 1e-4);
  EXPECT_NEAR(excitation_deg(6990), -3.6172, 1e-4);
  EXPECT_EQ(excitation_deg(0), 0.0);
  EXPECT_EQ(excitation_deg(399), 0.0);
  EXPECT_EQ(excitation_deg(7000), 0.0);
  EXPECT_EQ(excitation_deg(9000), 0.0);
}

// Phase margin of the open loop (kp + kd s) g / (s (s + a)) / (1 + lag s) e^(-delay s), from the plant's own a and g.
double phase_margin_deg(double lag_s, double delay_s) {
  const sim::RollPlant plant{
      .inertia_kg_m2 = 0.00361, .reference_area_m2 = reference_area_m2, .damping_m2 = 7.5, .torque_m = 10};
  const double a = plant.damping_rate_per_s(density_kg_m3, 97.0);
  const double gain = plant.authority_per_s2(density_kg_m3, 97.0);
  const auto open_loop = [&](double frequency_rad_s) {
    const std::complex<double> s{0.0, frequency_rad_s};
    return (1.0 + 0.1 * s) * gain / (s * (s + a)) / (1.0 + lag_s * s);
  };
  double low = 1.0;  // the gain falls with frequency: bisect for gain one
  double high = 1000.0;
  while (high - low > 1e-9) {
    const double middle = 0.5 * (low + high);
    (std::abs(open_loop(middle)) > 1.0 ? low : high) = middle;
  }
  double phase_rad = std::arg(open_loop(low)) - low * delay_s;
  if (std::arg(open_loop(low)) > 0.0) {
    phase_rad -= 2.0 * std::numbers::pi;
  }
  return (phase_rad + std::numbers::pi) / radians_per_degree;
}

TEST(Oracle, Row29LagAndDelayEatThePhaseMarginOfTheFirstLaunch) {
  EXPECT_NEAR(phase_margin_deg(0.0, 0.0), 88, 3);
  EXPECT_NEAR(phase_margin_deg(0.020, 0.0), 40, 3);
  EXPECT_NEAR(phase_margin_deg(0.020, 0.015), -7, 3);
}

}  // namespace
}  // namespace fantail::paper
