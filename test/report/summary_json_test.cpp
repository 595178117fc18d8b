// SPDX-License-Identifier: MIT
#include <filesystem>
#include <fstream>

#include "json/value.hpp"
#include "report/results.hpp"
#include "synthetic_flight.hpp"
#include "test.hpp"

namespace fantail::report {
namespace {

json::Value summary_of(const flight::Flight& flight) {
  const Figures f = figures(flight);
  return json::parse(result::json(summary(flight, f, verdict(flight, f))));
}

TEST(SummaryJson, HasEveryKeyOfTheContract) {
  const auto summary = summary_of(SyntheticFlight{}.flight);
  for (const char* key : {"scenario", "seed", "events", "apogee_m", "max_speed_m_s", "control_start_height_m",
                          "saturated_fraction", "final_phase", "log_sha256", "version"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
  for (const char* key : {"liftoff_s", "detected_s", "control_start_s", "burnout_s", "apogee_s"}) {
    EXPECT_TRUE(summary["events"].contains(key)) << key;
  }
  EXPECT_EQ(summary["scenario"], "synthetic");
  EXPECT_EQ(summary["seed"], 7);
  EXPECT_EQ(summary["events"]["control_start_s"], 0.6);
  EXPECT_EQ(summary["saturated_fraction"], 0.0);
  EXPECT_EQ(summary["final_phase"], "controlling");
  EXPECT_EQ(summary["outcome"], "held");
  EXPECT_EQ(summary["authority_margin_deg"], 4.0);
  EXPECT_EQ(summary["left_by_fins"], 1.0);
  EXPECT_EQ(summary["why_uncontrollable"], "");
  EXPECT_EQ(summary["phase_changes"][1]["reason"], "launch_detected");
}

TEST(SummaryJson, SaysTheMeanWindOfAFlightThatHadOne) {
  SyntheticFlight synthetic;
  EXPECT_TRUE(summary_of(synthetic.flight)["wind"].is_null());
  synthetic.flight.wind = {.speed_m_s = 5.0, .from_rad = text::radians(270.0), .height_m = 10.0};
  const auto wind = summary_of(synthetic.flight)["wind"];
  EXPECT_EQ(wind["speed_m_s"], 5.0);
  EXPECT_EQ(wind["from_deg"], 270.0);
  EXPECT_EQ(wind["height_m"], 10.0);
}

TEST(SummaryJson, SaysHowTheRollInertiaFollowedThePropellantAndIsReadBack) {
  SyntheticFlight synthetic;
  synthetic.flight.airframe = {
      .vehicle = "v", .vehicle_file = "v.toml", .roll_inertia_kg_m2 = 0.004, .reference_area_m2 = 5e-5};
  EXPECT_FALSE(summary_of(synthetic.flight).contains("roll_inertia_course"));
  EXPECT_FALSE(summary_of(synthetic.flight).contains("compressibility"));
  synthetic.flight.airframe->roll_inertia_course = {{0.5, 0.004}, {2.5, 0.0035}};
  synthetic.flight.airframe->grows_with_mach = true;
  const Figures f = figures(synthetic.flight);
  const auto file = std::filesystem::temp_directory_path() / "fantail_roll_inertia_test.json";
  std::ofstream{file} << result::json(summary(synthetic.flight, f, verdict(synthetic.flight, f)));
  const auto read = summary_airframe(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->roll_inertia_course, synthetic.flight.airframe->roll_inertia_course);
  EXPECT_TRUE(read->grows_with_mach);
  // Another zero of the clock moves it along.
  flight::set_time_zero(synthetic.flight, 0.5);
  EXPECT_EQ(synthetic.flight.airframe->roll_inertia_course.begin()->first, 0.0);
}

TEST(SummaryJson, WhatDoesNotExistIsNull) {
  SyntheticFlight synthetic;
  synthetic.never_controlled(-0.5, core::Phase::armed, core::PhaseReason::armed_by_switch_and_command);
  synthetic.flight.events.apogee_s.reset();
  const auto summary = summary_of(synthetic.flight);
  EXPECT_TRUE(summary["log_sha256"].is_null());
  EXPECT_TRUE(summary["events"]["apogee_s"].is_null());
  EXPECT_TRUE(summary["apogee_m"].is_null());
  EXPECT_TRUE(summary["saturated_fraction"].is_null());
  EXPECT_TRUE(summary["authority_margin_deg"].is_null());
  EXPECT_TRUE(summary["imposed_roll"].is_null());
}

// The digest of "abc" as FIPS 180-2 prints it.
TEST(SummaryJson, HasTheDigestOfWhatTheAvionicsRecorded) {
  SyntheticFlight synthetic;
  synthetic.flight.log = {std::byte{'a'}, std::byte{'b'}, std::byte{'c'}};
  EXPECT_EQ(summary_of(synthetic.flight)["log_sha256"],
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(SummaryJson, AnImposedRollIsCalledImposed) {
  SyntheticFlight synthetic;
  synthetic.flight.imposed_roll = flight::ImposedRoll{0.21, text::radians(-0.6), text::radians(51.8)};
  const auto imposed = summary_of(synthetic.flight)["imposed_roll"];
  EXPECT_EQ(imposed["time_s"], 0.21);
  EXPECT_EQ(imposed["angle_deg"], -0.6);
  EXPECT_EQ(imposed["rate_deg_s"], 51.8);
}

TEST(SummaryJson, TheLargestSeedKeepsEveryDigit) {
  SyntheticFlight synthetic;
  synthetic.flight.seed = std::numeric_limits<std::uint64_t>::max();
  EXPECT_EQ(summary_of(synthetic.flight)["seed"], synthetic.flight.seed);
}

TEST(SummaryJson, SurvivesNamesThatAreNoText) {
  SyntheticFlight synthetic;
  synthetic.flight.scenario = "\xff\"\n";
  EXPECT_NO_THROW(summary_of(synthetic.flight));
}

}  // namespace
}  // namespace fantail::report
