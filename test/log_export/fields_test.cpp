// SPDX-License-Identifier: MIT
#include "log_export/fields.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "flight/columns.hpp"
#include "made_flight.hpp"

namespace fantail::log_export {
namespace {

Value value(std::span<const Value> values, std::string_view name) { return values[find_field(name).value()]; }
double number(std::span<const Value> values, std::string_view name) { return std::get<double>(value(values, name)); }

TEST(ExportFields, EveryNameStandsOnceAndIsMadeOfSmallLettersDigitsAndUnderscores) {
  std::set<std::string> names;
  for (const Field& field : fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_EQ(field.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_"), std::string::npos) << field.name;
  }
  EXPECT_EQ(fields().front().name, "time_s");
}

// Else a window from 0.9 s on would have one tick more of a CSV file than of a table with all digits.
TEST(ExportFields, TheTimeIsTheNumberThatItsSixDecimalsAre) {
  const MadeFlight made;
  const ReplayedFlight source = made.source();
  for (int tick = 0; tick < MadeFlight::ticks; ++tick) {
    const double time_s = source.time_s(MadeFlight::time(tick));
    EXPECT_EQ(time_s, std::stod(std::to_string(time_s)));
  }
}

TEST(ExportFields, EveryColumnThatALogCanFillOfFlightCsvIsAField) {
  for (const char* name : {"time_s",        "phase",          "roll_angle_deg",      "roll_rate_deg_s",
                           "reference_deg", "excitation_deg", "offset_estimate_deg", "command_deg",
                           "saturated",     "command_1_deg",  "command_2_deg",       "command_3_deg",
                           "command_4_deg", "encoder_1_deg",  "encoder_2_deg",       "encoder_3_deg",
                           "encoder_4_deg", "canard_deg",     "specific_force_m_s2", "height_m",
                           "speed_m_s"}) {
    EXPECT_TRUE(find_field(name)) << name;
  }
}

// The house's rule for names, which the table of units does not know of.
std::string_view unit_by_the_name(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 9> endings{{{"_deg_s", "deg/s"},
                                                                                  {"_m_s2", "m/s2"},
                                                                                  {"_m_s", "m/s"},
                                                                                  {"_count", "count"},
                                                                                  {"_deg", "deg"},
                                                                                  {"_us", "us"},
                                                                                  {"_pa", "Pa"},
                                                                                  {"_s", "s"},
                                                                                  {"_m", "m"}}};
  const auto found = std::ranges::find_if(
      endings, [name](const auto& ending) { return name.ends_with(ending.first) && !name.ends_with("_status"); });
  return found == endings.end() ? "-" : found->second;
}

TEST(ExportFields, EachHasAUnitAndADescription) {
  for (const Field& field : fields()) {
    EXPECT_EQ(field.unit, unit_by_the_name(field.name)) << field.name;
    EXPECT_GT(field.description.size(), 5U) << field.name;
    EXPECT_EQ(field.description.find('#'), std::string::npos) << field.name;
  }
  EXPECT_NE(fields()[find_field("encoder_3_count").value()].description.find("encoder 3"), std::string::npos);
}

TEST(ExportFields, EachColumnOfFlightCsvHasAUnitAndADescriptionTheTrueOnesToo) {
  for (const flight::Column& column : flight::columns()) {
    const auto text = flight::column_text(column.name);
    ASSERT_TRUE(text) << column.name;
    EXPECT_EQ(text->unit, unit_by_the_name(column.name)) << column.name;
    EXPECT_FALSE(text->description.empty()) << column.name;
  }
  EXPECT_TRUE(flight::column_text(flight::phase_column));
  EXPECT_FALSE(flight::column_text("roll_angle_rad"));
}

TEST(ExportFields, RawCountsAreThereByTheNamesOfTheSchema) {
  for (const char* name : {"rate_x_count", "specific_force_z_count", "accelerometer_y_count", "encoder_4_count",
                           "encoder_4_status", "imu_age_us", "duration_before_us", "digest"}) {
    ASSERT_TRUE(find_field(name)) << name;
    EXPECT_FALSE(fields()[*find_field(name)].replayed) << name;
  }
}

TEST(ExportFields, AnUnknownOneIsNamedWithTheNearestAndAllThatThereAre) {
  EXPECT_FALSE(find_field("roll_rate_deg"));
  const std::string message = unknown_field("roll_rate_deg");
  EXPECT_NE(message.find("\"roll_rate_deg\" (did you mean roll_rate_deg_s?)"), std::string::npos) << message;
  EXPECT_NE(message.find("time_s, time_us, "), std::string::npos) << message;
}

TEST(ExportFields, ATickHasItsRecordedAndItsReplayedValuesInDegrees) {
  const MadeFlight made;
  const ReplayedFlight source = made.source();
  TickReader reader{source};
  const auto values = reader.read(400);
  ASSERT_EQ(values.size(), fields().size());
  EXPECT_NEAR(number(values, "time_s"), 0.3, 1e-12);
  EXPECT_TRUE(std::get<bool>(value(values, "replayed")));
  EXPECT_EQ(std::get<std::int64_t>(value(values, "time_us")), 10'400'000);
  EXPECT_EQ(std::get<std::int64_t>(value(values, "rate_y_count")), -400);
  EXPECT_EQ(std::get<std::int64_t>(value(values, "digest")), 0xFFFF0000LL + 400);
  EXPECT_EQ(std::get<std::int64_t>(value(values, "imu_age_us")), 250);
  EXPECT_EQ(std::get<Word>(value(values, "phase")).text, "controlling");
  EXPECT_EQ(std::get<Word>(value(values, "encoder_4_status")).text, "no_reading");
  EXPECT_NEAR(number(values, "roll_angle_deg"), 0.4, 1e-6);
  EXPECT_NEAR(number(values, "roll_rate_deg_s"), 1.0, 1e-6);
  EXPECT_NEAR(number(values, "command_2_deg"), 6.0, 1e-5);
  EXPECT_NEAR(number(values, "encoder_2_deg"), 3.0, 1e-5);
  EXPECT_NEAR(number(values, "specific_force_m_s2"), 30.0, 1e-6);
}

TEST(ExportFields, ACanardThatIsNotDrivenHasNoCommandAndASilentEncoderNoAngle) {
  const MadeFlight made;
  const ReplayedFlight source = made.source();
  TickReader reader{source};
  const auto values = reader.read(400);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value(values, "command_4_deg")));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value(values, "encoder_4_deg")));
}

TEST(ExportFields, WhereTheReplayCouldNotComeWhatStandsInTheLogIsStillThere) {
  const MadeFlight made;
  const ReplayedFlight source = made.source();
  TickReader reader{source};
  const auto values = reader.read(502);  // tick 552: fifty are missing before it
  EXPECT_NEAR(number(values, "time_s"), 0.452, 1e-12);
  EXPECT_FALSE(std::get<bool>(value(values, "replayed")));
  EXPECT_EQ(std::get<std::int64_t>(value(values, "rate_x_count")), 552);
  EXPECT_NEAR(number(values, "command_deg"), 2.76, 1e-6);
  EXPECT_NEAR(number(values, "command_1_deg"), 6.52, 1e-5);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value(values, "roll_angle_deg")));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(value(values, "verdict_1")));
}

TEST(ExportFields, WithoutAnyReplayTheClockBeginsWithTheFirstTick) {
  MadeFlight made;
  made.regeneration = {};
  made.report = {};
  const ReplayedFlight source = made.source();
  EXPECT_EQ(source.record(0), nullptr);
  EXPECT_EQ(source.time_s(MadeFlight::time(0)), 0.0);
}

}  // namespace
}  // namespace fantail::log_export
