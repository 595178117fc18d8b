// SPDX-License-Identifier: MIT

#include <regex>

#include "json/value.hpp"
#include "system/folder.hpp"
#include "system/process.hpp"
#include "system/refusal.hpp"
#include "test.hpp"

namespace fantail::test {
namespace {

Outcome in(const Folder& folder, const Words& words) { return fantail(words, {.working_folder = folder.path()}); }

// A short session with the free plan: two set points of the fan, the air quick to follow.
Words session(const std::string& scenario, const std::string& out) {
  return {"fly",   scenario,
          "--set", "tunnel.fan_times_s=[0, 50]",
          "--set", "tunnel.fan_rpms=[1250, 1700]",
          "--set", "tunnel.fan_lag_s=2",
          "--set", "run.control_time_s=100",
          "--set", "timing.time_after_end_s=0",
          "--out", out};
}

TEST(Tunnel, FlowReadsTheLogThatFlyMakesAndLeavesPageAndJson) {
  const Folder folder;
  ASSERT_EQ(in(folder, session("tunnel_flow", "made")).exit_code, 0);
  const Outcome outcome = in(folder, {"tunnel", "flow", "made", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json::Value json = json::parse(outcome.out);
  ASSERT_EQ(json["set_points"].size(), 2U);
  EXPECT_NEAR(json["set_points"][0]["mean_m_s"].number(), 22.0, 0.1);
  EXPECT_NEAR(json["line"]["slope_m_s_per_rpm"].number(), 0.0176, 0.0003);
  EXPECT_EQ(outcome.out, content(folder / "out/tunnel/flow/flow.json"));
  EXPECT_NE(content(folder / "out/tunnel/flow/report.html").find("<svg"), std::string::npos);
  const Outcome text = in(folder, {"tunnel", "flow", "made", "--steady", "20,70:90"});
  EXPECT_EQ(text.exit_code, 0) << text.err;
  EXPECT_NE(text.out.find("70.0   88.0"), std::string::npos) << text.out;
  EXPECT_NE(text.out.find("out/tunnel/flow/report.html"), std::string::npos) << text.out;
}

TEST(Tunnel, SwirlComparesTwoSessions) {
  const Folder folder;
  ASSERT_EQ(in(folder, session("tunnel_swirl_without", "a")).exit_code, 0);
  ASSERT_EQ(in(folder, session("tunnel_swirl_with", "b")).exit_code, 0);
  const Outcome outcome = in(folder, {"tunnel", "swirl", "a", "b", "--json", "--out", "s"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json::Value json = json::parse(outcome.out);
  EXPECT_NEAR(json["swirl_deg"].number(), -2.0, 0.1);
  EXPECT_EQ(json["alpha_and_beta"], "the means of the published tunnel steps of Tasha III");
  EXPECT_EQ(json["without"]["set_points"].size(), 2U);
  EXPECT_EQ(outcome.out, content(folder / "s/swirl.json"));
  // The truth of the simulator, which has no set points of the fan in it, needs times by hand.
  const Outcome truth = in(folder, {"tunnel", "swirl", "a", "b", "--truth", "--steady-without", "20:45,70:95",
                                    "--steady-with", "20:45,70:95", "--out", "t"});
  EXPECT_EQ(truth.exit_code, 0) << truth.err;
  EXPECT_NE(truth.out.find("Swirl: -2.0"), std::string::npos) << truth.out;
}

// They were: a rocket of half the torque got a swirl a quarter too large, which is what predict then took off.
TEST(Tunnel, SwirlTakesThePublishedDampingAndTorqueForNoOtherRocket) {
  const Folder folder;
  Words dart = session("tunnel_swirl_without", "dart");
  dart.insert(dart.end(), {"--set", "body.name=\"Dart\"", "--set", "run.control_time_s=40"});
  ASSERT_EQ(in(folder, dart).exit_code, 0);
  Words weak = session("tunnel_swirl_without", "weak");
  weak.insert(weak.end(), {"--set", "aerodynamics.torque_m=5", "--set", "run.control_time_s=40"});
  ASSERT_EQ(in(folder, weak).exit_code, 0);
  // A copy may have kept the name.
  const std::filesystem::path shipped = std::filesystem::path{FANTAIL_TEST_SOURCE} / "sim";
  folder.write("copy.toml", content(shipped / "vehicles/tasha3_tunnel.toml"));
  std::string scenario = content(shipped / "scenarios/tunnel_swirl_without.toml");
  const std::string named = "vehicle = \"tasha3_tunnel\"";
  ASSERT_NE(scenario.find(named), std::string::npos);
  folder.write("of_copy.toml", scenario.replace(scenario.find(named), named.size(), "vehicle = \"copy.toml\""));
  ASSERT_EQ(in(folder, {"fly", "of_copy.toml", "--set", "run.control_time_s=40", "--out", "copy"}).exit_code, 0);
  for (const auto& [name, extension] : {std::pair{"alone/x.ftl", "ftl"}, std::pair{"alone/x.csv", "csv"}}) {
    folder.write(name, content(folder / (std::string{"dart/flight."} + extension)));
  }
  folder.write("alone/tunnel.csv", content(folder / "dart/tunnel.csv"));
  for (const auto& [log, rocket] : {std::pair{"dart", "rolled here is Dart,"},
                                    std::pair{"weak", "Tasha III, wind tunnel with aerodynamics.torque_m=5,"},
                                    std::pair{"copy", "rolled here is Tasha III, wind tunnel (vehicle copy.toml),"},
                                    std::pair{"alone/x.ftl", "rolled here is Dart, whose file is not named,"},
                                    std::pair{"alone/x.csv", "the rocket that rolled here is unknown"}}) {
    const Outcome refused = in(folder, {"tunnel", "swirl", log, log});
    EXPECT_EQ(refused.exit_code, 64) << refused.out;
    EXPECT_NE(refused.err.find(rocket), std::string::npos) << refused.err;
    EXPECT_NE(refused.err.find("--alpha M2 and --beta M; fantail tunnel steps"), std::string::npos) << refused.err;
  }
  const Outcome own = in(folder, {"tunnel", "swirl", "dart", "dart", "--alpha", "0.097", "--beta", "0.06"});
  EXPECT_EQ(own.exit_code, 0) << own.err;
  EXPECT_NE(own.out.find("error), with alpha 0.097 m2 and beta 0.06 m, as given.\n"), std::string::npos) << own.out;
}

TEST(Tunnel, StepsWritesTheTableThatAPredictionReads) {
  const Folder folder;
  ASSERT_EQ(in(folder, {"fly", "tunnel_steps", "--set", "run.control_time_s=20", "--out", "run"}).exit_code, 0);
  const Outcome outcome = in(folder, {"tunnel", "steps", "run", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const json::Value json = json::parse(outcome.out);
  ASSERT_EQ(json["steps"].size(), 4U);
  EXPECT_NEAR(json["mean"]["alpha_m2"].number(), 19.4, 0.4);
  EXPECT_NEAR(json["mean"]["beta_m"].number(), 9.6, 0.2);
  EXPECT_NEAR(json["mean"]["disturbance_end_deg"].number(), -6.1, 0.1);
  const std::string csv = content(folder / "out/tunnel/steps/steps.csv");
  EXPECT_TRUE(
      csv.starts_with("step,begin_s,alpha_m2,beta_m,disturbance_begin_deg,disturbance_end_deg,"
                      "mean_abs_angle_error_deg,mean_abs_rate_error_deg_s,alpha_standard_error_m2,"))
      << csv;
  EXPECT_EQ(std::ranges::count(csv, '\n'), 5);
  const Outcome by_hand = in(folder, {"tunnel", "steps", "run", "--speed", "22", "--inertia", "0.00393", "--area",
                                      "5.0265e-5", "--only", "up", "--method", "grid"});
  EXPECT_EQ(by_hand.exit_code, 0) << by_hand.err;
  EXPECT_NE(by_hand.out.find("from the command line"), std::string::npos) << by_hand.out;
  EXPECT_NE(by_hand.out.find("Mean of 2 steps: "), std::string::npos) << by_hand.out;
}

// What the simulated rocket has: 0.12 m, less what the body's own lift takes of it (none here).
TEST(Tunnel, StabilityFindsTheMarginOfTheRocketThatSwung) {
  const Folder folder;
  const Words fly{"fly", "tunnel_stability", "--set", "airframe.body_lift_area_m2=0", "--out", "made"};
  ASSERT_EQ(in(folder, fly).exit_code, 0);
  const Outcome outcome = in(folder, {"tunnel", "stability", "made", "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const json::Value json = json::parse(outcome.out);
  EXPECT_EQ(json["verdict"].text(), "stable");
  EXPECT_NEAR(json["margin_m"]["value"].number(), 0.120, 0.002);
  EXPECT_NEAR(json["without_wind_n_m_per_rad"]["value"].number(), 0.05, 0.02);
  ASSERT_EQ(json["swings"].size(), 3U);
  EXPECT_NEAR(json["swings"][2]["speed_m_s"].number(), 30.0, 0.1);
  EXPECT_NEAR(json["swings"][2]["air_unsteadiness"].number(), 0.002, 0.0015);  // as the scenario has it
  EXPECT_NE(outcome.out.find("too little to matter"), std::string::npos) << outcome.out;
  const Outcome one = in(folder, {"tunnel", "stability", "made", "--swings", "4:17", "--speeds", "15"});
  EXPECT_EQ(one.exit_code, 1);
  EXPECT_NE(one.out.find("One speed is not enough"), std::string::npos) << one.out;
  const Outcome wrong = in(folder, {"tunnel", "stability", "made", "--speeds", "15,20"});
  EXPECT_EQ(wrong.exit_code, 64);
  EXPECT_NE(wrong.err.find("--speeds has 2 numbers, and 3 swings were found"), std::string::npos) << wrong.err;
}

TEST(Tunnel, ARocketThatTheWindTurnsOverIsNotStable) {
  const Folder folder;
  const Words fly{"fly", "tunnel_stability", "--set", "airframe.centre_of_pressure_m=0.88", "--out", "made"};
  ASSERT_EQ(in(folder, fly).exit_code, 0);
  const Outcome outcome = in(folder, {"tunnel", "stability", "made"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find(
                "the rocket turns away from its rest position faster and faster, which a push alone cannot cause"),
            std::string::npos)
      << outcome.out;
}

// Every new rocket's file is called vehicle.toml.
TEST(Tunnel, StabilityTakesNoVehicleThatHappensToLieInThisFolder) {
  const Folder folder;
  const std::filesystem::path shipped = std::filesystem::path{FANTAIL_TEST_SOURCE} / "sim";
  folder.write("a.toml", std::regex_replace(content(shipped / "scenarios/tunnel_stability.toml"),
                                            std::regex{"vehicle = \"[^\"]*\""}, "vehicle = \"vehicle.toml\""));
  folder.write("vehicle.toml", content(shipped / "vehicles/tasha3_tunnel.toml"));
  ASSERT_EQ(in(folder, {"fly", "a.toml", "--out", "made"}).exit_code, 0);
  const Outcome unnamed = in(folder, {"tunnel", "stability", "made"});
  EXPECT_EQ(unnamed.exit_code, 64);
  EXPECT_NE(unnamed.err.find("--vehicle"), std::string::npos) << unnamed.err;
  EXPECT_EQ(in(folder, {"tunnel", "stability", "made", "--vehicle", "vehicle.toml"}).exit_code, 0);
}

TEST(Tunnel, WhatIsNoLogOfATunnelIsRefusedAndNothingIsWritten) {
  const std::string wind = "time_s,fan_rpm,wind_speed_m_s\n";
  const std::string roll = "time_s,roll_rate_deg_s\n0,1\n2,1\n4,1\n";
  Refusal({}, {"tunnel", "flow", "none.csv"}, 66, {"none.csv", "no such file"});
  Refusal({{"a.csv", "time_s,rpm\n0,1\n"}}, {"tunnel", "flow", "a.csv"}, 65, {"a.csv", "fan_rpm", "rpm"});
  Refusal({{"a.csv", wind + "0,570,10\n2,570,10\n"}}, {"tunnel", "flow", "a.csv"}, 65, {"a.csv", "was not steady"});
  Refusal({{"a.csv", wind + "0,570,10\n2,570,10\n"}}, {"tunnel", "flow", "a.csv", "--steady", "50"}, 78, {"from 50 s"});
  Refusal({{"a.csv", wind}}, {"tunnel", "flow", "a.csv", "--column", "rpm=x"}, 78, {"rpm=x"});
  Refusal({{"a.csv", roll}, {"b.csv", roll}}, {"tunnel", "swirl", "a.csv", "b.csv"}, 65, {"a.csv", "no wind speed"});
  Refusal({{"a.csv", "time_s,speed_m_s,roll_rate_deg_s\n0,9,1\n2,9,1\n"}}, {"tunnel", "swirl", "a.csv", "a.csv"}, 78,
          {"a.csv", "--steady-without"});
  Refusal({{"a.csv", roll}}, {"tunnel", "steps", "a.csv"}, 65, {"a.csv", "canard_deg"});
  Refusal({{"a.csv", "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg\n0,0,0,0\n1,0,0,0\n"}},
          {"tunnel", "steps", "a.csv", "--speed", "22", "--vehicle", "tasha3_tunnel"}, 65, {"a.csv", "reference_deg"});
  Refusal({{"a.csv", "time_s,roll_angle_deg,roll_rate_deg_s,canard_deg,reference_deg\n0,0,0,0,0\n1,0,0,0,45\n"}},
          {"tunnel", "steps", "a.csv", "--speed", "22"}, 64, {"no rocket given", "--vehicle", "tasha3_tunnel"});
  Refusal({}, {"tunnel", "steps", "none", "--vehicle", "nobody"}, 66, {"none"});
}

TEST(Tunnel, NothingIsWrittenOverTheRunItIsMadeFrom) {
  const Folder folder;
  ASSERT_EQ(in(folder, {"fly", "tunnel_steps", "--set", "run.control_time_s=10", "--out", "run"}).exit_code, 0);
  const std::string page = content(folder / "run/report.html");
  for (const char* verb : {"steps", "flow"}) {
    const Outcome outcome = in(folder, {"tunnel", verb, "run", "--out", "run"});
    EXPECT_EQ(outcome.exit_code, 74) << outcome.out;
    EXPECT_NE(outcome.err.find("run: these results are made from it"), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(in(folder, {"identify", "run", "--speed", "22", "--out", "run"}).exit_code, 74);
  folder.write("o/steps.csv", content(folder / "run/tunnel.csv"));
  EXPECT_EQ(in(folder, {"tunnel", "steps", "run", "--wind", "o/steps.csv", "--out", "o"}).exit_code, 74);
  EXPECT_EQ(content(folder / "o/steps.csv"), content(folder / "run/tunnel.csv"));
  EXPECT_EQ(content(folder / "run/report.html"), page);
}

TEST(Tunnel, AWrongWordIsAUsageError) {
  Refusal({}, {"tunnel"}, 64, {"--help"});
  Refusal({}, {"tunnel", "flow"}, 64, {"LOG"});
  Refusal({}, {"tunnel", "flow", "x", "--steady", "5,4"}, 64, {"--steady", "5,4"});
  Refusal({}, {"tunnel", "flow", "x", "--column", "rpm"}, 64, {"--column"});
  Refusal({}, {"tunnel", "swirl", "x"}, 64, {"WITH"});
  Refusal({}, {"tunnel", "swirl", "x", "y", "--alpha", "nan"}, 64, {"--alpha"});
  Refusal({}, {"tunnel", "swirl", "x", "y", "--alpha", "19.4"}, 64, {"--alpha requires --beta"});
  Refusal({}, {"tunnel", "steps", "x", "--method", "magic"}, 64, {"--method"});
  Refusal({}, {"tunnel", "steps", "x", "--speed", "-3"}, 64, {"--speed"});
  Refusal({}, {"tunnel", "steps", "x", "--intervals", "99"}, 64, {"--intervals"});
}

}  // namespace
}  // namespace fantail::test
