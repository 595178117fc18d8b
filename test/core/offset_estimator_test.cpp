// SPDX-License-Identifier: MIT
#include "core/offset_estimator.hpp"

#include "core/flight_plan_fields.hpp"
#include "known_roll_model.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

FlightPlan plan_with(OffsetRejection rejection) {
  FlightPlan plan = default_plan();
  plan.offset.rejection = rejection;
  plan.roll_model = known_roll_model;
  return plan;
}

Motion measured(float rate_rad_s = 0.0F, float speed_m_s = 60.0F) {
  Motion motion;
  motion.gyro = SensorState::fresh;
  motion.roll_rate_rad_s = rate_rad_s;
  motion.speed_m_s = speed_m_s;
  return motion;
}

/// An estimator in its loop: each tick it is shown what it is to see, and then what the law made of it.
class Loop {
 public:
  explicit Loop(const FlightPlan& plan) : Loop{plan, {-plan.controller.canard_limit, plan.controller.canard_limit}} {}
  Loop(const FlightPlan& plan, const AngleRange& reach) : plan_{plan}, reach_{reach}, estimator_{plan} {}

  void tick_with(const Motion& motion, Angle error, Angle excitation = {}, float gain_factor = 1.0F) {
    estimator_.update(motion, error, gain_factor, reach_);
    roll_ = pd_controller(plan_.controller, error, Angle{}, motion.roll_rate_rad_s, excitation,
                          {gain_factor, estimator_.estimate()});
    estimator_.remember(roll_);
  }
  void run(int ticks, const Motion& motion, Angle error, Angle excitation = {}, float gain_factor = 1.0F) {
    for (int i = 0; i < ticks; ++i) {
      tick_with(motion, error, excitation, gain_factor);
    }
  }
  void interrupt() { estimator_.interrupt(); }
  void begin(Angle offset) { estimator_.begin(offset); }

  [[nodiscard]] double estimate_deg() const { return static_cast<double>(estimator_.estimate().degrees()); }
  [[nodiscard]] Angle command() const { return roll_.command; }

 private:
  FlightPlan plan_;
  AngleRange reach_;
  OffsetEstimator estimator_;
  RollCommand roll_;
};

TEST(OffsetEstimator, APlanWithoutItEstimatesNothing) {
  Loop loop{plan_with(OffsetRejection::none)};
  loop.begin(5_deg);
  loop.run(1000, measured(1.0F), 10_deg);
  EXPECT_EQ(loop.estimate_deg(), 0.0);
}

TEST(Integral, GrowsWithTheErrorByItsGain) {
  Loop loop{plan_with(OffsetRejection::integral)};
  loop.run(1000, measured(), 2_deg);
  EXPECT_NEAR(loop.estimate_deg(), -0.5 * 2.0 * 1.0, 1e-4);
}

TEST(Integral, IsScheduledWithTheOtherGains) {
  Loop loop{plan_with(OffsetRejection::integral)};
  loop.run(1000, measured(), 2_deg, {}, 0.3F);
  EXPECT_NEAR(loop.estimate_deg(), -0.3 * 0.5 * 2.0 * 1.0, 1e-4);
}

// While v = kp e - d is beyond the limit L, d' = -ki e - (ki / kp)(L - v) = -(ki / kp)(L + d): d -> -L, from 0.
TEST(Integral, IsPulledBackByWhatTheLimitTakesOffTheCommand) {
  Loop loop{plan_with(OffsetRejection::integral)};
  loop.run(1500, measured(), 90_deg);
  EXPECT_EQ(loop.command(), 9_deg);
  EXPECT_NEAR(loop.estimate_deg(), -9.0 * (1.0 - std::exp(-1.5 * 0.5 / 0.5)),
              0.015);  // the first tick was not limited yet
  // Error gone, it is below the limit at once: nothing has to unwind.
  loop.tick_with(measured(), 0_deg);
  EXPECT_LT(loop.command(), 9_deg);
}

// With a canard that is stuck the others reach -4.5 to 6.75 only, and d stops there.
TEST(Integral, IsPulledBackByWhatTheCanardsCannotMake) {
  for (const auto& [error, end_deg] : {std::pair{90_deg, 6.75}, std::pair{-90_deg, -4.5}}) {
    Loop loop{plan_with(OffsetRejection::integral), {-4.5_deg, 6.75_deg}};
    loop.run(1500, measured(), error);
    EXPECT_NEAR(loop.estimate_deg(), -end_deg * (1.0 - std::exp(-1.5 * 0.5 / 0.5)), 0.02);
  }
}

