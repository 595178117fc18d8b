// SPDX-License-Identifier: MIT
// One canard through a step or a sine: what passes, and what is said of it.

#include "bench/exercise.hpp"
#include "bench/sheet.hpp"
#include "json/value.hpp"
#include "lockstep.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

Sheet step_of(const LockStep& rocket, double to_deg) {
  const Exercise exercise = Exercise::step(rocket.bounds(), 2, to_deg * LockStep::degree);
  return examine(rocket.record(exercise), exercise, {}, {});
}

Sheet sine_of(const LockStep& rocket, double amplitude_deg, double frequency_hz, int cycles) {
  const Exercise exercise = Exercise::sine(
      rocket.bounds(), 2,
      {.amplitude_rad = amplitude_deg * LockStep::degree, .frequency_hz = frequency_hz, .cycles = cycles});
  return examine(rocket.record(exercise), exercise, {}, {});
}

void expect_cause(const Sheet& sheet, Cause cause, const std::string& words) {
  EXPECT_EQ(sheet.judgement(), Judgement::fail);
  EXPECT_EQ(name(sheet.canards.front().diagnosis.cause), name(cause));
  const std::string said = conclusions(sheet).front();
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

LockStep wrong_trim(double off_deg) {
  LockStep rocket;
  rocket.servo[2].pulse_centre_us += 10.0 * off_deg;
  return rocket;
}

LockStep slipping() {
  LockStep rocket;
  rocket.fault[2] = sim::ServoFault::slipping;
  return rocket;
}

TEST(StepOfOneCanard, AHealthyOnePassesToEachAngle) {
  LockStep rocket;
  rocket.plan.controller.canard_limit = core::Angle::from_degrees(15.0F);
  rocket.plan.canards.each[2].trim = core::Angle::from_degrees(1.5F);
  for (const double to_deg : {-20.0, -8.0, -1.0, 0.5, 3.0, 12.0}) {
    const Sheet sheet = step_of(rocket, to_deg);
    EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
  }
}

TEST(StepOfOneCanard, OneThatDoesNotGetThereFails) {
  expect_cause(step_of(slipping(), 5.0), Cause::slipping, "commanded to +5.00 deg, it reached +");
  expect_cause(step_of(slipping(), -5.0), Cause::slipping, "commanded to -5.00 deg, it reached -");
}

TEST(StepOfOneCanard, OneThatStandsOffItsTrimFails) {
  for (const double off_deg : {-3.0, 0.8, 3.0}) {
    expect_cause(step_of(wrong_trim(off_deg), 4.0), Cause::wrong_trim, "at its trim and at the angle commanded");
  }
}

TEST(StepOfOneCanard, OneWithMuchPlayIsNotCalledSlipping) {
  LockStep rocket;
  rocket.servo[2].backlash_rad = 1.6 * LockStep::degree;
  expect_cause(step_of(rocket, 4.0), Cause::out_of_tolerance, "reached");
}

TEST(StepOfOneCanard, APassSaysWhatWasJudgedAndWhatWasNot) {
  EXPECT_EQ(
      conclusions(step_of({}, 4.0)),
      std::vector<std::string>{"Canard 3 went to the commanded angle in the required time and at the required speed. A "
                               "step does not show its other side, its trim and its backlash: fantail bench "
                               "limits judges them."});
}

TEST(StepOfOneCanard, WithoutAFaultIsCalledHealthyNowhere) {
  for (const Sheet& sheet : {step_of({}, 4.0), sine_of({}, 3.0, 2.0, 5)}) {
    const json::Value all = json::parse(sheet_json(sheet));
    EXPECT_EQ(all["canards"][0]["passed"], true);
    EXPECT_EQ(all["canards"][0]["cause"], "no_fault_seen");
    EXPECT_EQ(all["canards"][0]["sentence"],
              "Canard 3 shows no fault here: every judged figure is within its tolerance.");
  }
}

TEST(SineOfOneCanard, AHealthyOnePassesAtEachFrequencyAndAmplitude) {
  LockStep rocket;
  rocket.plan.controller.canard_limit = core::Angle::from_degrees(20.0F);
  rocket.plan.canards.each[2].trim = core::Angle::from_degrees(-1.5F);
  for (const double frequency_hz : {0.5, 2.0, 8.0, 20.0, 50.0}) {
    for (const double amplitude_deg : {0.5, 3.0, 12.0, 20.0}) {
      for (const int waves : {1, 3, 10}) {
        if (waves / frequency_hz < 0.1 || (frequency_hz < 1.0 && waves > 1)) {
          continue;
        }
        const Sheet sheet = sine_of(rocket, amplitude_deg, frequency_hz, waves);
        EXPECT_TRUE(sheet.passed()) << frequency_hz << " Hz, " << waves << " waves\n" << sheet_text(sheet);
      }
    }
  }
}

TEST(SineOfOneCanard, OneThatDoesNotGoAsFarFails) {
  expect_cause(sine_of(slipping(), 5.0, 1.0, 4), Cause::out_of_tolerance, "amplitude ratio 0.");
}

TEST(SineOfOneCanard, OneThatIsTooSlowForAServoWithinTheTolerancesFails) {
  LockStep late;
  late.servo[2].lag_s = 0.1;
  LockStep weak;
  weak.servo[2].rate_limit_rad_s = 60.0 * LockStep::degree;
  expect_cause(sine_of(late, 5.0, 4.0, 8), Cause::out_of_tolerance, "amplitude ratio 0.");
  expect_cause(sine_of(weak, 5.0, 4.0, 8), Cause::out_of_tolerance, "amplitude ratio 0.");
}

TEST(SineOfOneCanard, OneThatGoesTooFarFails) {
  LockStep rocket;
  rocket.servo[2].pulse_per_degree_us *= 0.8;
  expect_cause(sine_of(rocket, 5.0, 1.0, 4), Cause::out_of_tolerance, "amplitude ratio 1.");
}

TEST(SineOfOneCanard, OneThatStandsOffItsTrimFails) {
  for (const double off_deg : {-3.0, 1.0}) {
    expect_cause(sine_of(wrong_trim(off_deg), 3.0, 1.0, 3), Cause::wrong_trim, "at rest it is off its trim by");
  }
}

TEST(SineOfOneCanard, APassSaysWhatWasJudgedAndWhatWasNot) {
  EXPECT_EQ(
      conclusions(sine_of({}, 3.0, 2.0, 5)),
      std::vector<std::string>{"Canard 3 followed the sine with the required amplitude, and stands at its trim. Its "
                               "phase lag is not judged; fantail bench limits judges limits, "
                               "backlash and speed."});
}

std::string refusal(const Exercise& exercise) {
  try {
    expect_enough_movement(exercise, 2, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

std::string step_refusal(double trim_deg, double to_deg, double limit_deg = 6.0) {
  Bounds bounds;
  bounds.limit_rad.fill(limit_deg * LockStep::degree);
  bounds.centre_rad.fill(trim_deg * LockStep::degree);
  return refusal(Exercise::step(bounds, 2, to_deg * LockStep::degree));
}

std::string sine_refusal(double amplitude_deg, double frequency_hz, double limit_deg = 20.47) {
  Bounds bounds;
  bounds.limit_rad.fill(limit_deg * LockStep::degree);
  return refusal(Exercise::sine(
      bounds, 2, {.amplitude_rad = amplitude_deg * LockStep::degree, .frequency_hz = frequency_hz, .cycles = 10}));
}

TEST(LeastMovement, AStepThatTheTolerancesHideIsRefused) {
  EXPECT_EQ(step_refusal(0.0, 0.3),
            "--to: canard 3 would step from its trim of 0.00 deg to 0.30 deg, by 0.30 deg; the angle must be at most "
            "-1.25 or at least 1.25 deg. With reach_deg 0.5, centring_deg 0.5 and half of backlash_deg 0.5, a canard "
            "that does not move may be 1.25 deg off");
  EXPECT_NE(step_refusal(0.0, 0.0), "");
  EXPECT_NE(step_refusal(2.0, 2.0), "");
  EXPECT_NE(step_refusal(2.0, 1.0).find("at most 0.75 or at least 3.25 deg"), std::string::npos);
  EXPECT_NE(step_refusal(5.0, 20.0).find("to 6.00 deg, by 1.00 deg; the angle must be at most 3.75 deg"),
            std::string::npos);
  EXPECT_NE(step_refusal(0.0, 1.0, 1.0).find("no angle within its limit of 1.00 deg is large enough"),
            std::string::npos);
  EXPECT_EQ(step_refusal(0.0, 1.25), "");
  EXPECT_EQ(step_refusal(2.0, 0.0), "");
}

TEST(LeastMovement, ASineThatTheTolerancesHideIsRefused) {
  EXPECT_EQ(
      sine_refusal(0.2, 2.0),
      "--amplitude: canard 3 would move 0.20 deg to each side; at 2 Hz it must be 1.10 to 20.47 deg. Below that, "
      "reach_deg 0.5 and backlash_deg 0.5 hide too much of the movement of a canard with longest_step_time_s 0.08");
  EXPECT_NE(sine_refusal(20.0, 50.0, 6.0).find("within its limit of 6.00 deg; at 50 Hz it must be 11."),
            std::string::npos);
  for (const auto& [amplitude_deg, frequency_hz] : {std::pair{1.1, 2.0}, {3.0, 8.0}, {5.0, 20.0}, {12.0, 50.0}}) {
    EXPECT_EQ(sine_refusal(amplitude_deg, frequency_hz), "") << frequency_hz << " Hz";
  }
  sim::CanardTolerances coarse;
  coarse.reach_rad = 5.0 * LockStep::degree;
  EXPECT_TRUE(std::isinf(least_amplitude_rad(8.0, coarse)));
}

// At the least step and amplitude allowed.
TEST(LeastMovement, ACanardThatStandsStillFailsAndOneWithAllThePlayAllowedPasses) {
  const double least_step_deg = least_step_rad({}) / LockStep::degree;
  LockStep torn;
  torn.fault[2] = sim::ServoFault::dead;
  LockStep loose;
  loose.servo[2].backlash_rad = 0.5 * LockStep::degree;
  EXPECT_EQ(step_of(torn, least_step_deg + 0.01).judgement(), Judgement::fail);
  for (const double frequency_hz : {1.0, 2.0, 8.0}) {
    const double least_deg = least_amplitude_rad(frequency_hz, {}) / LockStep::degree;
    EXPECT_EQ(sine_of(torn, least_deg, frequency_hz, 4).judgement(), Judgement::fail) << frequency_hz;
    const Sheet sheet = sine_of(loose, least_deg, frequency_hz, 4);
    EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
  }
  const Sheet sheet = step_of(loose, least_step_deg);
  EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
}

}  // namespace
}  // namespace fantail::bench
