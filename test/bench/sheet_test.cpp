// SPDX-License-Identifier: MIT
#include "bench/sheet.hpp"

#include "json/value.hpp"
#include "synthetic.hpp"
#include "test.hpp"

namespace fantail::bench {
namespace {

const sim::CanardTolerances usual{};

Sheet sheet_of(Bench bench, const Exercise& exercise = Exercise::limits(six_degrees()), const Heading& heading = {}) {
  return examine(bench.record(exercise), exercise, usual, heading);
}

Cause cause_of(const Bench& bench, std::size_t canard = 2) { return sheet_of(bench).canards[canard].diagnosis.cause; }

TEST(Diagnosis, AnAvionicsThatGoesBeyondItsLimitIsTheFirstThingSaid) {
  Bench bench;
  bench.commands_beyond_rad = 0.1 * degree;
  bench.canards[2].gain = -1.0;
  const Sheet sheet = sheet_of(bench);
  EXPECT_FALSE(sheet.passed());
  for (const CanardResult& result : sheet.canards) {
    EXPECT_EQ(result.diagnosis.cause, Cause::limit_not_kept);
  }
  EXPECT_NE(sentence(2, sheet.canards[2].diagnosis).find("6.10 deg; its limit is 6.00 deg"), std::string::npos);
}

TEST(Diagnosis, ALimitThatIsKeptToTheResolutionOfTheBusIsKept) {
  Bench bench;
  bench.commands_beyond_rad = 0.01 * degree;
  EXPECT_EQ(cause_of(bench), Cause::healthy);
}

TEST(Diagnosis, ANoisyEncoderIsNotTakenForAnythingElse) {
  Bench bench;
  bench.canards[2].noise_rad = 4.0 * degree;
  bench.canards[2].gain = 0.0;
  EXPECT_EQ(cause_of(bench), Cause::encoder_noisy);
}

TEST(Diagnosis, ASlowCanardIsNotTakenForALooseOrASlippingOne) {
  Bench bench;
  bench.canards[2].lag_s = 0.25;
  EXPECT_EQ(cause_of(bench), Cause::slow);
}

TEST(Diagnosis, ASlippingCanardThatStandsOffItsCentreStillSlips) {
  Bench bench;
  bench.canards[2].gain = 0.6;
  bench.canards[2].offset_rad = 0.8 * degree;
  EXPECT_EQ(cause_of(bench), Cause::slipping);
}

TEST(Diagnosis, ACanardThatMovesTooFarHasNoSingleCause) {
  Bench bench;
  bench.canards[2].gain = 1.2;
  EXPECT_EQ(cause_of(bench), Cause::out_of_tolerance);
}

TEST(Diagnosis, AnEncoderThatSometimesFailsIsNotUnplugged) {
  Bench bench;
  bench.canards[2].dropout_share = 0.02;
  const Sheet sheet = sheet_of(bench);
  EXPECT_EQ(sheet.canards[2].diagnosis.cause, Cause::out_of_tolerance);
  EXPECT_NE(sheet.canards[2].diagnosis.seen.find("encoder dropouts"), std::string::npos);
}

// Four servos and four encoders that are all mounted the other way round agree with each other.
TEST(Diagnosis, APassSaysWhatNoEncoderShows) {
  const std::vector<std::string> said = conclusions(sheet_of(Bench{}));
  ASSERT_EQ(said.size(), 2U);
  EXPECT_TRUE(said[1].starts_with("Encoders do not show which way a canard rolls the rocket.")) << said[1];
}

TEST(Diagnosis, ClampingThatIsNotReportedFails) {
  Bench bench;
  bench.reports_limited = false;
  const Sheet sheet = sheet_of(bench);
  EXPECT_FALSE(sheet.passed());
  EXPECT_NE(sheet.canards[0].diagnosis.seen.find("did not report"), std::string::npos);
}

TEST(Diagnosis, ACanardThatGoesAlongWithAnotherIsNamed) {
  Bench bench;
  bench.canards[3].answers_to = 2;
  EXPECT_EQ(cause_of(bench, 2), Cause::wrong_canard_moves);  // canard 4 moves too
  EXPECT_EQ(cause_of(bench, 3), Cause::dead);                // and not when it should
}

// The supply sags when all four pull at it.
TEST(Diagnosis, ACanardThatIsSlowOnlyWithTheOthersSaysSo) {
  const Exercise exercise = Exercise::limits(six_degrees());
  Bench sound;
  Bench sagging;
  sagging.canards[2].lag_s = 0.1;
  const link::Recording alone = sound.record(exercise);
  const link::Recording together = sagging.record(exercise);
  link::Recording both;
  for (std::size_t i = 0; i < alone.ticks().size(); ++i) {
    const bool last_turn = alone.ticks()[i].stretch >= exercise.turns()[4].first;
    both.add(last_turn ? together.ticks()[i] : alone.ticks()[i]);
  }
  const Sheet sheet = examine(both, exercise, usual, {});
  EXPECT_FALSE(sheet.passed());
  EXPECT_TRUE(sheet.canards[2].alone->passed());
  EXPECT_EQ(sheet.canards[2].diagnosis.cause, Cause::slow);
  EXPECT_TRUE(sheet.canards[2].diagnosis.seen.starts_with("healthy alone; with all four moving, "));
  EXPECT_TRUE(sheet.canards[1].passed());
}

TEST(Diagnosis, AServoThatIsNeverDrivenIsNotCalledDead) {
  Bench bench;
  const Exercise exercise = Exercise::limits(six_degrees());
  const link::Recording driven = bench.record(exercise);
  link::Recording recording;
  for (link::Tick tick : driven.ticks()) {
    tick.command_rad[2].reset();
    recording.add(tick);
  }
  const Sheet sheet = examine(recording, exercise, usual, {});
  EXPECT_EQ(sheet.canards[2].diagnosis.cause, Cause::out_of_tolerance);
  EXPECT_NE(sheet.canards[2].diagnosis.seen.find("never drove"), std::string::npos);
}

TEST(Verdict, NoMoreSlewIsAskedThanAShortWayAllows) {
  // A lag that just passes a step time of 0.08 s, over its first 10 ms of 4 deg.
  const double lag_s = 0.08 / std::log(9.0);
  EXPECT_NEAR(required_slew_rad_s(4.0 * degree, usual) / degree, 400.0 * (1.0 - std::exp(-0.01 / lag_s)), 1e-9);
  EXPECT_NEAR(required_slew_rad_s(40.0 * degree, usual) / degree, 300.0, 1e-9);
}

TEST(Sheet, PassesWhenEveryCanardPassesAloneAndTogether) {
  const Sheet sheet = sheet_of({});
  EXPECT_TRUE(sheet.passed()) << sheet_text(sheet);
  ASSERT_EQ(sheet.canards.size(), 4U);
  EXPECT_TRUE(sheet.canards[0].alone && sheet.canards[0].together);
}

TEST(Sheet, FailsWhenAPlanOnThisDeskHasOtherLimits) {
  Heading heading;
  heading.planned_limit_rad = six_degrees().limit_rad;
  EXPECT_TRUE(sheet_of({}, Exercise::limits(six_degrees()), heading).passed());
  (*heading.planned_limit_rad)[1] = 9.0 * degree;
  const Sheet sheet = sheet_of({}, Exercise::limits(six_degrees()), heading);
  EXPECT_FALSE(sheet.passed());
  EXPECT_NE(conclusions(sheet).front().find("Canard 2: the avionics reports a limit of 6.00 deg"), std::string::npos);
}

TEST(Sheet, FailsWhenALimitIsBeyondTheHardOne) {
  EXPECT_FALSE(sheet_of({}, Exercise::limits(six_degrees(20.3))).passed());
}

TEST(Sheet, FailsWhenItWasCutShortOrTheBusLostTooMuch) {
  Bench bench;
  const Exercise exercise = Exercise::limits(six_degrees());
  const link::Recording whole = bench.record(exercise);
  link::Recording half;
  for (const link::Tick& tick : whole.ticks().first(10'000)) {
    half.add(tick);
  }
  EXPECT_FALSE(examine(half, exercise, usual, {}).passed());
  EXPECT_FALSE(examine(link::Recording{}, exercise, usual, {}).passed());
  bench.lost_share = 0.01;
  EXPECT_TRUE(sheet_of(bench).passed());
  bench.lost_share = 0.05;
  EXPECT_FALSE(sheet_of(bench).passed());
}

TEST(Sheet, JsonNamesFiguresWithTheirUnits) {
  Bench bench;
  bench.canards[2].gain = -1.0;
  const Heading heading{.vehicle = "Tasha \xff", .plan = "p", .plan_crc = "00ff", .date = "today"};
  const auto json = json::parse(sheet_json(sheet_of(bench, Exercise::limits(six_degrees()), heading)));
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["limit_deg"][0], 6.0);
  EXPECT_EQ(json["tolerances"]["step_time_s"], 0.08);
  const auto& canard = json["canards"][2];
  EXPECT_EQ(canard["canard"], 3);
  EXPECT_EQ(canard["cause"], "reversed");
  EXPECT_EQ(canard["sign"], -1);
  EXPECT_NEAR(canard["reached_positive_deg"].number(), -6.0, 0.01);
  EXPECT_EQ(canard["passed"], false);
  for (const char* key : {"reached_negative_deg", "tracking_error_deg", "centring_error_deg", "backlash_deg",
                          "slew_deg_s", "step_time_s", "dropouts", "noise_deg"}) {
    EXPECT_TRUE(canard[key].is_number()) << key;
    EXPECT_TRUE(canard["together"][key].is_number()) << key;
  }
  EXPECT_EQ(json["canards"][0]["cause"], "healthy");
  EXPECT_TRUE(json["canards"][0]["failed"].empty());
}

TEST(Sheet, JsonSaysNullForWhatWasNotMeasured) {
  Bench bench;
  bench.canards[2].dropout_share = 1.0;
  const auto json = json::parse(sheet_json(sheet_of(bench)));
  EXPECT_TRUE(json["canards"][2]["sign"].is_null());
  EXPECT_TRUE(json["canards"][2]["step_time_s"].is_null());
  EXPECT_EQ(json["canards"][2]["cause"], "encoder_unplugged");
}

TEST(Sheet, TextIsPlainAndAligned) {
  Bench bench;
  bench.canards[2].gain = -1.0;
  const std::string text =
      sheet_text(sheet_of(bench, Exercise::limits(six_degrees()), {.vehicle = "Caf\xc3\xa9 \x1b[31m", .plan = "p"}));
  for (const char c : text) {
    EXPECT_TRUE(c == '\n' || (c >= ' ' && c <= '~'));
  }
  EXPECT_NE(text.find("FAIL\n  Canard 3 is reversed: commanded to +6.00 deg, it went to -6.00 deg."), std::string::npos)
      << text;
  EXPECT_NE(text.find("Reached, positive, deg      5.50 to 6.50        6.00      6.00     -6.00 !    6.00\n"),
            std::string::npos)
      << text;
}

TEST(SheetCsv, HasARowForEveryTickReceivedWithTurnPartAndAngles) {
  const Exercise exercise = Exercise::limits_of(six_degrees(), 2);
  link::Recording recording;
  link::Tick first{.number = 100};
  first.command_rad[2] = 1.5 * degree;
  first.encoder_rad[2] = -0.25 * degree;
  first.limited[2] = true;
  ASSERT_TRUE(recording.add(first));
  ASSERT_TRUE(recording.add({.number = 103, .stretch = exercise.turns()[0].last}));
  EXPECT_EQ(sheet_csv(recording, exercise),
            "time_s,turn,part,command_1_deg,encoder_1_deg,limited_1,command_2_deg,encoder_2_deg,limited_2,"
            "command_3_deg,encoder_3_deg,limited_3,command_4_deg,encoder_4_deg,limited_4\n"
            "0.000,canard_3,settle,,,0,,,0,1.50,-0.25,1,,,0\n"
            "0.003,canard_3,step_home,,,0,,,0,,,0,,,0\n");
}

}  // namespace
}  // namespace fantail::bench
