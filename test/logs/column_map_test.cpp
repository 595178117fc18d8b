// SPDX-License-Identifier: MIT
#include "logs/column_map.hpp"

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "logs/refused.hpp"
#include "logs/roll_log.hpp"
#include "system/folder.hpp"

namespace fantail::logs {
namespace {

using test::expect_refused;
using text::ErrorKind;

ColumnMap parse(const std::string& text) { return parse_column_map(text, "--columns"); }

std::string joined(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) {
    all += sentence + "\n";
  }
  return all;
}

TEST(ColumnMap, SaysWhichColumnIsWhatAndInWhichUnit) {
  const ColumnMap map = parse("time=t:ms,roll_rate=gyro:x:rad/s,canard_deg=u:deg,phase=mode");
  ASSERT_EQ(map.size(), 4U);
  EXPECT_EQ(map[0].ours, "time_s");
  EXPECT_EQ(map[1].theirs, "gyro:x") << "a name may contain a colon";
  EXPECT_EQ(map[1].unit, "rad/s");
  EXPECT_EQ(map[3].unit, "");
  EXPECT_EQ(column_map_words(map), "time is t in ms, roll_rate is gyro:x in rad/s, canard is u in deg, phase is mode");
}

TEST(ColumnMap, NothingIsGuessed) {
  const auto refuse = [](const std::string& text, std::initializer_list<const char*> words) {
    expect_refused(ErrorKind::bad_configuration, words, [&] { (void)parse(text); });
  };
  refuse("roll_rate=p", {"--columns roll_rate=p", "unit is missing", "allowed: deg/s, rad/s"});
  refuse("roll_rate=p:rad", {"\"rad\" is no unit of roll_rate", "deg/s, rad/s, mdeg/s, rpm, turn/s"});
  refuse("time=t:min", {"\"min\"", "allowed: s, ms, us"});
  refuse("rol_rate=p:rad/s", {"unknown quantity \"rol_rate\"", "did you mean roll_rate?"});
  refuse("time=t:s,time=u:s", {"time=u:s", "twice"});
  refuse("time", {"QUANTITY=COLUMN:UNIT"});
  refuse("time=t:s,", {"QUANTITY=COLUMN:UNIT"});
}

class ColumnMapFile : public testing::Test {
 protected:
  [[nodiscard]] std::string log(const std::string& text) const { return folder_.write("run.csv", text); }

  static constexpr const char* foreign = "t,p,u\n0,1,0.1\n10,1,0.1\n20,1,0.1\n";
  const test::Folder folder_;
};

TEST_F(ColumnMapFile, ComesBackAsItWasKept) {
  const ColumnMap map = parse("time=t:ms,roll_rate=a \"quoted\" \\ name:rad/s,phase=mode");
  const std::string file = folder_.write("x.toml", column_map_toml(map, "run.csv"));
  const ColumnMap back = read_column_map(file);
  ASSERT_EQ(back.size(), 3U);
  for (const MappedColumn& column : map) {
    const auto same = std::ranges::find(back, column.ours, &MappedColumn::ours);
    ASSERT_NE(same, back.end()) << column.ours;
    EXPECT_EQ(same->theirs, column.theirs);
    EXPECT_EQ(same->unit, column.unit);
  }
}

TEST_F(ColumnMapFile, BesideALogIsFollowedAndNamed) {
  const std::string file = log(foreign);
  folder_.write("run.csv.columns.toml", "[columns]\ntime = \"t:ms\"\nroll_rate = \"p:rad/s\"\ncanard = \"u:rad\"\n");
  const RollLog read = read_roll_log(file, {}, {.canard = true});
  EXPECT_DOUBLE_EQ(read.time_s[1], 0.01);
  EXPECT_DOUBLE_EQ(read.canard_rad[0], 0.1);
  EXPECT_NE(joined(read.warnings).find("Columns as run.csv.columns.toml says"), std::string::npos)
      << joined(read.warnings);
}

TEST_F(ColumnMapFile, AnOptionCountsMoreThanWhatIsKept) {
  const std::string file = log(foreign);
  folder_.write("run.csv.columns.toml", "[columns]\ntime = \"t:s\"\nroll_rate = \"p:rad/s\"\ncanard = \"u:rad\"\n");
  flight::Reading reading;
  apply_map(parse("time=t:ms"), reading);
  EXPECT_DOUBLE_EQ(read_roll_log(file, reading, {.canard = true}).time_s[1], 0.01);
  const ColumnMap both = merged(parse("time=t:ms"), parse("time=t:s,canard=u:rad"));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].unit, "ms");
}

TEST_F(ColumnMapFile, WithAMistakeIsRefusedWithItsPlace) {
  const std::string file = log(foreign);
  const auto refuse = [&](const char* text, ErrorKind kind, std::initializer_list<const char*> words) {
    folder_.write("run.csv.columns.toml", text);
    expect_refused(kind, words, [&] { (void)read_roll_log(file, {}, {}); });
  };
  refuse("[columns]\ntime = \"t:sec\"\n", ErrorKind::bad_configuration, {"run.csv.columns.toml:2", "\"sec\"", "s, ms"});
  refuse("[colums]\ntime = \"t:s\"\n", ErrorKind::bad_configuration, {"run.csv.columns.toml", "colums"});
  refuse("[columns\n", ErrorKind::bad_data, {"run.csv.columns.toml"});
}

// Rate cos(t): the angle is sin(t), to the error of the trapezium rule.
TEST_F(ColumnMapFile, ARollAngleThatIsNotThereIsTheIntegralOfTheRate) {
  std::string text = "time_s,roll_rate_deg_s\n";
  for (int i = 0; i <= 300; ++i) {
    text += std::to_string(0.01 * i) + "," + std::to_string(180.0 / std::numbers::pi * std::cos(0.01 * i)) + "\n";
  }
  const RollLog read = read_roll_log(log(text), {}, {});
  ASSERT_EQ(read.roll_angle_rad.size(), 301U);
  for (std::size_t i = 0; i < read.time_s.size(); ++i) {
    ASSERT_NEAR(read.roll_angle_rad[i], std::sin(read.time_s[i]), 2e-5) << i;
  }
  EXPECT_NE(joined(read.warnings).find("integral of the roll rate"), std::string::npos) << joined(read.warnings);
}

TEST_F(ColumnMapFile, AMisspeltRollAngleIsNotReplaced) {
  expect_refused(ErrorKind::bad_data, {"no column roll_angle_deg", "did you mean roll_angle?"},
                 [&] { (void)read_roll_log(log("time_s,roll_rate_deg_s,roll_angle\n0,1,2\n1,1,2\n"), {}, {}); });
}

}  // namespace
}  // namespace fantail::logs
