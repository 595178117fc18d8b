// SPDX-License-Identifier: MIT
#include "sim/fin_wash.hpp"

#include "jammed_canards.hpp"
#include "sim/deflection_range.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

TEST(FinWash, TheFinsTakeTheirShareADistanceLater) {
  FinWash wash{0.4, 0.5};
  for (int step = 0; step < 40; ++step) {
    // The canards turn at step 10; the air passes 0.1 m in a step, so the fins meet it five steps later.
    const double taken_rad = wash.step(step < 10 ? 0.0 : 0.2, 0.1);
    EXPECT_NEAR(taken_rad, step < 15 ? 0.0 : 0.08, 1e-12) << step;
    EXPECT_EQ(wash.angle_rad(), taken_rad);
  }
}

TEST(FinWash, AFractionOfAStepLaterIsTheMeanOfTwoSteps) {
  FinWash wash{1.0, 0.53};
  for (int step = 0; step < 40; ++step) {
    const double taken_rad = wash.step(step < 10 ? 0.0 : 0.2, 0.1);
    EXPECT_NEAR(taken_rad, step < 15 ? 0.0 : step == 15 ? 0.7 * 0.2 : 0.2, 1e-12) << step;
  }
}

TEST(FinWash, WithoutADistanceTheFinsAnswerAtOnce) {
  FinWash wash{0.3, 0.0};
  EXPECT_NEAR(wash.step(0.1, 0.02), 0.03, 1e-15);
  EXPECT_NEAR(wash.step(-0.2, 0.01), -0.06, 1e-15);
}

// Whatever the speed does on the way, it is the air that was at the canards half a metre before.
TEST(FinWash, FollowsTheAirAndNotTheClock) {
  FinWash wash{0.5, 0.5};
  double path_m = 0.0;
  for (int step = 0; step < 400; ++step) {
    const double path_of_step_m = 1e-4 * (1 + step % 90);
    const auto canard_rad = [](double at_m) { return at_m < 0.0 ? 0.0 : at_m; };
    const double middle_m = path_m + 0.5 * path_of_step_m;
    const double taken_rad = wash.step(canard_rad(middle_m), path_of_step_m);
    EXPECT_NEAR(taken_rad, 0.5 * canard_rad(middle_m - 0.5), 0.5 * 0.009);
    path_m += path_of_step_m;
  }
  const double before_rad = wash.angle_rad();
  EXPECT_EQ(wash.step(7.0, 0.0), before_rad) << "in still air nothing moves on";
  EXPECT_EQ(wash.step(7.0, -0.1), before_rad) << "nor in air from behind";
}

// 30 m at a centimetre a second are 3 million steps.
TEST(FinWash, SlowAirTakesItsTimeAndNoMemoryToSpeakOf) {
  FinWash wash{1.0, 30.0};
  double taken_rad = 0.0;
  for (int step = 0; step < 2'999'000; ++step) {
    taken_rad = wash.step(0.1, 1e-5);
  }
  EXPECT_EQ(taken_rad, 0.0);
  for (int step = 0; step < 10'000; ++step) {
    taken_rad = wash.step(0.1, 1e-5);
  }
  EXPECT_NEAR(taken_rad, 0.1, 1e-6);
}

TEST(FinWash, LeavesItsShareOfTheRollRateAndReversesItWhenItIsMoreThanAll) {
  for (const double share : {0.0, 0.3, 1.0, 1.2}) {
    const Scenario s = jammed({9.0, 9.0, 9.0, 9.0}, {"aerodynamics.canard_wash=" + std::to_string(share),
                                                     "aerodynamics.canard_wash_distance_m=1.1"});
    EXPECT_NEAR(steady_rate_deg_s(s), tunnel_m_s * beta_m * (1.0 - share) * 9.0 / alpha_m2, 1e-6) << share;
  }
}

// Canards that turn at once: the rate rises as it would without wash, and the fins answer the same again, later.
TEST(FinWash, TheRollRateAfterAStepIsTheSumOfTwoExponentials) {
  const double inertia_kg_m2 = 0.00393;
  const double area_m2 = 5.0265e-5;
  const double damping_per_s = 0.5 * 1.2 * tunnel_m_s * area_m2 * alpha_m2 / inertia_kg_m2;
  const double final_rad_s = tunnel_m_s * beta_m * 8.0 * degree / alpha_m2;
  const auto without_wash = [&](double time_s) {
    return time_s > 0.0 ? -final_rad_s * std::expm1(-damping_per_s * time_s) : 0.0;
  };
  const FlownWorld flown =
      fly(jammed({8.0, 8.0, 8.0, 8.0},
                 {"aerodynamics.canard_wash=0.7", "aerodynamics.canard_wash_distance_m=2.2",
                  "controller.proportional_gain=0", "controller.derivative_gain_s=0", "servo.backlash_deg=0"}));
  std::optional<double> from_s;
  for (const Tick& tick : flown.ticks) {
    // Before control the self-test turns the canards; its wash is gone by then.
    if (tick.time_s > 0.3 && (from_s || tick.truth.canard_rad > 1.0 * degree)) {
      from_s = from_s.value_or(tick.time_s);
      const double time_s = tick.time_s - *from_s;  // the fins answer 2.2 m / 22 m/s later
      ASSERT_NEAR(tick.truth.roll_rate_rad_s, without_wash(time_s) - 0.7 * without_wash(time_s - 0.1), 1e-9) << time_s;
    }
  }
  ASSERT_TRUE(from_s);
  EXPECT_NEAR(*from_s, 0.5, 0.002);
}

TEST(FinWash, IsInTheReachOfTheCanardsAndAboveOneTurnsItRound) {
  Scenario s = scenario("tasha3_launch2", {"aerodynamics.canard_wash=0.25"});
  EXPECT_NEAR(deflection_range(s).highest_rad / degree, 0.75 * 9.0, 1e-5);
  EXPECT_NEAR(deflection_range(s).lowest_rad / degree, -0.75 * 9.0, 1e-5);
  EXPECT_NEAR(canard_response(s).effectiveness, 1.0, 1e-6) << "the fins are another matter";
  s.vehicle.canard_air.wash = 1.5;
  EXPECT_NEAR(deflection_range(s).highest_rad / degree, -0.5 * 9.0, 1e-5);
  EXPECT_NEAR(deflection_range(s).lowest_rad / degree, 0.5 * 9.0, 1e-5);
}

// Below one the loop settles where the canards with what the fins leave balance the offset; above, it runs away.
TEST(FinWash, IsFlownToWhereTheLawSettlesOrAway) {
  const std::vector<std::string> changes{"disturbance.angles_deg=[2]", "tunnel.swirl_deg=0", "tunnel.turbulence=0",
                                         "reference.kind=hold", "run.control_time_s=12"};
  const auto angle_deg = [&](const char* wash) {
    std::vector<std::string> all = changes;
    all.push_back(std::string{"aerodynamics.canard_wash="} + wash);
    all.emplace_back("aerodynamics.canard_wash_distance_m=0.9");
    return fly("tunnel_steps", all).at(11.9).truth.roll_angle_rad / degree;
  };
  EXPECT_NEAR(angle_deg("0.5"), 2.0 / (0.5 * (1.0 - 0.5)), 0.4);
  EXPECT_GT(angle_deg("1.3"), 180.0);
}

}  // namespace
}  // namespace fantail::sim
