// SPDX-License-Identifier: MIT

#include "core/autopilot.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"
#include "tunnel_run.hpp"

namespace fantail::core {
namespace {

constexpr Microseconds millisecond{1'000};

TEST(AutopilotResume, AGapEndsControlWithoutItAndDoesNotWithIt) {
  TunnelRun without;
  without.wait(60 * millisecond);
  EXPECT_EQ(without.law.step(without.inputs).reason, PhaseReason::timing_fault);

  TunnelRun with;
  const TickRecord& record = with.resume(60 * millisecond, 0.0F);
  EXPECT_EQ(record.phase, Phase::controlling);
  EXPECT_FALSE(record.timing_fault);
  EXPECT_EQ(record.command_status, CommandStatus::controlling);
}

TEST(AutopilotResume, TheRollAngleGoesOnByTheRateTimesTheGap) {
  TunnelRun rig;
  for (int i = 0; i < 100; ++i) {
    rig.tick(5.0F);
  }
  const float before = rig.tick(5.0F).motion.roll_angle.radians();
  EXPECT_NEAR(rig.resume(70 * millisecond, 5.0F).motion.roll_angle.radians() - before, 5.0F * 0.070F, 1e-4F);
}

TEST(AutopilotResume, ARateThatChangesEvenlyIsBridgedExactly) {
  TunnelRun rig;
  for (int i = 0; i < 100; ++i) {
    rig.tick(2.0F);
  }
  const float before = rig.tick(2.0F).motion.roll_angle.radians();
  EXPECT_NEAR(rig.resume(80 * millisecond, 10.0F).motion.roll_angle.radians() - before, 6.0F * 0.080F, 1e-4F);
}

FlightPlan integral_plan() {
  FlightPlan plan = tunnel_plan();
  plan.offset.rejection = OffsetRejection::integral;
  return plan;
}

TEST(AutopilotResume, TheEstimateOfTheOffsetIsThatFromBeforeTheGap) {
  TunnelRun rig{integral_plan()};
  for (int i = 0; i < 500; ++i) {
    rig.tick(0.1F);
  }
  const Angle first = rig.tick(0.1F).offset_estimate;
  const Angle before = rig.tick(0.1F).offset_estimate;
  EXPECT_GT(before, Angle{}) << "turned positively, it is off as a positive offset would turn it";
  const float a_tick = (before - first).radians();
  EXPECT_NEAR(rig.resume(70 * millisecond, 0.1F).offset_estimate.radians(), before.radians(), 1.2F * a_tick);
  EXPECT_GT(rig.tick(0.1F).offset_estimate, before);
}

// As in Integral.IsPulledBackByWhatTheLimitTakesOffTheCommand, from where the command meets its limit of 9 degrees:
// within 60 ms, in which the estimate grows by a tenth of a degree.
TEST(AutopilotResume, TheEstimateOfTheOffsetKnowsWhatTheLimitTookOffTheCommand) {
  TunnelRun rig{integral_plan()};
  for (int i = 0; i < 1500; ++i) {
    rig.tick(2.0F);
  }
  const TickRecord& record = rig.tick(2.0F);
  EXPECT_TRUE(record.saturated);
  EXPECT_NEAR(record.offset_estimate.degrees(), (9.0 - 5.73) * (1.0 - std::exp(-1.5 * 0.5 / 0.5)), 0.1);
}

TEST(AutopilotResume, TheEstimateOfTheOffsetWaitsForASilentGyro) {
  TunnelRun rig{integral_plan()};
  for (int i = 0; i < 500; ++i) {
    rig.tick(0.1F);
  }
  const Angle before = rig.tick(0.1F).offset_estimate;
  rig.inputs.gyro.quality = SampleQuality::absent;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(rig.tick(0.1F).offset_estimate, before);
  }
  EXPECT_EQ(rig.law.phase(), Phase::controlling);
}

TEST(AutopilotResume, NothingIsEstimatedOutsideOfControl) {
  TunnelRun rig{integral_plan()};
  for (int i = 0; i < 500; ++i) {
    rig.tick(0.1F);
  }
  rig.inputs.arm_switch_closed = false;
  while (rig.law.phase() == Phase::controlling && rig.inputs.time < 100'000 * millisecond) {
    rig.tick(0.1F);
  }
  EXPECT_NE(rig.law.phase(), Phase::controlling);
  EXPECT_EQ(rig.tick(0.1F).offset_estimate, Angle{});
}

TEST(AutopilotResume, WithoutAUsableSampleTheLastRateIsTakenToHaveStayed) {
  TunnelRun rig;
  for (int i = 0; i < 100; ++i) {
    rig.tick(4.0F);
  }
  const float before = rig.tick(4.0F).motion.roll_angle.radians();
  rig.inputs.gyro.quality = SampleQuality::absent;
  const TickRecord& first = rig.resume(60 * millisecond, 4.0F);
  EXPECT_NEAR(first.motion.roll_angle.radians() - before, 4.0F * 0.060F, 1e-4F);
  EXPECT_EQ(first.phase, Phase::controlling) << "one tick without a rate is not a failed gyro";
  EXPECT_EQ(first.command_status, CommandStatus::gyro_lost);
  rig.inputs.gyro.quality = SampleQuality::valid;
  EXPECT_EQ(rig.tick(4.0F).command_status, CommandStatus::controlling);
}

TEST(AutopilotResume, BeforeAnyRateWasMeasuredThereIsNothingToGoOnWith) {
  Autopilot law{tunnel_plan()};
  Inputs inputs{.time = 60 * millisecond};
  inputs.gyro = {.time = inputs.time, .rate_rad_s = {.x = 5.0F}, .quality = SampleQuality::valid};
  law.resume(inputs);
  const TickRecord& record = law.step(inputs);
  EXPECT_EQ(record.motion.roll_angle, Angle{});
  EXPECT_FALSE(record.motion.roll_is_bridged);
}

TEST(AutopilotResume, OfTwoGyrosTheOneIsBridgedWithThatHasASample) {
  FlightPlan plan = tunnel_plan();
  plan.sensors.gyros = GyroRule::two_agree;
  TunnelRun rig{plan};
  Angle before;
  for (int i = 0; i < 10; ++i) {
    rig.inputs.gyro.quality = SampleQuality::absent;
    rig.inputs.second_gyro = GyroSample{.time = rig.inputs.time + millisecond, .quality = SampleQuality::valid};
    before = rig.tick().motion.roll_angle;
  }
  rig.inputs.second_gyro = GyroSample{
      .time = rig.inputs.time + 70 * millisecond, .rate_rad_s = {.x = 5.0F}, .quality = SampleQuality::valid};
  // From 0 to 5 rad/s evenly over the gap.
  EXPECT_NEAR((rig.resume(70 * millisecond, 0.0F).motion.roll_angle - before).radians(), 2.5F * 0.070F, 1e-3F);
}

TEST(AutopilotResume, AGyroThatStaysSilentEndsControlAfterThePlansLongestGap) {
  TunnelRun rig;
  rig.tick(4.0F);
  rig.inputs.gyro.quality = SampleQuality::absent;
  rig.resume(60 * millisecond, 4.0F);
  Microseconds silent{};
  while (rig.tick().phase == Phase::controlling && silent < 1000 * millisecond) {
    silent += millisecond;
  }
  EXPECT_EQ(rig.law.phase(), Phase::finished);
  EXPECT_EQ(silent, rig.plan.motion.longest_gyro_gap);
}

// Spinning about an axis that leans: a rotation of more than a radian is still one. The tilt of the axis after a turn
// about the fixed axis n by the angle a is that of Rodrigues' formula.
TEST(AutopilotResume, TheAttitudeTurnsAsFarAsTheRatesSay) {
  TunnelRun rig;
  const float along = 10.0F;
  const float across = 3.0F;
  rig.inputs.gyro.rate_rad_s.y = across;
  rig.tick(along);
  const double rate = std::sqrt(static_cast<double>(along * along + across * across));
  const double before = static_cast<double>(rig.tick(along).motion.tilt.radians());
  const TickRecord& record = rig.resume(100 * millisecond, along);
  // Two ticks, the first by a trapezoid from zero, and the gap.
  const auto tilt_after = [&](double time) {
    const double share = static_cast<double>(along) / rate;
    return std::acos(share * share + (1.0 - share * share) * std::cos(rate * time));
  };
  EXPECT_NEAR(before, tilt_after(0.0015), 1e-4);
  EXPECT_NEAR(static_cast<double>(record.motion.tilt.radians()), tilt_after(0.1015), 2e-4);
}

TEST(AutopilotResume, ReferenceAndExcitationAreThoseOfTheTimeAsIfNothingHadBeen) {
  FlightPlan plan = tunnel_plan();
  plan.reference.kind = ReferenceKind::square_wave;
  plan.excitation.form = ExcitationForm::sweep;
  plan.excitation.begin = Microseconds{0};
  plan.excitation.end = Microseconds{5'000'000};
  plan.excitation.amplitude_variation = Angle::from_radians(0.01F);
  plan.excitation.frequency_variation_hz = 0.3F;
  for (const int gap_ms : {20, 60, 250}) {
    TunnelRun interrupted{plan};
    TunnelRun other{plan};
    for (int i = 0; i < 777; ++i) {
      interrupted.tick();
      other.tick();
    }
    interrupted.resume(gap_ms * millisecond, 0.0F);
    for (int i = 0; i < gap_ms; ++i) {
      other.tick();
    }
    for (int i = 0; i < 500; ++i) {
      const TickRecord& one = interrupted.tick();
      const TickRecord& two = other.tick();
      ASSERT_EQ(one.time, two.time);
      ASSERT_EQ(one.reference, two.reference);
      ASSERT_EQ(one.excitation, two.excitation);
    }
  }
}

TEST(AutopilotResume, ACanardThatWasPushedAsideInTheGapIsNotCondemned) {
  TunnelRun rig;
  rig.tick();
  const Angle aside = Angle::from_radians(0.15F);
  rig.inputs.encoders.fill(aside);
  rig.resume(60 * millisecond, 0.0F);
  // Its servo brings it back as the model of it expects.
  float left = aside.radians();
  for (int i = 0; i < 300; ++i) {
    left *= 1.0F - 1.0F / 25.0F;
    rig.inputs.encoders.fill(Angle::from_radians(left));
    for (const CanardVerdict verdict : rig.tick().verdicts) {
      ASSERT_EQ(verdict, CanardVerdict::healthy) << i;
    }
  }
}

TEST(AutopilotResume, AnEncoderThatWasSilentBeforeTheGapIsNotDeadBecauseOfIt) {
  TunnelRun rig;
  rig.inputs.encoders[2].reset();
  rig.tick();
  EXPECT_EQ(rig.resume(60 * millisecond, 0.0F).verdicts[2], CanardVerdict::healthy);
}

}  // namespace
}  // namespace fantail::core
