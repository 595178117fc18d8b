// SPDX-License-Identifier: MIT
// One canard through a step or a sine: what passes, and what is said of it.
#include <gtest/gtest.h>

#include "bench/sheet.hpp"
#include "lockstep.hpp"

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
  EXPECT_EQ(conclusions(step_of({}, 4.0)),
            std::vector<std::string>{"Canard 3 went to the angle commanded, in the time and at the speed required. A "
                                     "step does not show its other side, its trim and its backlash: fantail bench "
                                     "limits judges them."});
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
  EXPECT_EQ(conclusions(sine_of({}, 3.0, 2.0, 5)),
            std::vector<std::string>{"Canard 3 followed the sine as far as required, and stands at its trim. Its "
                                     "phase lag is not judged; fantail bench limits judges limits, "
                                     "backlash and speed."});
}

}  // namespace
}  // namespace fantail::bench
