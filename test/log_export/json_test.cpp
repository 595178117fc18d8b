// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "json/value.hpp"
#include "log_export/formats.hpp"
#include "made_flight.hpp"

namespace fantail::log_export {
namespace {

using Json = json::Value;

TEST(JsonExport, EveryFieldIsAListAndAllAreAsLongAsTheLog) {
  const MadeFlight made;
  const Json json = json::parse(log_export::json(made.source(), every_field(made.source())));
  // Its one gyro has no columns of a second: its status, its age, three rates, and the vote. Nor has it a barometer:
  // pressure, age and state.
  ASSERT_EQ(json["ticks"].size(), fields().size() - 6 - 3);
  for (const std::size_t field : every_field(made.source())) {
    EXPECT_EQ(json["ticks"][fields()[field].name].size(), 950U) << fields()[field].name;
  }
  EXPECT_NEAR(json["ticks"]["roll_angle_deg"][400].number(), 0.4, 1e-6);
  EXPECT_EQ(json["ticks"]["phase"][400], "controlling");
  EXPECT_EQ(json["ticks"]["arm_switch_closed"][400], true);
  EXPECT_TRUE(json["ticks"]["roll_angle_deg"][502].is_null());
  EXPECT_TRUE(json["ticks"]["command_4_deg"][400].is_null());
}

TEST(JsonExport, EveryListHasItsUnitAndDescription) {
  const MadeFlight made;
  const Json json = json::parse(log_export::json(made.source(), every_field(made.source())));
  ASSERT_EQ(json["columns"].size(), json["ticks"].size());
  for (const std::size_t index : every_field(made.source())) {
    const Field& field = fields()[index];
    EXPECT_EQ(json["columns"][field.name]["unit"], field.unit);
    EXPECT_EQ(json["columns"][field.name]["description"], field.description);
  }
}

TEST(JsonExport, HeaderPlanEventsHealthAndGapsAreThere) {
  const MadeFlight made;
  const Json json = json::parse(log_export::json(made.source(), every_field(made.source())));
  EXPECT_EQ(json["vehicle"], "paper dart");
  EXPECT_EQ(json["git_hash"], "0123abc");
  EXPECT_EQ(json["plan"]["launch_detection"]["threshold_g"], 2.5);
  EXPECT_EQ(json["plan"]["launch_detection"]["low_pass"], true);
  EXPECT_EQ(json["gaps"], json::parse(R"([{"after_s":0.399,"until_s":0.45,"records_missing":50}])"));
  ASSERT_EQ(json["events"].size(), 2U);
  EXPECT_EQ(json["events"][0]["time_s"], 0.0);
  EXPECT_EQ(json["events"][0]["value"], "launched");
  EXPECT_EQ(json["events"][0]["reason"], "launch_detected");
  EXPECT_EQ(json["events"][1]["canard"], 3);
  EXPECT_EQ(json["events"][1]["value"], "stalled");
  ASSERT_EQ(json["health"].size(), 3U);
  EXPECT_EQ(json["health"][1]["accelerometer_state"], "coasting");
  EXPECT_EQ(json["health"][1]["longest_tick_us"], 150);
}

TEST(JsonExport, AWindowHoldsForTicksEventsAndHealth) {
  const MadeFlight made;
  const Json json =
      json::parse(log_export::json(made.source({.from_s = 0.04, .until_s = 0.06}), every_field(made.source())));
  EXPECT_EQ(json["ticks"]["time_s"].size(), 21U);
  EXPECT_TRUE(json["events"].empty());
  EXPECT_EQ(json["health"].size(), 1U);
}

TEST(JsonExport, AVehicleNameOfAnyBytesIsStillJson) {
  MadeFlight made;
  made.flight.vehicle = "a \"quoted\"\n\xFF name";
  EXPECT_NO_THROW((void)json::parse(log_export::json(made.source(), every_field(made.source()))));
}

}  // namespace
}  // namespace fantail::log_export