TEST(Integral, IsNotMovedByAnExcitationThatMeetsTheLimit) {
  Loop loop{plan_with(OffsetRejection::integral)};
  loop.run(1000, measured(), 0_deg, 15_deg);
  EXPECT_EQ(loop.command(), 9_deg);
  EXPECT_EQ(loop.estimate_deg(), 0.0);
}

// A captured rocket is turned back by up to half a turn, and 18 degrees of it are all that the limit of 9 allows kp.
TEST(Integral, WithCaptureWaitsWhileTheAngleAloneAsksForMoreThanTheLimit) {
  FlightPlan plan = plan_with(OffsetRejection::integral);
  plan.controller.entry = ControlEntry::capture;
  Loop loop{plan};
  loop.begin(3_deg);
  for (const Angle error : {18.1_deg, -18.1_deg, 180_deg}) {
    loop.run(500, measured(), error);
    EXPECT_NEAR(loop.estimate_deg(), 3.0, 1e-6);
  }
  loop.run(500, measured(), 18.1_deg, {}, 1.5F);
  EXPECT_NEAR(loop.estimate_deg(), 3.0, 1e-6) << "with the factor of the schedule";
  loop.run(1, measured(), 17.9_deg, {}, 0.9F);
  EXPECT_NE(loop.estimate_deg(), 3.0);
}

double rad(double degrees) { return degrees * static_cast<double>(pi) / 180.0; }

TEST(Observer, FindsTheOffsetByItsBandwidthWhateverTheCanardsDo) {
  Loop loop{plan_with(OffsetRejection::observer)};
  RollingRocket rocket;
  for (int i = 0; i <= 300; ++i) {
    loop.tick_with(measured(static_cast<float>(rocket.rate_rad_s)), Angle::from_degrees(i % 100 < 50 ? 8.0F : -5.0F));
    if (i < 300) {
      rocket.turn(static_cast<double>(loop.command().radians()), rad(-4.8), 60.0);
    }
  }
  EXPECT_NEAR(loop.estimate_deg(), -4.8 * (1.0 - std::exp(-6.0 * 0.3)), 0.03);
}

TEST(Observer, GoesByTheSpeed) {
  Loop loop{plan_with(OffsetRejection::observer)};
  RollingRocket rocket;
  for (int i = 0; i <= 2000; ++i) {
    const double speed_m_s = 80.0 - 0.02 * i;
    loop.tick_with(measured(static_cast<float>(rocket.rate_rad_s), static_cast<float>(speed_m_s)), 0_deg);
    rocket.turn(static_cast<double>(loop.command().radians()), rad(3.0), speed_m_s);
  }
  EXPECT_NEAR(loop.estimate_deg(), 3.0, 0.03);
}

// As from an IMU whose own oscillator is 2 % slow. What the rate did meanwhile is seen with the next sample.
TEST(Observer, LosesNothingOfARateWhoseSampleComesATickLate) {
  Loop loop{plan_with(OffsetRejection::observer)};
  RollingRocket rocket;
  for (int i = 0; i <= 300; ++i) {
    Motion motion = measured(static_cast<float>(rocket.rate_rad_s));
    motion.gyro = i % 50 == 1 || i % 50 == 3 ? SensorState::coasting : SensorState::fresh;
    loop.tick_with(motion, i % 50 < 25 ? 8_deg : -5_deg);  // the rate changes most at the late samples
    rocket.turn(static_cast<double>(loop.command().radians()), rad(-4.8), 60.0);
  }
  EXPECT_NEAR(loop.estimate_deg(), -4.8 * (1.0 - std::exp(-6.0 * 0.3)), 0.05);
}

TEST(Observer, WaitsWhereTheSpeedTellsNothing) {
  for (const bool slow : {true, false}) {
    Loop loop{plan_with(OffsetRejection::observer)};
    Motion motion = measured(1.0F, slow ? 9.9F : 60.0F);
    motion.speed_is_lower_bound = !slow;
    loop.run(100, motion, 0_deg);
    EXPECT_EQ(loop.estimate_deg(), 0.0);
  }
}

// d' = w ((p' + a p) / b - u - d) with p' = 0 and d = 0, where a / b is alpha / (beta v).
TEST(Observer, BeginsWhereTheSpeedTellsEnoughAtTenMetresPerSecond) {
  Loop loop{plan_with(OffsetRejection::observer)};
  loop.tick_with(measured(0.25F, 10.0F), 0_deg);
  const auto command_rad = static_cast<double>(loop.command().radians());
  EXPECT_EQ(loop.estimate_deg(), 0.0);
  loop.tick_with(measured(0.25F, 10.0F), 0_deg);
  EXPECT_NEAR(rad(loop.estimate_deg()), 0.001 * 6.0 * (23.0 / (9.0 * 10.0) * 0.25 - command_rad), 1e-8);
}

