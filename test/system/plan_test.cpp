// SPDX-License-Identifier: MIT

#include <fmt/format.h>

#include "core/flight_plan_fields.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "protocol/plan_block.hpp"
#include "system/refusal.hpp"

namespace fantail::test {
namespace {

class Plan : public testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] static std::string file() {
    return std::string{FANTAIL_TEST_SOURCE} + "/firmware/plans/" + GetParam() + ".toml";
  }
};

TEST_P(Plan, MayFly) {
  const Outcome outcome = fantail({"plan", "check", GetParam()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string checksum =
      fmt::format("{:08x}", protocol::plan_crc(input::read_plan(input::Document::load(file()))));
  expect_said(outcome.out, {"the firmware accepts this plan, checksum " + checksum});
  const Outcome json = fantail({"plan", "check", GetParam(), "--json"});
  EXPECT_EQ(json::parse(json.out)["may_fly"], true);
  EXPECT_EQ(json::parse(json.out)["crc"], checksum);
}

// What is shown is itself a plan: reading it back gives the same numbers.
TEST_P(Plan, IsShownAsAPlanThatReadsBack) {
  const Folder folder;
  const Outcome outcome = fantail({"plan", "show", GetParam()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string shown = folder.write("shown.toml", outcome.out);
  const core::FlightPlan expected = input::read_plan(input::Document::load(file()));
  const core::FlightPlan plan = input::read_plan(input::Document::load(shown));
  for (const core::PlanField& field : core::flight_plan_fields()) {
    ASSERT_EQ(field.used_slots(plan), field.used_slots(expected)) << field.key;
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      EXPECT_FLOAT_EQ(field.get(plan, slot), field.get(expected, slot)) << field.section << '.' << field.key;
    }
  }
}

TEST_P(Plan, IsShownAsOneJsonObjectWithEveryField) {
  const Outcome outcome = fantail({"plan", "show", GetParam(), "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json::Value json = json::parse(outcome.out);
  for (const core::PlanField& field : core::flight_plan_fields()) {
    EXPECT_TRUE(json[field.section].contains(field.key)) << field.key;
  }
}

TEST_P(Plan, IsPackedIntoABlockThatReadsBackBitForBit) {
  const Folder folder;
  const Outcome outcome = fantail({"plan", "compile", GetParam(), "--out", folder / "made/plan.ftpl"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string bytes = content(folder / "made/plan.ftpl");
  const protocol::PlanBlockReading reading =
      protocol::read_plan_block(std::as_bytes(std::span{bytes.data(), bytes.size()}));
  ASSERT_TRUE(reading.plan.has_value());
  const core::FlightPlan expected = input::read_plan(input::Document::load(file()));
  for (const core::PlanField& field : core::flight_plan_fields()) {
    ASSERT_EQ(field.used_slots(*reading.plan), field.used_slots(expected)) << field.key;
    for (std::size_t slot = 0; slot < field.used_slots(expected); ++slot) {
      EXPECT_EQ(field.get_bits(*reading.plan, slot), field.get_bits(expected, slot))
          << field.section << '.' << field.key;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Plan,
                         testing::Values("tasha3_launch1", "tasha3_launch2", "tasha3_launch2_integral",
                                         "tasha3_launch2_irec", "kestrel_euroc", "tunnel_free", "tunnel_steps"),
                         [](const auto& one) { return one.param; });

TEST(PlanShow, ShowsTheDefaultOfEveryFieldWhenNoPlanIsNamed) {
  const Outcome outcome = fantail({"plan", "show"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, input::plan_table(core::default_plan()));
  const json::Value json = json::parse(fantail({"plan", "show", "--json"}).out);
  EXPECT_EQ(json["controller"]["canard_limit_deg"], 9);
}

TEST(PlanShow, TakesAnEmptyNameForAMistakeNotForNoName) {
  const Outcome outcome = fantail({"plan", "show", ""});
  EXPECT_EQ(outcome.exit_code, 64);
  expect_said(outcome.err, {"PLAN: it is empty"});
}

TEST(PlanCompile, NamesTheBlockAfterThePlanWhenNothingIsSaid) {
  const Folder folder;
  const Outcome outcome = run_in(folder, {"plan", "compile", "tunnel_steps", "--json"});
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"tunnel_steps.ftpl"});
  const json::Value json = json::parse(outcome.out);
  EXPECT_EQ(json["block"], "tunnel_steps.ftpl");
  EXPECT_EQ(json["bytes"], content(folder / "tunnel_steps.ftpl").size());
}

TEST(PlanCompile, RefusesAFolderInThePlaceOfTheBlock) {
  const Folder folder;
  for (const char* out : {".", "new/", ".."}) {
    const Outcome outcome = run_in(folder, {"plan", "compile", "tunnel_steps", "--out", out}, 74);
    EXPECT_TRUE(folder.listing().empty()) << out;
  }
}

TEST(PlanCompile, WritesNothingForAPlanThatMayNotFly) {
  const Folder folder;
  folder.write("bad.toml", "[controller]\nproportional_gain = 11\n");
  const Outcome outcome = run_in(folder, {"plan", "compile", "bad.toml"}, 78);
  EXPECT_EQ(folder.listing(), std::vector<std::string>{"bad.toml"});
}

TEST(PlanCheckWarnings, NameEachFieldByWhichALaunchIsImaginedMoreEasilyThanByTheShippedPlan) {
  const Folder folder;
  folder.write("weak.toml",
               "[launch_detection]\nthreshold_g = 1.5\nhold_s = 0.05\n[guide]\nlength_m = 0\nminimum_speed_m_s = 10\n");
  const Outcome outcome = run_in(folder, {"plan", "check", "weak.toml"});
  expect_said(outcome.out, {"low_pass_hz = 16; 8 there", "threshold_g = 1.5; 2 or more there",
                            "hold_s is less than 0.1", "guide.length_m = 0", "minimum_speed_m_s = 10; 17 there",
                            "fantail campaign detection --plan weak.toml"});
  const Outcome json = fantail({"plan", "check", "weak.toml", "--json"}, {.working_folder = folder.path()});
  EXPECT_EQ(json::parse(json.out)["weaker_than_shipped"].size(), 5U);
  EXPECT_EQ(fantail({"plan", "check", "tunnel_steps"}).out.find("warning"), std::string::npos);
  const std::string published = fantail({"plan", "check", "tasha3_launch2"}).out;
  EXPECT_EQ(published.find("false launches"), std::string::npos) << published;
  expect_said(published, {"warning: run.tilt_limit_deg = 60 from the vertical: ranges allow at most 30 degrees"});
}

struct Bad {
  const char* name;
  const char* text;
  const char* said;  ///< file, line, field, value and range
};

class PlanCheck : public testing::TestWithParam<Bad> {};

TEST_P(PlanCheck, RefusesWithExitCode78) {
  const Folder folder;
  folder.write("bad.toml", GetParam().text);
  for (const char* action : {"check", "show"}) {
    const Outcome outcome = run_in(folder, {"plan", action, "bad.toml"}, 78);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, std::string{"fantail: bad.toml:"} + GetParam().said + "\n");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Plans, PlanCheck,
    testing::Values(Bad{"GainOutOfRange", "\n[controller]\nproportional_gain = 11\n",
                        "3: controller.proportional_gain = 11 is out of range; allowed: 0 to 10"},
                    Bad{"GainThatIsNoNumber", "[controller]\nproportional_gain = nan\n",
                        "2: controller.proportional_gain = nan is out of range; allowed: 0 to 10"},
                    Bad{"GainThatIsInfinite", "[controller]\nderivative_gain_s = -inf\n",
                        "2: controller.derivative_gain_s = -inf is out of range; allowed: 0 to 2"},
                    Bad{"GainThatIsAText", "[controller]\nderivative_gain_s = \"big\"\n",
                        "2: controller.derivative_gain_s = 'big' is not a number; allowed: 0 to 2"},
                    Bad{"UnknownKey", "[controller]\npropotional_gain = 1\n",
                        "2: unknown key controller.propotional_gain; did you mean controller.proportional_gain?"},
                    Bad{"UnknownSection", "[controler]\n", "1: unknown section [controler]; did you mean controller?"},
                    Bad{"UnknownChoice", "[reference]\nkind = \"step\"\n",
                        "2: reference.kind = 'step'; allowed: hold, steps, square_wave"},
                    Bad{"SectionThatIsAValue", "controller = 3\n", "1: [controller] must be a section"},
                    Bad{"StepsOutOfOrder",
                        "[reference]\nkind = \"steps\"\nstep_times_s = [2, 1]\nstep_angles_deg = [0, 1]\n",
                        "3: reference.step_times_s = 1 is refused: step times must increase"},
                    Bad{"ThreeValuesForFourCanards", "[canards]\ntrim_deg = [1, 2, 3]\n",
                        "2: canards.trim_deg has 3 values; allowed: one for all, or 4"}),
    [](const auto& one) { return one.param.name; });

// The margins of the published launches: 62 degrees or nearly, and 23.
TEST(PlanCheckOfALoop, WithAScenarioSaysThePhaseMarginAndWarnsOfLittle) {
  const Outcome second = fantail({"plan", "check", "tasha3_launch2", "--scenario", "tasha3_launch2"});
  EXPECT_EQ(second.exit_code, 0) << second.err;
  expect_said(second.out, {"the phase margin is 61.9 degrees or more from 20 to 82 m/s"});
  EXPECT_EQ(second.out.find("warning: "), second.out.find("warning: run.tilt_limit_deg")) << second.out;
  const Outcome first = fantail({"plan", "check", "--scenario", "tasha3_launch1"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  expect_said(first.out, {"warning: with the rocket of tasha3_launch1 the phase margin is only 23"});
  const std::string file = std::string{FANTAIL_TEST_SOURCE} + "/sim/scenarios/tasha3_launch1.toml";
  const json::Value said = json::parse(fantail({"plan", "check", file, "--json"}).out);
  EXPECT_EQ(said["may_fly"], true);
  EXPECT_NEAR(said["least_phase_margin_deg"].number(), 23.1, 0.2);
  EXPECT_NEAR(said["at_speed_m_s"].number(), 97.0, 1.0);
}

TEST(PlanCheck, NamesTheClauseThatControlWithAFailedCanardDoesNotMeet) {
  const Folder folder;
  for (const auto& [run, is_met] : {std::pair{"canard_fault = \"share\"", false},
                                    {"canard_fault = \"continue\"", false},
                                    {"canard_fault = \"end_control\"", true},
                                    {"start = \"tunnel\"", true}}) {
    const std::string plan = folder.write("p.toml", fmt::format("[run]\n{}\n", run));
    const Outcome outcome = fantail({"plan", "check", plan});
    EXPECT_EQ(outcome.out.find("DES.22") == std::string::npos, is_met) << outcome.out << outcome.err;
    const json::Value said = json::parse(fantail({"plan", "check", plan, "--json"}).out);
    EXPECT_EQ(said["unmet_clauses"].size(), is_met ? 0U : 1U) << run;
  }
}

TEST(PlanCheckOfALoop, RefusesGainsThatTheRocketDoesNotTolerateByName) {
  const Folder folder;
  const std::string plan = folder.write("p.toml", "[controller]\nproportional_gain = 10\nderivative_gain_s = 0.01\n");
  EXPECT_EQ(fantail({"plan", "check", plan}).exit_code, 0) << "no rocket, no loop";
  const Outcome outcome = fantail({"plan", "check", plan, "--scenario", "tasha3_launch2"});
  EXPECT_EQ(outcome.exit_code, 78);
  expect_said(outcome.err, {"p.toml: proportional_gain = 10, derivative_gain_s = 0.01: with the rocket of "
                            "tasha3_launch2 the loop is unstable at 19.8 m/s"});
}

// Its loop has a root in the right half plane whatever the gains, and no crossover that a phase margin could be of.
TEST(PlanCheckOfALoop, RefusesCanardsThatTurnTheWrongWay) {
  const Folder folder;
  const std::string plan = folder.write("p.toml", "[canards]\ndirection = \"reversed\"\n");
  const Outcome outcome = fantail({"plan", "check", plan, "--scenario", "tasha3_launch2"});
  EXPECT_EQ(outcome.exit_code, 78);
  expect_said(outcome.err, {"with the rocket of tasha3_launch2 all canards turn the rocket against the roll command "
                            "(direction differs between plan and vehicle)"});
}

TEST(PlanCheckOfALoop, OfNothingOrOfTwoScenariosIsWrongUsage) {
  EXPECT_EQ(fantail({"plan", "check"}).exit_code, 64);
  EXPECT_EQ(fantail({"plan", "check", "bench_healthy", "--scenario", "tasha3_launch1"}).exit_code, 64);
  EXPECT_EQ(fantail({"plan", "check", "tunnel_steps", "--scenario", "tasha3_launch1"}).exit_code, 78);
}

// Control from 0.638 s after lift-off on, apogee at 10.36 s: what is judged afterwards is what the plan leaves alone.
TEST(PlanCheck, WarnsOfAPlanThatEndsControlBeforeApogee) {
  const Folder folder;
  folder.write("short.toml", "[run]\ncontrol_time_s = 1.01\n[controller]\ncanard_limit_deg = 9\n");
  const Outcome outcome = fantail({"plan", "check", folder / "short.toml", "--scenario", "tasha3_launch2"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  expect_said(outcome.out, {"warning: run.control_time_s = 1.01 ends control 8.7",
                            "warning: a flight of tasha3_launch2 with this plan: Control ended at 1.6"});
  const json::Value said =
      json::parse(fantail({"plan", "check", folder / "short.toml", "--scenario", "tasha3_launch2", "--json"}).out);
  EXPECT_EQ(said["outcome"], "not_held");
  EXPECT_NEAR(said["control_ends_before_apogee_s"].number(), 10.36 - 0.638 - 1.01, 0.1);
  EXPECT_EQ(said["flight_warnings"].size(), 2U);
  const json::Value whole =
      json::parse(fantail({"plan", "check", "tasha3_launch2", "--scenario", "tasha3_launch2", "--json"}).out);
  EXPECT_EQ(whole["outcome"], "held");
  EXPECT_EQ(whole["flight_warnings"].size(), 0U);
}

}  // namespace
}  // namespace fantail::test
