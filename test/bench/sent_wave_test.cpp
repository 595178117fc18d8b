// SPDX-License-Identifier: MIT
// A canard is judged by a sine only if that is what it was commanded, on the rocket's clock.
#include <algorithm>
#include <utility>

#include <gtest/gtest.h>

#include "bench/measurement.hpp"
#include "bench/sheet.hpp"
#include "json/value.hpp"
#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

const sim::CanardTolerances tolerances{};

Sheet sine_sheet(Bench& bench, double amplitude_deg, double frequency_hz, int cycles) {
  const Exercise exercise = Exercise::sine(
      six_degrees(), 1, {.amplitude_rad = amplitude_deg * degree, .frequency_hz = frequency_hz, .cycles = cycles});
  return examine(bench.record(exercise), exercise, tolerances, {});
}

Sheet at_steps_of(int step_ms, double frequency_hz, int cycles = 20) {
  Bench bench{.requests_every_ms = step_ms};
  return sine_sheet(bench, 3.0, frequency_hz, cycles);
}

const Check& ratio_of(const Sheet& sheet) {
  return *std::ranges::find(sheet.canards.front().alone->checks, Measure::amplitude_ratio, &Check::measure);
}

TEST(SentWave, APcThatKeepsItsPaceSendsTheSineAtEachFrequency) {
  for (const double frequency_hz : {0.5, 2.0, 8.0, 20.0, 33.0, 50.0}) {
    for (const int step_ms : {1, 5, 6, 7}) {
      const Sheet sheet = at_steps_of(step_ms, frequency_hz, frequency_hz < 1.0 ? 2 : 20);
      EXPECT_TRUE(sheet.doubts.empty()) << frequency_hz << " Hz, " << step_ms << " ms: " << sheet.doubts.front();
    }
  }
}

TEST(SentWave, AStaircaseIsJudgedUpToASixthOfThePeriod) {
  for (const auto& [frequency_hz, longest_ms] : {std::pair{2.0, 83}, {4.0, 41}, {8.0, 20}}) {
    EXPECT_EQ(at_steps_of(longest_ms, frequency_hz).judgement(), Judgement::pass) << frequency_hz;
    EXPECT_EQ(at_steps_of(longest_ms + longest_ms / 5, frequency_hz).judgement(), Judgement::none) << frequency_hz;
  }
}

TEST(SentWave, WhatWasNotTheSineIsSaidInItsNumbers) {
  const std::string said = conclusions(at_steps_of(60, 8.0)).front();
  EXPECT_TRUE(said.starts_with("The rocket did not receive the requested sine: at 8 Hz its amplitude was 1.")) << said;
  EXPECT_NE(said.find(" instead of 3.00 deg. It stood still for up to 0.060 s and differed by "), std::string::npos)
      << said;
}

TEST(SentWave, WithoutAVerdictTheFileSaysNothingOfTheCanard) {
  const json::Value sheet = json::parse(sheet_json(at_steps_of(60, 8.0)));
  EXPECT_EQ(sheet["judgement"], "none");
  const json::Value& canard = sheet["canards"][0];
  EXPECT_TRUE(canard["passed"].is_null());
  EXPECT_EQ(canard["cause"], "not_judged");
  EXPECT_EQ(canard["sentence"], "Canard 2 is not judged.");
}

TEST(SentWave, ASineThatIsSlowerOnTheRocketsClockIsNotTheOneAskedFor) {
  Bench slower{.pace = 0.97};
  EXPECT_EQ(sine_sheet(slower, 3.0, 8.0, 20).judgement(), Judgement::none);
}

TEST(SentWave, MarksThatComeLateAndAnglesCutOffAtTheLimitChangeNothing) {
  Bench late{.marks_late_ms = 30, .marks_scatter_ms = 40};
  EXPECT_TRUE(sine_sheet(late, 3.0, 8.0, 20).doubts.empty());
  Bench wide;
  EXPECT_TRUE(sine_sheet(wide, 20.0, 2.0, 5).doubts.empty());
}

// The bound is where it is because up to there a verdict hardly depends on how the sine was sent.
TEST(SentWave, UpToTheBoundTheRoomOfACanardChangesByLessThanAQuarterOfWhatMayBeMissing) {
  for (const double frequency_hz : {4.0, 8.0}) {
    for (const double lag_s : {0.010, 0.036, 0.070}) {
      for (const double fastest_deg_s : {170.0, 1000.0}) {
        constexpr double amplitude_deg = 5.0;
        const auto room_deg = [&](int step_ms) {
          Bench bench{.requests_every_ms = step_ms};
          bench.canards[1].lag_s = lag_s;
          bench.canards[1].fastest_rad_s = fastest_deg_s * degree;
          const Sheet sheet = sine_sheet(bench, amplitude_deg, frequency_hz, 10);
          EXPECT_TRUE(sheet.doubts.empty());
          return amplitude_deg * (*ratio_of(sheet).value - *ratio_of(sheet).lowest);
        };
        EXPECT_NEAR(room_deg(static_cast<int>(166.0 / frequency_hz)), room_deg(1), 0.25 * tolerances.reach_rad / degree)
            << frequency_hz << " Hz, " << lag_s << " s, " << fastest_deg_s << " deg/s";
      }
    }
  }
}

TEST(SentWave, ASmallerCommandDoesNotWidenTheRangeThatIsAllowed) {
  for (const int step_ms : {1, 20, 60, 80}) {
    EXPECT_NEAR(*ratio_of(at_steps_of(step_ms, 8.0)).highest, 1.0 + 0.5 / 3.0, 0.01) << step_ms;
  }
}

}  // namespace
}  // namespace fantail::bench