class Either : public testing::TestWithParam<OffsetRejection> {
 protected:
  Loop loop{plan_with(GetParam())};
};

TEST_P(Either, BeginsWithWhatIsKnownOfTheOffsetWithinThePlanLimit) {
  for (const auto& [known, estimate_deg] :
       {std::pair{-4_deg, -4.0}, std::pair{30_deg, 9.0}, std::pair{-30_deg, -9.0}}) {
    loop.begin(known);
    EXPECT_NEAR(loop.estimate_deg(), estimate_deg, 1e-5);
  }
}

TEST_P(Either, StandsStillWhileNoRateIsMeasured) {
  loop.run(200, measured(), 2_deg);
  const double before_deg = loop.estimate_deg();
  EXPECT_NE(before_deg, 0.0);
  for (const auto& [state, lower_bound] : {std::pair{SensorState::failed, false}, std::pair{SensorState::lost, false},
                                           std::pair{SensorState::fresh, true}}) {
    Motion motion = measured(3.0F);
    motion.gyro = state;
    motion.rate_is_lower_bound = lower_bound;
    loop.run(500, motion, 20_deg);
    EXPECT_EQ(loop.estimate_deg(), before_deg);
  }
}

// What turned the rocket while nobody looked was not seen: the first rate behind a gap has nothing to be compared with.
TEST_P(Either, GoesOnBehindAGapWithoutAJump) {
  loop.run(200, measured(), 2_deg);
  const double before_deg = loop.estimate_deg();
  loop.interrupt();
  loop.tick_with(measured(5.0F), 2_deg);
  EXPECT_NEAR(loop.estimate_deg(), before_deg, 0.002);  // a tick's worth at most; 5 rad/s over a tick would be 7 deg
  loop.tick_with(measured(5.0F), 2_deg);
  EXPECT_NE(loop.estimate_deg(), before_deg);
  EXPECT_NEAR(loop.estimate_deg(), before_deg, 0.3);
}

TEST_P(Either, ATickWithoutAMeasuredRateIsAGapToo) {
  for (const bool lost : {true, false}) {
    Loop gap{plan_with(GetParam())};
    gap.run(200, measured(), 2_deg);
    const double before_deg = gap.estimate_deg();
    Motion unknown = measured(3.0F);
    unknown.gyro = lost ? SensorState::lost : SensorState::fresh;
    unknown.rate_is_lower_bound = !lost;
    gap.tick_with(unknown, 2_deg);
    gap.tick_with(measured(5.0F), 2_deg);
    EXPECT_NEAR(gap.estimate_deg(), before_deg, 0.002);  // as above
  }
}

TEST_P(Either, NeverGoesBeyondThePlanLimit) {
  for (const float sign : {1.0F, -1.0F}) {
    for (int i = 0; i < 5'000; ++i) {
      loop.tick_with(measured(sign * 0.01F * static_cast<float>(i)), Angle::from_degrees(sign * 3000.0F));
      ASSERT_LE(std::abs(loop.estimate_deg()), 9.0001);
    }
    EXPECT_NEAR(std::abs(loop.estimate_deg()), 9.0, 0.1);
  }
}

// An error of 30000 degrees asks for 15 degrees at once, and a rate that jumps by 50 rad/s for 70.
TEST_P(Either, StopsAtThePlanLimitItselfInTheTickThatWouldGoBeyondIt) {
  for (const float sign : {1.0F, -1.0F}) {
    Loop jumps{plan_with(GetParam())};
    jumps.tick_with(measured(), 0_deg);
    jumps.tick_with(measured(sign * 50.0F), Angle::from_degrees(sign * -30'000.0F));
    EXPECT_EQ(jumps.estimate_deg(), static_cast<double>((sign * 9_deg).degrees()));
  }
}

TEST_P(Either, ANumberThatIsNoneChangesNothing) {
  loop.run(200, measured(), 2_deg);
  loop.tick_with(measured(std::nanf("")), Angle::from_radians(std::nanf("")));
  loop.run(200, measured(), 2_deg);
  EXPECT_TRUE(std::isfinite(loop.estimate_deg()));
}

INSTANTIATE_TEST_SUITE_P(Both, Either, testing::Values(OffsetRejection::integral, OffsetRejection::observer),
                         [](const auto& each) {
                           return each.param == OffsetRejection::integral ? "Integral" : "Observer";
                         });

}  // namespace
}  // namespace fantail::core
