// SPDX-License-Identifier: MIT
#include <complex>

#include "core/gain_schedule.hpp"
#include "input/scenario_file.hpp"
#include "stability/roll_loop.hpp"
#include "test.hpp"

namespace fantail::stability {
namespace {

using Complex = std::complex<double>;

RollLoop integrating() {
  return {.proportional_gain = 0.5,
          .derivative_gain_s = 0.05,
          .integral_gain_per_s = 0.5,
          .damping_rate_per_s = 8.0,
          .authority_per_s2 = 300.0,
          .servo_lag_s = 0.02,
          .delay_s = 0.005};
}

// The rocket damps its roll more than the law believes, and its canards turn it less.
RollLoop observing() {
  RollLoop loop = integrating();
  loop.integral_gain_per_s = 0.0;
  loop.gain_factor = 0.8;
  loop.observer = {.bandwidth_rad_s = 6.0, .damping_rate_per_s = 5.0, .authority_per_s2 = 400.0};
  return loop;
}

/// Straight from the block diagram: the observer's own low-pass around the command, solved for the command.
Complex open_loop(const RollLoop& loop, double w) {
  const Complex s{0.0, w};
  const Complex plant = loop.authority_per_s2 / (s + loop.damping_rate_per_s) * std::exp(-loop.delay_s * s) /
                        (1.0 + loop.servo_lag_s * s);
  const Complex per_rate =
      loop.gain_factor * (loop.proportional_gain / s + loop.integral_gain_per_s / (s * s) + loop.derivative_gain_s);
  const ObserverModel& model = loop.observer;
  const Complex low_pass = model.bandwidth_rad_s / (s + model.bandwidth_rad_s);
  const Complex by_observer = low_pass * (s + model.damping_rate_per_s) / model.authority_per_s2;
  return (per_rate + by_observer) / (1.0 - low_pass) * plant;
}

/// The least phase margin over all passes through one on a fine grid.
double phase_margin_on_grid_rad(const RollLoop& loop) {
  double least = 1e9;
  for (double w = 1e-3; w < 1e3; w *= 1.00002) {
    const Complex here = open_loop(loop, w);
    if ((std::abs(here) < 1.0) != (std::abs(open_loop(loop, w * 1.00002)) < 1.0)) {
      least = std::min(least, std::arg(-here));
    }
  }
  return least;
}

/// The linear loop in time with its canards' torque times a factor: by how much its swing grows in ten seconds.
double growth(const RollLoop& loop, double factor) {
  constexpr double dt_s = 1e-4;
  double angle = 1.0;
  double rate = 0.0;
  double canard = 0.0;
  double integral = 0.0;
  double estimate = 0.0;
  std::deque<double> waiting(static_cast<std::size_t>(std::lround(loop.delay_s / dt_s)), 0.0);
  double early = 0.0;
  double late = 0.0;
  for (int i = 0; i < 300'000; ++i) {
    const double f = loop.gain_factor;
    const double command = -f * (loop.proportional_gain * angle + loop.derivative_gain_s * rate) - integral - estimate;
    integral += dt_s * f * loop.integral_gain_per_s * angle;
    waiting.push_back(command);
    canard += dt_s / loop.servo_lag_s * (waiting.front() - canard);
    waiting.pop_front();
    const double acceleration = factor * loop.authority_per_s2 * canard - loop.damping_rate_per_s * rate;
    const ObserverModel& model = loop.observer;
    estimate += dt_s * model.bandwidth_rad_s *
                ((acceleration + model.damping_rate_per_s * rate) / model.authority_per_s2 - command - estimate);
    angle += dt_s * rate;
    rate += dt_s * acceleration;
    const double size = std::hypot(angle, 0.1 * rate);
    (i < 200'000 ? early : late) = std::max(i < 100'000 ? 0.0 : (i < 200'000 ? early : late), size);
  }
  return late / early;
}

TEST(Modes, PhaseMarginIsThatOfTheBlockDiagram) {
  for (const RollLoop& loop : {integrating(), observing()}) {
    const auto found = margins(loop);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->phase_margin_rad, phase_margin_on_grid_rad(loop), 1e-4);
    EXPECT_NEAR(std::abs(open_loop(loop, found->crossover_rad_s)), 1.0, 1e-9);
    EXPECT_EQ(phase_margin_rad(loop), found->phase_margin_rad);
  }
}

TEST(Modes, TheResponseIsThatOfTheBlockDiagram) {
  for (const RollLoop& loop : {integrating(), observing()}) {
    for (double w = 0.05; w < 60.0; w *= 1.3) {
      const Response found = response(loop, w);
      const Complex expected = open_loop(loop, w);
      EXPECT_NEAR(found.gain / std::abs(expected), 1.0, 1e-9) << w;
      EXPECT_NEAR(std::remainder(found.phase_rad - std::arg(expected), 2.0 * std::numbers::pi), 0.0, 1e-9) << w;
    }
  }
}

TEST(Modes, AtTheFrequencyOfTheGainMarginThePhaseIsHalfATurn) {
  for (const RollLoop& loop : {integrating(), observing()}) {
    const Margins found = margins(loop).value();
    const Complex there = open_loop(loop, found.half_turn_rad_s.value());
    EXPECT_NEAR(there.real() * *found.gain_margin, -1.0, 1e-9);
    EXPECT_NEAR(there.imag(), 0.0, 1e-9);
  }
}

TEST(Modes, TheLinearLoopBeginsToSwingAtTheGainMargin) {
  for (const RollLoop& loop : {integrating(), observing()}) {
    const double factor = margins(loop)->gain_margin.value();
    EXPECT_GT(factor, 1.0);
    EXPECT_LT(growth(loop, 0.98 * factor), 0.9);
    EXPECT_GT(growth(loop, 1.02 * factor), 1.1);
  }
}

// s^3 + (a + g b kd) s^2 + g b kp s + g b ki: by Routh's rule it swings with less than g = (ki / kp - a) / (b kd).
TEST(Modes, ALoopThatSwingsWithLessGainHasAGainMarginBelowOne) {
  RollLoop loop{.proportional_gain = 0.5,
                .derivative_gain_s = 0.5,
                .integral_gain_per_s = 2.0,
                .damping_rate_per_s = 0.3,
                .authority_per_s2 = 20.0};
  EXPECT_NEAR(margins(loop)->gain_margin.value(), (4.0 - 0.3) / 10.0, 1e-9);
  loop.servo_lag_s = 0.02;
  loop.delay_s = 0.005;
  const double factor = margins(loop)->gain_margin.value();
  EXPECT_LT(factor, 1.0);
  EXPECT_GT(margins(loop)->phase_margin_rad, 0.0);
  EXPECT_GT(growth(loop, 0.95 * factor), 1.05);
  EXPECT_LT(growth(loop, 1.05 * factor), 0.95);
}

TEST(Modes, OfSeveralPassesThroughOneTheLeastPhaseMarginCounts) {
  RollLoop loop{.proportional_gain = 0.02,
                .derivative_gain_s = 0.2,
                .integral_gain_per_s = 2.0,
                .damping_rate_per_s = 1.0,
                .authority_per_s2 = 60.0,
                .servo_lag_s = 0.02,
                .delay_s = 0.005};
  const auto found = margins(loop);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->phase_margin_rad, phase_margin_on_grid_rad(loop), 1e-4);
  EXPECT_LT(found->crossover_rad_s, 3.2) << "below the dip, not at the last pass";
  loop.authority_per_s2 = 6.0;
  EXPECT_NEAR(margins(loop)->phase_margin_rad, phase_margin_on_grid_rad(loop), 1e-4);
}

// With the true model and no lag the observer's loop is (f kp / s + f kd) (1 + w / s) b / (s + a) + w / s.
TEST(Modes, AnObserverWithTheTrueModelIsAnIntegratorBesideTheLoop) {
  RollLoop loop = observing();
  loop.observer.damping_rate_per_s = loop.damping_rate_per_s;
  loop.observer.authority_per_s2 = loop.authority_per_s2;
  loop.servo_lag_s = 0.0;
  loop.delay_s = 0.0;
  const double w = margins(loop)->crossover_rad_s;
  const Complex s{0.0, w};
  const Complex usual = (0.8 * 0.5 / s + 0.8 * 0.05) * 300.0 / (s + 8.0);
  EXPECT_NEAR(std::abs(usual * (1.0 + 6.0 / s) + 6.0 / s), 1.0, 1e-9);
}

TEST(Modes, AScheduleIsAFactorOnAllGains) {
  RollLoop loop = integrating();
  loop.gain_factor = 0.7;
  RollLoop less = integrating();
  less.proportional_gain *= 0.7;
  less.derivative_gain_s *= 0.7;
  less.integral_gain_per_s *= 0.7;
  EXPECT_NEAR(margins(loop)->phase_margin_rad, margins(less)->phase_margin_rad, 1e-12);
}

TEST(Modes, TheLoopOfAScenarioHasThoseOfItsPlan) {
  sim::Scenario scenario = input::load_scenario("tasha3_launch2", {});
  EXPECT_EQ(loop_at_speed(scenario, 60.0).integral_gain_per_s, 0.0);
  EXPECT_EQ(loop_at_speed(scenario, 60.0).observer.bandwidth_rad_s, 0.0);
  EXPECT_EQ(loop_at_speed(scenario, 60.0).gain_factor, 1.0);

  core::FlightPlan& plan = scenario.plan;
  plan.offset.rejection = core::OffsetRejection::integral;
  plan.offset.integral_gain_per_s = 0.5F;
  plan.gain_schedule = {.speeds_count = 2, .speeds_m_s = {40.0F, 80.0F}, .factors_count = 2, .factors = {2.0F, 1.0F}};
  EXPECT_EQ(loop_at_speed(scenario, 60.0).integral_gain_per_s, 0.5);
  EXPECT_NEAR(loop_at_speed(scenario, 60.0).gain_factor, 1.5, 1e-6);

  plan.offset.rejection = core::OffsetRejection::observer;
  plan.offset.observer_bandwidth_rad_s = 4.0F;
  plan.roll_model = {.roll_inertia_kg_m2 = 0.004F,
                     .reference_area_m2 = 5e-5F,
                     .damping_m2 = 8.0F,
                     .torque_m = 12.0F,
                     .density_kg_m3 = 1.2F};
  const RollLoop loop = loop_at_speed(scenario, 60.0);
  EXPECT_EQ(loop.integral_gain_per_s, 0.0);
  EXPECT_EQ(loop.observer.bandwidth_rad_s, 4.0);
  EXPECT_NEAR(loop.observer.damping_rate_per_s, 1.2 * 60.0 * 5e-5 * 8.0 / (2.0 * 0.004), 1e-5);
  EXPECT_NEAR(loop.observer.authority_per_s2, 1.2 * 60.0 * 60.0 * 5e-5 * 12.0 / (2.0 * 0.004), 1e-3);
}

}  // namespace
}  // namespace fantail::stability
