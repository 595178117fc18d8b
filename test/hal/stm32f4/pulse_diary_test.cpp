// SPDX-License-Identifier: MIT
// What the servos hear through every kind of reset. Pages of the diary have a row a frame: milliseconds after the
// event, and the pulses of the four lines in microseconds, with a stroke behind each that was cut. The rocket of these
// tests turns faster than its canards can help, so they stand at the plan's limit of 9 degrees: 1410 us.
#include "pulse_diary.hpp"

#include "avionics/plan_on_bus.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using avionics::millisecond;
using test::PulseDiary;
using Heard = PulseDiary::Heard;

constexpr double us_per_deg = 10;
constexpr double trim_us = 1500;
constexpr double limit_us = 9 * us_per_deg;
constexpr double frame_us = 3000;

bool is_whole(const Heard& pulse) { return pulse.whole; }
bool is_inside(const Heard& pulse) { return std::abs(pulse.width_us - trim_us) < limit_us + 0.1; }

void fly_at_the_limit(PulseDiary& diary) {
  diary.disturbance_rad = 0.2;
  diary.launch_to_control();
  diary.fly_for(300 * millisecond);
}

TEST(PulseDiary, AtPowerUpNothingIsHeardBeforeTheFirstWholePulse) {
  PulseDiary diary;
  diary.fly_for(12 * millisecond);
  EXPECT_EQ(diary.page(0, 0, 12'000), R"(
   7.00: 1500 1500 1500 1500
  10.00: 1500 1500 1500 1500
)");
}

TEST(PulseDiary, ThroughAWholeFlightEachPulseIsWholeAndBetweenThePlansLimits) {
  PulseDiary diary;
  fly_at_the_limit(diary);
  const auto pulses = diary.since(0);
  EXPECT_GT(pulses.size(), 4 * 10 * 333U);
  EXPECT_TRUE(std::ranges::all_of(pulses, is_whole));
  EXPECT_TRUE(std::ranges::all_of(pulses, is_inside));
  EXPECT_NEAR(pulses.back().width_us, trim_us - limit_us, 0.1);
}

TEST(PulseDiary, ANewPlanMovesThePulsesByItsFirstMotionRateAndCutsNone) {
  PulseDiary diary;
  diary.run(4 * avionics::second);
  const double event = diary.now_us();
  core::FlightPlan plan = core::default_plan();
  plan.canards.each[1].trim = core::Angle::from_degrees(4.0F);
  avionics::send_plan(diary, plan);
  diary.run(avionics::second);
  const double most_us =
      static_cast<double>(plan.canards.first_motion_rate_rad_s) * 180 / 3.14159265 * us_per_deg * frame_us / 1e6 + 0.1;
  double last_us = trim_us;
  for (const Heard& pulse : diary.since(event)) {
    EXPECT_TRUE(is_whole(pulse) && is_inside(pulse));
    if (pulse.line == 1) {
      EXPECT_LE(std::abs(pulse.width_us - last_us), most_us);
      last_us = pulse.width_us;
    } else {
      EXPECT_NEAR(pulse.width_us, trim_us, 1.0);
    }
  }
  EXPECT_NEAR(last_us, 1540, 0.1);
}

TEST(PulseDiary, ACrashEndsInWholePulsesAtTrimAndSilenceUntilTheCommandsComeAgain) {
  PulseDiary diary;
  fly_at_the_limit(diary);
  const double event = diary.now_us();
  diary.crash();
  diary.reset_processor_after(ResetCause::software, event);
  diary.fly_for(20 * millisecond);
  EXPECT_EQ(diary.page(event, -5'000, 15'000), R"(
  -5.00: 1410 1410 1410 1410
  -2.00: 1410 1410 1410 1410
   1.00: 1500 1500 1500 1500
   9.52: 1410 1410 1410 1410
  12.52: 1410 1410 1410 1410
)");
}

TEST(PulseDiary, ACrashAtAnyTimeOfAFrameCutsNothingAndIsSilentForLessThanFourFrames) {
  for (int step = 0; step < 15; ++step) {
    const double later_us = step * frame_us / 15;
    PulseDiary diary;
    fly_at_the_limit(diary);
    diary.pass(later_us);
    const double event = diary.now_us();
    diary.crash();
    EXPECT_LE(diary.crash_took_us, 2 * frame_us);
    const auto last = diary.since(diary.now_us() - frame_us);
    EXPECT_TRUE(std::ranges::all_of(last, [](const Heard& each) { return std::abs(each.width_us - trim_us) < 0.1; }));
    const double reset = diary.now_us();
    diary.reset_processor_after(ResetCause::software, event, later_us);
    diary.fly_for(20 * millisecond);
    EXPECT_LE(diary.since(reset).front().begin_us - reset, PulseDiary::boot_us + later_us + frame_us);
    EXPECT_TRUE(std::ranges::all_of(diary.since(0), is_whole));
    EXPECT_TRUE(std::ranges::all_of(diary.since(0), is_inside));
  }
}

TEST(PulseDiary, AWatchdogResetMayCutFourPulsesAfterWhichNothingIsHeardUntilTheCommandsComeAgain) {
  PulseDiary diary;
  fly_at_the_limit(diary);
  const double event = diary.now_us();
  diary.pass(49'700);  // the loop hangs, the timer does not
  diary.reset_processor_after(ResetCause::watchdog, event);
  diary.fly_for(20 * millisecond);
  EXPECT_EQ(diary.page(event, 42'000, 62'000), R"(
  43.00: 1410 1410 1410 1410
  46.00: 1410 1410 1410 1410
  49.00: 700/ 700/ 700/ 700/
  56.70: 1410 1410 1410 1410
  59.70: 1410 1410 1410 1410
)");
}

TEST(PulseDiary, WhereverAWatchdogResetComesItCutsOneFrameAtMostAndNoPulseIsLonger) {
  int cut = 0;
  int resets = 0;
  for (int step = 0; step < 30; ++step) {
    const double bites_us = 34'000 + step * frame_us / 30;
    PulseDiary diary;
    fly_at_the_limit(diary);
    const double event = diary.now_us();
    diary.pass(bites_us);
    const double reset = diary.now_us();
    diary.reset_processor_after(ResetCause::watchdog, event);
    diary.fly_for(20 * millisecond);
    resets += 1;
    bool frame_is_cut = false;
    for (const Heard& pulse : diary.since(0)) {
      if (!pulse.whole) {
        EXPECT_NEAR(pulse.begin_us + pulse.width_us, reset, 0.1);
        EXPECT_LT(pulse.width_us, trim_us - limit_us + 0.1);
        frame_is_cut = true;
      } else {
        EXPECT_TRUE(is_inside(pulse));
      }
    }
    cut += frame_is_cut ? 1 : 0;
    EXPECT_LE(diary.since(reset).front().begin_us - reset, PulseDiary::boot_us + frame_us);
  }
  EXPECT_NEAR(static_cast<double>(cut) / resets, (trim_us - limit_us) / frame_us, 0.04);
}

// A supply that falls below the level of the brown-out reset: as the watchdog's, and Safe after it.
TEST(PulseDiary, AfterABrownOutThePulsesBeginWhereTheCanardsAreAndGoSlowlyToTrim) {
  PulseDiary diary;
  fly_at_the_limit(diary);
  diary.pass(1'900);
  const double event = diary.now_us();
  diary.timer.reset();
  diary.pass(20'000);  // until the supply is back
  diary.reset_processor_after(ResetCause::brown_out, event);
  diary.fly_for(500 * millisecond);
  EXPECT_EQ(diary.page(event, -4'000, 34'000), R"(
  -3.90: 1410 1410 1410 1410
  -0.90: 900/ 900/ 900/ 900/
  27.00: 1410 1410 1410 1410
  30.00: 1411 1411 1411 1411
  33.00: 1412 1412 1412 1412
)");
  EXPECT_NEAR(diary.since(0).back().width_us, trim_us, 0.1);
}

// The timer now counts at 16 MHz where it counted at 168. This timer does not know, so times here are those of its
// counts: of the 1410 us of the pulse 110 are left, and end as 10.5.
TEST(PulseDiary, WhenTheCrystalStopsThePulsesUnderWayEndWhenTheyWereToAndSilenceFollows) {
  PulseDiary diary;
  fly_at_the_limit(diary);
  diary.pass(2'300);
  const double event = diary.now_us();
  diary.stop_crystal();
  diary.reset_processor_after(ResetCause::software, event);
  diary.fly_for(20 * millisecond);
  EXPECT_EQ(diary.page(event, -4'000, 12'000), R"(
  -1.30: 1310 1310 1310 1310
   7.03: 1410 1410 1410 1410
  10.03: 1410 1410 1410 1410
)");
}

}  // namespace
}  // namespace fantail::hal::stm32f4
