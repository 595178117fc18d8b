// SPDX-License-Identifier: MIT
#include <bit>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

using Json = json::Value;

// Flown once for all tests of this file.
const std::string& flown_log() {
  static const std::string log = [] {
    const Folder folder;
    const Outcome outcome = fantail({"fly", "tasha3_launch2", "--out", folder / "flown"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return content(folder / "flown/flight.ftl");
  }();
  return log;
}

std::string damaged_log() {
  std::string log = flown_log();
  log[log.size() / 2] = static_cast<char>(log[log.size() / 2] ^ 1);
  return log;
}

// As if the flight law had given 0.25 rad in this tick: an intact log of something that this law does not do.
std::string log_with_another_command(std::size_t tick) {
  std::string log = flown_log();
  const auto bytes = std::as_writable_bytes(std::span{log});
  protocol::LogFrameReader reader{bytes};
  std::size_t ticks = 0;
  while (const auto frame = reader.next()) {
    if (frame->head.type != static_cast<std::uint8_t>(protocol::LogRecord::tick) || ticks++ != tick) {
      continue;
    }
    constexpr std::size_t command_at = 32;
    const std::size_t end = protocol::log_head_size + frame->payload.size();
    const auto whole = bytes.subspan(frame->position, end + 4);
    protocol::put<4>(whole, protocol::log_head_size + command_at, std::bit_cast<std::uint32_t>(0.25F));
    protocol::put<4>(whole, end, protocol::crc32c(whole.first(end)));
    break;
  }
  return log;
}

class FlownLog : public testing::Test {
 protected:
  Outcome run(const Words& words, int exit_code = 0) { return run_in(folder, words, exit_code); }
  Folder folder;
};

TEST_F(FlownLog, InfoSaysWhoFlewWhatAndThatItIsIntactAndReplaysEqually) {
  folder.write("out/flown/flight.ftl", flown_log());
  const Outcome outcome = run({"log", "info", "out/flown"});
  expect_said(outcome.out,
              {"one flight", "tasha3_launch2, checksum", "intact:", "none missing",
               "equal:", "every output byte as recorded", "Launched: launch detected",
               "Controlling: guide clear and fast enough", "longest step from one tick to the next: 1.000 ms"});
}

TEST_F(FlownLog, SaysThatTheScenarioWasChangedOnTheCommandLine) {
  const Outcome flown = run({"fly", "tasha3_launch2", "--set", "servo.stop_deg=4.5", "--seed", "3", "--out", "flown"});
  const Outcome info = run({"log", "info", "flown"});
  expect_said(info.out, {"sensors   simulated, 2 values changed\n",
                         "the recording ends after control, with the simulation (normal)"});
  const Outcome report = run({"report", "flown/flight.ftl", "--out", "reported"});
  expect_said(content(folder / "reported/report.html"),
              {"changed for this flight, on the command line or by the draw of"});
}

TEST_F(FlownLog, InfoAsJsonHasTheSameInFigures) {
  folder.write("a.ftl", flown_log());
  const Outcome outcome = run({"log", "info", "a.ftl", "--json"});
  const Json json = json::parse(outcome.out);
  EXPECT_EQ(json["intact"], true);
  EXPECT_EQ(json["bytes"], flown_log().size());
  ASSERT_EQ(json["flights"].size(), 1U);
  const Json& flight = json["flights"][0];
  EXPECT_EQ(flight["plan"]["name"], "tasha3_launch2");
  EXPECT_EQ(flight["replay"]["differing"], 0);
  EXPECT_EQ(flight["replay"]["unreachable"], 0);
  EXPECT_EQ(flight["replay"]["compared"], flight["ticks"]);
  EXPECT_EQ(flight["integrity"]["lost_records"], 0);
  EXPECT_LT(flight["from_s"].number(), 0.0) << "it begins on the pad";
  EXPECT_EQ(flight["clock"], "seconds from lift-off");
  EXPECT_GT(flight["events"].size(), 3U);
}

TEST_F(FlownLog, AWhatIfSaysWhatItsTimesCountFrom) {
  folder.write("a.ftl", flown_log());
  const Words words{"replay", "a.ftl", "--set", "controller.proportional_gain=0.3"};
  const std::string text = run(words).out;
  expect_said(text, {" s from lift-off\n"});
  expect_said(content(folder / "out/replay/a/what_if.html"), {"from lift-off"});
  Words for_script = words;
  for_script.emplace_back("--json");
  EXPECT_EQ(json::parse(run(for_script).out)["clock"], "seconds from lift-off");
}

TEST_F(FlownLog, ADamagedOneIsShownAsFarAsItGoesWithExitCode1) {
  folder.write("a.ftl", damaged_log());
  const Outcome outcome = run({"log", "info", "a.ftl"}, 1);
  EXPECT_EQ(outcome.err, "");
  expect_said(outcome.out, {"damaged: 1 record lost in 1 gap", "outside the intact records",
                            "longest step from one tick to the next, except for the gaps in the log: 1.000 ms"});
}

TEST_F(FlownLog, OneThatWasCutOffIsIntactAsFarAsItGoes) {
  folder.write("a.ftl", flown_log().substr(0, flown_log().size() / 2));
  const Outcome outcome = run({"log", "info", "a.ftl"});
  expect_said(outcome.out, {"the recording ends early: the simulation ended"});
  EXPECT_EQ(outcome.out.find("power was lost"), std::string::npos) << outcome.out;
}

TEST_F(FlownLog, IsCalledTheSameByInfoEventsAndReport) {
  folder.write("a.ftl", flown_log());
  const Outcome info = run({"log", "info", "a.ftl"});
  expect_said(info.out,
              {"Flight 1: from sector 0 of the flight memory on", "recording began, in sector 0 of the flight memory"});
  const Outcome report = run({"report", "a.ftl"});
  EXPECT_TRUE(report.out.starts_with("flight 1, power-up 1: ")) << report.out;
  EXPECT_EQ((info.out + report.out).find("flight 0"), std::string::npos) << info.out << report.out;
}

TEST_F(FlownLog, OfTwoFlightsInOneFileEachCanBeChosen) {
  folder.write("two.ftl", flown_log() + flown_log());
  const Outcome both = run({"log", "info", "two.ftl"});
  expect_said(both.out, {"2 flights"});
  const Outcome second = run({"log", "info", "two.ftl", "--flight", "2", "--json"});
  EXPECT_EQ(json::parse(second.out)["flights"][0]["number"], 2);
  EXPECT_EQ(json::parse(second.out)["log"], "two.ftl");
  const Outcome third = run({"log", "info", "two.ftl", "--flight", "3"}, 64);
  expect_said(third.err, {"1 to 2"});
  const Outcome which = run({"replay", "two.ftl"}, 64);
  expect_said(which.err, {"--flight"});
}

TEST_F(FlownLog, ReplayComparesEveryTick) {
  folder.write("a.ftl", flown_log());
  const Outcome text = run({"replay", "a.ftl"});
  expect_said(text.out, {"every output byte as recorded", "ticks a second"});
  const Json json = json::parse(run({"replay", "a.ftl", "--json"}).out);
  EXPECT_EQ(json["equal"], true);
  EXPECT_EQ(json["compared"], json["ticks"]);
}

TEST_F(FlownLog, ReplayEndsWithExitCode1AtTheFirstDifferenceWithTickFieldAndBothValues) {
  folder.write("a.ftl", log_with_another_command(2310));
  const Outcome text = run({"replay", "a.ftl"}, 1);
  expect_said(text.out, {"(tick 2310): command was 0.25 rad, replayed "});
  const Outcome outcome = run({"replay", "a.ftl", "--json"}, 1);
  const Json json = json::parse(outcome.out);
  EXPECT_EQ(json["equal"], false);
  EXPECT_EQ(json["differing"], 1);
  EXPECT_EQ(json["first_difference"]["tick"], 2310);
  EXPECT_EQ(json["first_difference"]["field"], "command");
  EXPECT_EQ(json["first_difference"]["recorded"], "0.25 rad");
}

TEST_F(FlownLog, WhatIfCannotChangeHowManyGyrosFlew) {
  folder.write("flown/flight.ftl", flown_log());
  const Outcome outcome = run({"replay", "flown", "--set", "sensors.gyros=two_agree"}, 65);
  expect_said(outcome.err, {"sensors.gyros cannot be changed in a replay"});
}

TEST_F(FlownLog, WhatIfCannotMountASensorOtherwiseBecauseItsCountsAreTurnedAlready) {
  folder.write("flown/flight.ftl", flown_log());
  const Outcome outcome = run({"replay", "flown", "--set", "sensors.imu_to_nose=-x"}, 65);
  expect_said(outcome.err, {"sensors.imu_to_nose=-x changes nothing in a replay"});
}

TEST_F(FlownLog, WhatIfIsMarkedAsOpenLoopAndHasAPageAndATable) {
  folder.write("flown/flight.ftl", flown_log());
  const Outcome outcome = run({"replay", "flown", "--set", "controller.canard_limit_deg=3"});
  expect_said(outcome.out, {"open loop"});
  const std::string page = content(folder / "out/replay/flown/what_if.html");
  expect_said(page, {"Open loop"});
  const std::string table = content(folder / "out/replay/flown/what_if.csv");
  EXPECT_TRUE(table.starts_with("time_s,flown_phase,flown_command_deg,what_if_phase,what_if_command_deg,"));
  const Json json = json::parse(
      run({"replay", "flown", "--set", "controller.canard_limit_deg=3", "--json", "--out", folder / "x"}).out);
  EXPECT_EQ(json["open_loop"], true);
  EXPECT_GT(json["differing"].number(), 0);
  // Both commands lie within their limits, of 9 and 3 degrees.
  EXPECT_LE(json["largest_difference_deg"].number(), 12.001);
}

// The recorded rocket stays off its reference, whatever is commanded now: the integral grows until the limit holds it.
TEST_F(FlownLog, WhatIfAnIntegralWindsAgainstTheRecordedMotionIsSaid) {
  folder.write("flown/flight.ftl", flown_log());
  const Outcome outcome = run({"replay", "flown", "--set", "offset.rejection=integral", "--out", "i"});
  for (const std::string& text : {outcome.out, content(folder / "i/what_if.html")}) {
    expect_said(text, {"Commands in a replay do not move the rocket"});
  }
  const Json json =
      json::parse(run({"replay", "flown", "--set", "offset.rejection=integral", "--json", "--out", "i"}).out);
  EXPECT_EQ(json["rejects_offset"], true);
  expect_said(content(folder / "i/what_if.csv"), {",what_if_offset_estimate_deg\n"});
  EXPECT_GT(json["largest_difference_deg"].number(), 3.0);
  EXPECT_EQ(run({"replay", "flown", "--set", "controller.canard_limit_deg=3", "--out", "n"}).out.find("in a replay"),
            std::string::npos);
}

TEST_F(FlownLog, WhatIfNothingWereChangedIsNothing) {
  folder.write("a.ftl", flown_log());
  const Json json = json::parse(run({"replay", "a.ftl", "--set", "controller.canard_limit_deg=9", "--json"}).out);
  EXPECT_EQ(json["differing"], 0);
}

TEST_F(FlownLog, APlanValueThatCannotBeIsRefusedAsInAnyPlan) {
  const Refusal unknown{{{"a.ftl", flown_log()}},
                        {"replay", "a.ftl", "--set", "controller.canard_limt_deg=3"},
                        78,
                        {"canard_limt_deg", "did you mean controller.canard_limit_deg?"}};
  const Refusal beyond{
      {{"a.ftl", flown_log()}}, {"replay", "a.ftl", "--set", "controller.canard_limit_deg=90"}, 78, {"90"}};
}

TEST(LogVerbs, WhatIsNoLogIsRefusedWithWhatItIs) {
  const std::string csv = "time_s,phase,roll_angle_deg\n0,safe,0\n";
  const Refusal info{{{"a.csv", csv}}, {"log", "info", "a.csv"}, 65, {"a.csv", "CSV"}};
  const Refusal replay{{{"a.csv", csv}}, {"replay", "a.csv"}, 65, {"a.csv", "CSV"}};
  const Refusal empty{{{"a.ftl", ""}}, {"log", "info", "a.ftl"}, 65, {"empty"}};
  const Refusal none{{}, {"log", "info", "none.ftl"}, 66, {"none.ftl", "no such file"}};
  const Refusal folder{{{"d/x", ""}}, {"replay", "d"}, 66, {"no flight log (.ftl)"}};
  const Refusal missing{{}, {"replay"}, 64, {"LOG"}};
}

}  // namespace
}  // namespace fantail::test
