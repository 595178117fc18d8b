// SPDX-License-Identifier: MIT
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

std::string all_text(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) {
    all += sentence + "\n";
  }
  return all;
}

class KeptColumns : public testing::Test {
 protected:
  [[nodiscard]] std::string log(const std::string& text) const { return folder_.write("run.csv", text); }

  static constexpr const char* foreign = "t,p,u\n0,1,0.1\n10,1,0.1\n20,1,0.1\n";
  const test::Folder folder_;
};

TEST_F(KeptColumns, BesideALogAreFollowedAndNamed) {
  const std::string file = log(foreign);
  folder_.write("run.csv.columns.toml", "[columns]\ntime = \"t:ms\"\nroll_rate = \"p:rad/s\"\ncanard = \"u:rad\"\n");
  const RollLog read = read_roll_log(file, {}, {.canard = true});
  EXPECT_DOUBLE_EQ(read.time_s[1], 0.01);
  EXPECT_DOUBLE_EQ(read.canard_rad[0], 0.1);
  EXPECT_NE(all_text(read.warnings).find("Columns from run.csv.columns.toml"), std::string::npos)
      << all_text(read.warnings);
}

TEST_F(KeptColumns, AnOptionCountsMoreThanWhatIsKept) {
  const std::string file = log(foreign);
  folder_.write("run.csv.columns.toml", "[columns]\ntime = \"t:s\"\nroll_rate = \"p:rad/s\"\ncanard = \"u:rad\"\n");
  const Reading reading{.columns = files::parse_columns("time=t:ms", "--columns", files::of_flight_csv)};
  EXPECT_DOUBLE_EQ(read_roll_log(file, reading, {.canard = true}).time_s[1], 0.01);
}

TEST_F(KeptColumns, WithAMistakeAreRefusedWithTheirPlace) {
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
TEST_F(KeptColumns, ARollAngleThatIsNotThereIsTheIntegralOfTheRate) {
  std::string text = "time_s,roll_rate_deg_s\n";
  for (int i = 0; i <= 300; ++i) {
    text += std::to_string(0.01 * i) + "," + std::to_string(180.0 / std::numbers::pi * std::cos(0.01 * i)) + "\n";
  }
  const RollLog read = read_roll_log(log(text), {}, {});
  ASSERT_EQ(read.roll_angle_rad.size(), 301U);
  for (std::size_t i = 0; i < read.time_s.size(); ++i) {
    ASSERT_NEAR(read.roll_angle_rad[i], std::sin(read.time_s[i]), 2e-5) << i;
  }
  EXPECT_NE(all_text(read.warnings).find("roll rate is integrated"), std::string::npos) << all_text(read.warnings);
}

TEST_F(KeptColumns, AMisspeltRollAngleIsNotReplaced) {
  expect_refused(ErrorKind::bad_data, {"no column roll_angle_deg", "did you mean roll_angle?"},
                 [&] { (void)read_roll_log(log("time_s,roll_rate_deg_s,roll_angle\n0,1,2\n1,1,2\n"), {}, {}); });
}

}  // namespace
}  // namespace fantail::logs
