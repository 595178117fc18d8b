// SPDX-License-Identifier: MIT

#include "identify/identification.hpp"

#include "core/flight_plan_fields.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/model/roll_model.hpp"
#include "identify/result/uncertainty.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "paper/flown_record.hpp"
#include "paper/published_steps.hpp"
#include "paper/recomputed.hpp"
#include "test.hpp"

namespace fantail::paper {
namespace {

// What the roll model's identification must give back: Table 2, and the limits of what a window can tell.

using identify::model::Record;
using identify::result::Identification;
using identify::result::Method;

constexpr double degrees(double rad) { return rad / radians_per_degree; }

TEST(Oracle, Row23EveryStepOfTable2ComesBackExactlyOnTheGrid) {
  for (const TunnelStep& row : table_2) {
    const Loop loop = tunnel_loop(row);
    const Record record = flown_record(loop, 0.0, 5.0, 10);
    const Identification found = identify::identify(
        record, airframe(loop), {.nodes = identify::model::NodeTimes{0.0, 5.0}, .method = Method::grid});
    SCOPED_TRACE(row.step);
    EXPECT_DOUBLE_EQ(found.model.alpha_m2, row.alpha_m2);
    EXPECT_DOUBLE_EQ(found.model.beta_m, row.beta_m);
    EXPECT_NEAR(degrees(found.model.node_rad[0]), row.disturbance_begin_deg, 0.03);
    EXPECT_NEAR(degrees(found.model.node_rad[1]), row.disturbance_end_deg, 0.03);
    EXPECT_LT(degrees(found.simulation.mean_abs_angle_error_rad), 0.06);
  }
}

TEST(Oracle, TheContinuousMethodFindsTheStepsOfTable2WithoutAGrid) {
  for (const TunnelStep& row : table_2) {
    const Loop loop = tunnel_loop(row);
    const Record record = flown_record(loop, 0.0, 5.0, 10);
    const Identification found =
        identify::identify(record, airframe(loop), {.nodes = identify::model::NodeTimes{0.0, 5.0}});
    SCOPED_TRACE(row.step);
    EXPECT_NEAR(found.model.alpha_m2, row.alpha_m2, 0.01 * row.alpha_m2);
    EXPECT_NEAR(found.model.beta_m, row.beta_m, 0.01 * row.beta_m);
    EXPECT_NEAR(degrees(found.model.node_rad[0]), row.disturbance_begin_deg, 0.05);
    EXPECT_NEAR(degrees(found.model.node_rad[1]), row.disturbance_end_deg, 0.05);
  }
}

// t = 0 at control start, 0.64 s after lift-off.
Loop second_launch(const core::ExcitationPlan& excitation) {
  return {.plant = {.inertia_kg_m2 = 0.00393, .reference_area_m2 = reference_area_m2, .damping_m2 = 23, .torque_m = 9},
          .controller = gains(0.5, 0.05, 9),
          .reference = step(0, -20, 2.0),
          .excitation = excitation,
          .disturbance = sim::Disturbance{{{0.0, -4.9 * radians_per_degree}}},
          .speed_m_s = launch_speed(3.99, 0.64),
          .control_from_s = 0.0,
          .servo_lag_s = 0.020,
          .start = {.angle_rad = 0.0, .rate_rad_s = -20 * radians_per_degree}};
}

// With the four intervals that this window was published with.
double cramer_rao_alpha_m2(const core::ExcitationPlan& excitation) {
  const Loop loop = second_launch(excitation);
  const Record record = flown_record(loop, 0.4, 2.0, 10);
  const identify::model::NodeTimes nodes = identify::model::even_nodes(record, 4);
  const identify::model::RollModel truth{.alpha_m2 = 23,
                                         .beta_m = 9,
                                         .node_time_s = nodes,
                                         .node_rad = std::vector<double>(nodes.size(), -4.9 * radians_per_degree),
                                         .initial = {{record.roll_angle_rad[0], record.roll_rate_rad_s[0]}}};
  const auto sensitivities = identify::model::open_loop_sensitivities(record, airframe(loop), truth);
  return identify::result::cramer_rao_standard_deviations(sensitivities, 0.3 * radians_per_degree)(0);
}

TEST(Oracle, Row30OnlyTheChirpMakesTheDampingKnown) {
  const auto plan = input::read_plan(input::Document::load(input::find_input(input::Shipped::plan, "tasha3_launch2")));
  EXPECT_NEAR(cramer_rao_alpha_m2(plan.excitation), 1.67, 0.15 * 1.67);
  EXPECT_GT(cramer_rao_alpha_m2(core::default_plan().excitation), 50.0);
}

TEST(Oracle, TheShippedTable2IsThePrinted) {
  const std::vector<PublishedStep> shipped = published_steps();
  ASSERT_EQ(shipped.size(), std::size(table_2));
  for (std::size_t i = 0; i < shipped.size(); ++i) {
    SCOPED_TRACE(i + 1);
    EXPECT_EQ(shipped[i].step, table_2[i].step);
    EXPECT_EQ(shipped[i].alpha_m2, table_2[i].alpha_m2);
    EXPECT_EQ(shipped[i].beta_m, table_2[i].beta_m);
    EXPECT_EQ(shipped[i].disturbance_begin_deg, table_2[i].disturbance_begin_deg);
    EXPECT_EQ(shipped[i].disturbance_end_deg, table_2[i].disturbance_end_deg);
    EXPECT_EQ(shipped[i].mean_abs_angle_error_deg, table_2[i].mean_abs_angle_error_deg);
    EXPECT_EQ(shipped[i].mean_abs_rate_error_deg_s, table_2[i].mean_abs_rate_error_deg_s);
  }
}

TEST(Oracle, Row25TheMeansOfTable2) {
  std::array<double, 6> sum{};
  for (const TunnelStep& row : table_2) {
    const std::array<double, 6> numbers{row.alpha_m2,
                                        row.beta_m,
                                        row.disturbance_begin_deg,
                                        row.disturbance_end_deg,
                                        row.mean_abs_angle_error_deg,
                                        row.mean_abs_rate_error_deg_s};
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += numbers[i] / static_cast<double>(std::size(table_2));
    }
  }
  const std::array<double, 6> expected{19.375, 9.625, -5.529, -6.616, 0.875, 3.521};
  for (std::size_t i = 0; i < sum.size(); ++i) {
    EXPECT_NEAR(sum[i], expected[i], 0.001) << i;
  }
}

constexpr double g = 9.80665;

// By steps of 10 us: the speed is held until what is left is what a coast needs, found by trying.
double stepped_time_s(double height_m, double speed_m_s, double drag_per_mass_1_m) {
  constexpr double dt = 1e-5;
  double coast_m = 0.0;
  double coast_s = 0.0;
  for (double v = speed_m_s; v > 0.0; v -= (g + drag_per_mass_1_m * v * v) * dt) {
    coast_m += v * dt;
    coast_s += dt;
  }
  return coast_s + (height_m - coast_m) / speed_m_s;
}

TEST(FastestAscent, IsTheTimeThatSmallStepsGive) {
  EXPECT_NEAR(least_time_to_apogee_s(522, 97, {9.44e-4}), stepped_time_s(522, 97, 9.44e-4), 1e-3);
}

TEST(FastestAscent, WithoutDragItIsTheTextbookCoastBehindAClimbAtTopSpeed) {
  EXPECT_NEAR(least_time_to_apogee_s(522, 97, {1e-12}), 97 / (2 * g) + 522.0 / 97, 1e-4);
}

TEST(FastestAscent, ALowApogeeNeedsLessThanTheTopSpeed) {
  EXPECT_NEAR(least_time_to_apogee_s(20, 97, {1e-12}), std::sqrt(2 * 20 / g), 1e-4);
}

TEST(FastestAscent, MoreDragShortensIt) {
  EXPECT_LT(least_time_to_apogee_s(522, 97, {2e-3}), least_time_to_apogee_s(522, 97, {1e-3}));
}

TEST(FirstLaunch, TheTimesOfEq35And36AreEvenInThrustAndInCoast) {
  const identify::model::NodeTimes expected{0.0, 1.47, 2.94, 5.97, 9.0};
  const identify::model::NodeTimes times = times_in_thrust_and_coast(2.94, 2, 9.0, 2);
  ASSERT_EQ(times.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(times[i], expected[i], 1e-12) << i;
  }
}

}  // namespace

}  // namespace fantail::paper
