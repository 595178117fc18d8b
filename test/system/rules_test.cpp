// SPDX-License-Identifier: MIT
#include <map>

#include "system/refusal.hpp"

namespace fantail::test {
namespace {

std::map<std::string, std::string> outcomes(const json::Value& said) {
  std::map<std::string, std::string> all;
  for (const json::Value& one : said["clauses"]) {
    all[one["id"].text()] = one["outcome"].text();
  }
  return all;
}

std::string evidence(const json::Value& said, const std::string& id) {
  std::string all;
  for (const json::Value& one : said["clauses"]) {
    all += one["id"].text() == id ? one["evidence"].text() : "";
  }
  return all;
}

const Words legal{"--set", "dormancy.until=burn_out",      "--set", "dormancy.burn_time_s=3.2",
                  "--set", "run.tilt_limit_deg=30",        "--set", "run.tilt_from=guide",
                  "--set", "run.canard_fault=end_control", "--set", "run.abort_input=closed_aborts"};

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// In six degrees of freedom a rocket on a leaning guide bends over and does not reach this gate.
TEST(Rules, OfABriefAreThoseOfTheRulesVerb) {
  const Folder folder;
  const Words low{"--set", "launch_guide.tilt_deg=12", "--set", "dormancy.until=height",
                  "--set", "dormancy.height_m=402",    "--set", "dormancy.scale_error=0",
                  "--set", "dormancy.bias_error_g=0"};
  const json::Value alone = asked(folder, with({"rules", "euroc", "tasha3_launch2"}, low), 1);
  const json::Value brief = asked(folder, with({"brief", "tasha3_launch2", "--rules", "euroc", "--step", "10"}, low));
  EXPECT_TRUE(brief["control_start_s"].is_null());
  EXPECT_EQ(outcomes(brief["rules"]), outcomes(alone));
  EXPECT_EQ(brief["rules"]["sentence"], alone["sentence"]);
  expect_said(brief["rules"]["flown"].text(), {"as written, along a straight line"});
}

TEST(Rules, FailThePublishedLaunchByNameAtIrecAndEuroc) {
  const Folder folder;
  const json::Value irec = asked(folder, {"rules", "irec", "tasha3_launch2"}, 1);
  EXPECT_EQ(irec["answer"], "no");
  EXPECT_EQ(outcomes(irec)["7.4.1 (plan)"], "FAIL");
  EXPECT_EQ(outcomes(irec)["7.4.1 (flight)"], "FAIL");
  expect_said(irec["sentence"].text(),
              {"4 of 10 clauses fail: 7.3 (tilt); 7.3 (abort signal); 7.4.1 (plan); 7.4.1 (flight)"});
  const json::Value euroc = asked(folder, {"rules", "euroc", "tasha3_launch2"}, 1);
  EXPECT_EQ(outcomes(euroc)["DES.22"], "FAIL");
  EXPECT_EQ(outcomes(euroc)["DES.23 (plan)"], "FAIL");
  EXPECT_EQ(outcomes(euroc)["DES.23 (flight)"], "FAIL");
}

TEST(Rules, PassAtIrecAPlanThatWaitsForBurnOut) {
  const Folder folder;
  const json::Value irec =
      asked(folder, with(with({"rules", "irec", "tasha3_launch2"}, legal), {"--set", "flight.motion=six_dof"}));
  EXPECT_EQ(irec["answer"], "yes");
  for (const auto& [id, outcome] : outcomes(irec)) {
    EXPECT_EQ(outcome, id.starts_with("7.3 (abort") || id.starts_with("7.3 (lock") ? "BLANK" : "PASS") << id;
  }
}

// Along a straight line nothing can tilt.
TEST(Rules, PassNoClauseOnTiltByAMotionThatCannotTilt) {
  const Folder folder;
  const Words legal_rocket{"rules", "irec", "tasha3_launch2_irec"};
  EXPECT_EQ(outcomes(asked(folder, legal_rocket))["7.3 (flight)"], "PASS");
  const json::Value said = asked(folder, with(legal_rocket, {"--set", "flight.motion=straight"}), 1);
  EXPECT_EQ(said["answer"], "undecided");
  EXPECT_EQ(outcomes(said)["7.3 (flight)"], "NOT_KNOWN");
}

// A gyro that reads 5 % too little reports a rocket that leans less than it does.
TEST(Rules, JudgeASimulatedFlightByItsTrueTiltAndItsLogByTheEstimatedOne) {
  const Folder folder;
  const Words drifting{"kestrel", "--set", "imu.rate_scale_error=-0.05"};
  EXPECT_EQ(outcomes(asked(folder, with({"rules", "irec"}, drifting), 1))["7.3 (flight)"], "FAIL");
  run_in(folder, with(with({"fly"}, drifting), {"--out", "flown"}));
  const json::Value flown = asked(folder, {"rules", "irec", "flown"});
  EXPECT_EQ(outcomes(flown)["7.3 (flight)"], "PASS");
  expect_said(flown.dump(), {"as the avionics estimated it"});
}

// The abort ends the avionics' part. Nobody recovers the canard that turns afterwards.
TEST(Rules, FailALogWhoseCanardMovesAfterAnAbort) {
  const Folder folder;
  const std::string scenario = folder.write(
      "aborted.toml",
      "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[faults]]\nkind = \"device\"\ndevice = "
      "\"abort_input\"\nbehaviour = \"pressed\"\nfrom_s = 1\nuntil_s = 2\n[[faults]]\nkind = \"canard_hardover\"\n"
      "canard = 2\nfrom_s = 1.6\n");
  const json::Value simulated = asked(folder, with({"rules", "irec", scenario}, legal), 1);
  run_in(folder, with(with({"fly", scenario}, legal), {"--out", "flown"}));
  const json::Value flown = asked(folder, {"rules", "irec", "flown"}, 1);
  for (const char* id : {"7.3 (flight)", "7.4.1 (flight)"}) {
    EXPECT_EQ(outcomes(simulated)[id], "FAIL") << id;
    EXPECT_EQ(outcomes(flown)[id], "FAIL") << id;
  }
}

// Its apogee is 421 m: control never begins, and no canard moves.
TEST(Rules, PassAtEurocAPlanThatWaitsForAHeightWhereverTheRocketComes) {
  const Folder folder;
  const json::Value low = asked(folder, with({"rules", "euroc", "tasha3_launch2"}, legal), 1);
  EXPECT_EQ(outcomes(low)["DES.22"], "PASS");
  EXPECT_EQ(outcomes(low)["DES.23 (flight)"], "FAIL");
  const json::Value high = asked(
      folder, with(with({"rules", "euroc", "tasha3_launch2"}, legal), {"--set", "dormancy.until=burn_out and height"}));
  EXPECT_EQ(high["answer"], "yes");
  EXPECT_EQ(outcomes(high)["DES.23 (plan)"], "PASS");
  EXPECT_EQ(outcomes(high)["DES.23 (flight)"], "PASS");
}

TEST(Rules, JudgeOfALogWhatWasFlownAndNotTheScenario) {
  const Folder folder;
  run_in(folder, {"fly", "tasha3_launch2", "--out", "early"});
  run_in(folder, with({"fly", "tasha3_launch2", "--out", "late"}, legal));
  for (const char* early : {"early", "early/flight.ftl"}) {
    const json::Value said = asked(folder, {"rules", "irec", early}, 1);
    EXPECT_EQ(outcomes(said)["7.4.1 (plan)"], "FAIL") << early;
    EXPECT_EQ(outcomes(said)["7.4.1 (flight)"], "FAIL") << early;
  }
  for (const char* late : {"late", "late/flight.ftl"}) {
    const json::Value said = asked(folder, {"rules", "irec", late});
    EXPECT_EQ(outcomes(said)["7.4.1 (plan)"], "PASS") << late;
    EXPECT_EQ(outcomes(said)["7.4.1 (flight)"], "PASS") << late;
    EXPECT_EQ(outcomes(said)["7.3 (flight)"], "PASS") << late;
    EXPECT_EQ(said["answer"], "yes") << late;  // summary.json names the rocket
  }
  const json::Value table = asked(folder, {"rules", "irec", "late/flight.csv"}, 1);
  EXPECT_EQ(outcomes(table)["7.4.1 (plan)"], "NOT_KNOWN");
  EXPECT_EQ(outcomes(table)["7.4.1 (flight)"], "NOT_KNOWN");
}

TEST(Rules, OfALogAloneAskForTheRocketAndJudgeItThen) {
  const Folder folder;
  run_in(folder, with({"fly", "tasha3_launch2", "--out", "late"}, legal));
  std::filesystem::copy_file(folder.path() / "late/flight.ftl", folder.path() / "flown.ftl");
  const json::Value alone = asked(folder, {"rules", "irec", "flown.ftl"}, 1);
  EXPECT_EQ(alone["answer"], "undecided");
  EXPECT_EQ(outcomes(alone)["7.2.1"], "NOT_KNOWN");
  expect_said(alone["sentence"].text(), {"3 not known", "The rocket is not known: ", "use --vehicle NAME|FILE."});
  const json::Value named = asked(folder, {"rules", "irec", "flown.ftl", "--vehicle", "tasha3_launch2"});
  EXPECT_EQ(named["answer"], "yes");
  expect_said(named["compared"].text(), {"with the rocket Tasha III"});
  expect_said(evidence(alone, "7.4.1 (flight)"),
              {"flight.max_q_s = ", " s or more (", "dormancy.burn_time_s = 3.2 is the plan's word, not verified"});
  expect_said(evidence(named, "7.4.1 (flight)"), {"by its thrust curve the motor burns for "});
  run_in(folder, with(with({"fly", "tasha3_launch2", "--out", "unstable"}, legal),
                      {"--set", "airframe.centre_of_pressure_m=0.85"}));
  EXPECT_EQ(outcomes(asked(folder, {"rules", "irec", "unstable"}, 1))["7.2.1"], "FAIL")
      << "with the changes of the flight";
}

// Its mass, impulse and damping would be another's.
TEST(Rules, OfALogRefuseTheVehicleOfAnotherRocket) {
  const Folder folder;
  run_in(folder, with({"fly", "tasha3_launch2", "--out", "flown"}, legal));
  expect_said(run_in(folder, {"rules", "launch_canada", "flown", "--vehicle", "kestrel"}, 78).err,
              {"kestrel.toml: name = \"Kestrel\", and the log is of the rocket \"Tasha III",
               "allowed: the vehicle of that flight"});
}

TEST(Rules, OfALogWithSeveralFlightsJudgeTheOneThatIsChosen) {
  const Folder folder;
  run_in(folder, {"fly", "tasha3_launch2", "--out", "early"});
  run_in(folder, with({"fly", "tasha3_launch2", "--out", "late"}, legal));
  folder.write("two.ftl", content(folder.path() / "early/flight.ftl") + content(folder.path() / "late/flight.ftl"));
  const Words of_two{"rules", "irec", "two.ftl", "--vehicle", "tasha3_launch2"};
  expect_said(run_in(folder, of_two, 64).err, {"two.ftl holds 2 flights; which one? --flight 1 to 2"});
  EXPECT_EQ(outcomes(asked(folder, with(of_two, {"--flight", "1"}), 1))["7.4.1 (flight)"], "FAIL");
  const json::Value second = asked(folder, with(of_two, {"--flight", "2"}));
  EXPECT_EQ(outcomes(second)["7.4.1 (flight)"], "PASS");
  expect_said(second["compared"].text(), {"two.ftl, flight 2, as it was recorded"});
}

// Its scenario names the file from its own folder, and the log from another.
TEST(Rules, OfALogWithAVehicleFileOfItsOwnAskForItsPath) {
  const Folder folder;
  run_in(folder, {"new", "mine", "--from", "tasha3_launch2"});
  run_in(folder, {"fly", "mine/scenario.toml", "--out", "flown"});
  expect_said(asked(folder, {"rules", "irec", "flown"}, 1)["sentence"].text(),
              {"the vehicle \"vehicle.toml\" of its scenario: give the path of that file from here with --vehicle."});
  expect_said(asked(folder, {"rules", "irec", "flown", "--vehicle", "mine/vehicle.toml"}, 1)["compared"].text(),
              {"with the rocket mine"});
}

// What its rows do not show neither passes, nor is it said that it never happened.
TEST(Rules, LeaveOpenWhatALogThatEndsUnderThrustDoesNotShow) {
  const Folder folder;
  run_in(folder, with({"fly", "tasha3_launch2", "--out", "late"}, legal));
  const auto log = folder.path() / "late/flight.ftl";
  std::filesystem::copy_file(log, folder.path() / "cut.ftl");
  std::filesystem::resize_file(folder.path() / "cut.ftl", std::filesystem::file_size(log) / 8);
  const json::Value said = asked(folder, {"rules", "irec", "cut.ftl"}, 1);
  EXPECT_EQ(outcomes(said)["7.4.1 (flight)"], "NOT_KNOWN");
  EXPECT_NE(said["compared"].text().find(", which does not show whether control began"), std::string::npos);
}

// The command stands at trim, and the canard does not.
TEST(Rules, FailAFlightWhoseCanardMovesByItself) {
  const Folder folder;
  const std::string scenario = folder.write("stuck.toml",
                                            "vehicle = \"tasha3_launch2\"\nplan = \"tasha3_launch2\"\n[[faults]]\n"
                                            "kind = \"canard_hardover\"\ncanard = 2\nfrom_s = 1\n");
  const json::Value said = asked(folder, with({"rules", "irec", scenario}, legal), 1);
  EXPECT_EQ(outcomes(said)["7.4.1 (plan)"], "PASS");
  EXPECT_EQ(outcomes(said)["7.4.1 (flight)"], "FAIL");
}

TEST(Rules, WriteAPageWithTheWordsAndAJsonFile) {
  const Folder folder;
  const Outcome said = run_in(folder, {"rules", "nar_tripoli", "tasha3_launch2"});
  EXPECT_EQ(folder.listing(), (Words{"out", "out/rules", "out/rules/nar_tripoli+tasha3_launch2",
                                     "out/rules/nar_tripoli+tasha3_launch2/rules.html",
                                     "out/rules/nar_tripoli+tasha3_launch2/rules.json"}));
  expect_said(content(folder.path() / "out/rules/nar_tripoli+tasha3_launch2/rules.html"),
              {"Check against the current document", "no legal advice", "Compared: tasha3_launch2"});
  expect_said(said.out, {"Check against the current document", "BLANK", "Class 3 waiver"});
}

TEST(Rules, RefuseWhatIsNoPackAndNoLaunch) {
  Refusal({}, {"rules", "irek", "tasha3_launch2"}, 66, {"unknown rule pack \"irek\"; did you mean irec?"});
  Refusal({}, {"rules", "irec", "tunnel_steps"}, 78, {"not a launch"});
  Refusal({}, {"rules", "irec", "tasha3_lunch2"}, 66, {"did you mean tasha3_launch2?"});
  Refusal({}, {"rules", "irec", "gone.ftl"}, 66, {"gone.ftl"});
  Refusal({{"mine.toml", "title = \"x\"\n"}}, {"rules", "mine.toml", "tasha3_launch2"}, 78,
          {"mine.toml", "date is missing"});
  Refusal({{"x.ftl", "x"}}, {"rules", "irec", "x.ftl", "--set", "run.tilt_limit_deg=30"}, 64,
          {"--set and --seed cannot change"});
  Refusal({}, {"rules", "irec", "tasha3_launch2", "--vehicle", "tasha3_launch2"}, 64,
          {"--vehicle names the rocket of a log"});
  Refusal({}, {"rules", "irec", "tasha3_launch2", "--flight", "1"}, 64, {"--flight chooses one of a log"});
}

TEST(PlanCheck, WithRulesJudgesTheClausesOnPlans) {
  const Folder folder;
  const json::Value said = asked(folder, {"plan", "check", "tasha3_launch2", "--rules", "irec"}, 1);
  EXPECT_EQ(said["answer"], "no");
  EXPECT_EQ(said["may_fly"], true);
  EXPECT_EQ(outcomes(said["rules"])["7.4.1 (plan)"], "FAIL");
  EXPECT_EQ(outcomes(said["rules"])["7.4.1 (flight)"], "NOT_JUDGED");
  EXPECT_EQ(outcomes(said["rules"])["7.1"], "PASS");
  EXPECT_EQ(outcomes(said["rules"])["7.3 (lock)"], "BLANK");
  const Outcome text = run_in(folder, {"plan", "check", "tasha3_launch2", "--rules", "irec"}, 1);
  expect_said(text.out,
              {"3 of 10 clauses fail: 7.3 (tilt); 7.3 (abort signal); 7.4.1 (plan)",
               "Check against the current document", "FAIL 7.4.1 (plan): ", "plan.dormancy.until = \"guide\""});
  const json::Value none = asked(folder, {"plan", "check", "tasha3_launch2", "--rules", "launch_canada"});
  EXPECT_EQ(none["answer"], "yes");
}

}  // namespace
}  // namespace fantail::test
