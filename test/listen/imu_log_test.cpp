// SPDX-License-Identifier: MIT
#include "listen/imu_log.hpp"

#include <algorithm>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "figures.hpp"
#include "logs/refused.hpp"

namespace fantail::listen {
namespace {

using test::expect_refused;
using text::ErrorKind;

files::Sources parse(const std::string& text) { return files::parse_columns(text, "--columns", heard_quantities); }

const files::Sources sources = parse("time=t:ms,axial=a:g,height=h:ft");

flight::Table table(const std::string& rows) { return flight::Table::parse("t,a,h\n" + rows, "log.csv"); }

// 20 rows, 100 ms apart; line n of the file is row n - 2.
std::string rows(const std::string& instead_of_row_7 = "700,1,0\n") {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += i == 7 ? instead_of_row_7 : fmt::format("{},1,0\n", 100 * i);
  }
  return text;
}

/// The note with this word.
std::string note(const ImuLog& log, const std::string& word) {
  const auto found =
      std::ranges::find_if(log.notes, [&](const std::string& note) { return note.find(word) != std::string::npos; });
  return found == log.notes.end() ? std::string{} : *found;
}

/// Which rates it says not to be in the log.
std::vector<std::string> rates_lacking(const ImuLog& log) {
  std::vector<std::string> rates{"roll", "pitch", "yaw"};
  std::erase_if(rates, [said = note(log, "rate")](const auto& r) { return said.find(r) == std::string::npos; });
  return rates;
}

using Words = std::vector<std::string>;

TEST(ImuLog, HasSiUnitsAndSaysWhatItTakesForGranted) {
  const ImuLog log = imu_log(table(rows("700,2,10\n")), sources);
  ASSERT_EQ(log.axial.value.size(), 20U);
  EXPECT_NEAR(log.axial.time_s[7], 0.7, 1e-12);
  EXPECT_NEAR(log.axial.value[7], 2.0 * 9.80665, 1e-12);
  EXPECT_NEAR(log.height.value[7], 3.048, 1e-12);
  EXPECT_NEAR(log.interval_s, 0.1, 1e-12);
  EXPECT_FALSE(log.roll_rate.is_there());
  EXPECT_NE(note(log, "y and z"), "");
  EXPECT_EQ(rates_lacking(log), (Words{"roll", "pitch", "yaw"}));
}

TEST(ImuLog, AddsOneGToAForceWhoseZeroIsThePad) {
  const ImuLog log = imu_log(table(rows()), parse("time=t:ms,axial_from_rest=a:g"));
  EXPECT_NEAR(log.axial.value[0], 2.0 * 9.80665, 1e-6);
}

TEST(ImuLog, TakesTheLastOfRowsWithOneTime) {
  const ImuLog log = imu_log(table(rows("600,3,1\n600,4,\n")), sources);
  EXPECT_EQ(log.axial.value.size(), 19U);
  EXPECT_NEAR(log.axial.value[6], 4.0 * 9.80665, 1e-12);
  EXPECT_NEAR(log.height.value[6], 0.3048, 1e-12) << "a cell without a number has no news";
  EXPECT_EQ(figures(note(log, "line 9")), (Words{"2", "21", "9"})) << log.notes[0];
}

TEST(ImuLog, CountsWhatIsNoNumberAsNotSampled) {
  const ImuLog log = imu_log(table(rows("700,NaN,0\n")), sources);
  EXPECT_EQ(log.axial.value.size(), 19U);
  EXPECT_EQ(log.height.value.size(), 20U);
  EXPECT_EQ(figures(note(log, " a ")), (Words{"1", "20", "9"}));
}

TEST(ImuLog, IsRefusedByFileAndLine) {
  const auto refused = [](const flight::Table& what, std::initializer_list<const char*> parts) {
    expect_refused(ErrorKind::bad_data, parts, [&] { (void)imu_log(what, sources); });
  };
  refused(table(rows("550,1,0\n")), {"log.csv:9", "t is 550 after 600 in line 8"});
  refused(table(rows("x,1,0\n")), {"1 of 20 rows", "line 9, t \"x\""});
  refused(table("0,1,0\n10,1,0\n"), {"2 samples of the axial specific force; at least 10"});
  refused(table(""), {"0 samples"});
  refused(flight::Table::parse("t,acc,h\n0,1,2\n", "log.csv"), {"no column a ", "t, acc, h", "--columns axial="});
  refused(flight::Table::parse("t,a\n0,1\n", "log.csv"), {"no column h", "--columns height="});
  refused(table(rows() + "90000000,1,0\n"), {"longer than 21600 s", "check that the time t is in ms"});
}

// Seconds read as milliseconds: 20 s of 100 Hz are 20 ms of 100 kHz.
TEST(ImuLog, WhoseTimeIsHardlyInItsUnitIsRefused) {
  const auto log = [](double interval, int samples) {
    std::string text = "t,a\n";
    for (int i = 0; i < samples; ++i) {
      text += fmt::format("{},1\n", interval * i);
    }
    return flight::Table::parse(text, "log.csv");
  };
  const files::Sources in_ms = parse("time=t:ms,axial=a:g");
  expect_refused(ErrorKind::bad_data, {"log.csv", "20 ms", "shorter than 1 s", "check that the time t is in ms"},
                 [&] { (void)imu_log(log(0.01, 2001), in_ms); });
  expect_refused(ErrorKind::bad_data, {"log.csv", "100000 samples a second", "check that the time t is in ms"},
                 [&] { (void)imu_log(log(0.01, 150'001), in_ms); });
  EXPECT_EQ(imu_log(log(0.0625, 17'000), in_ms).axial.time_s.size(), 17'000U) << "16 kHz";
}

TEST(ImuLog, NamesTheRatesThatItLacks) {
  const flight::Table with = flight::Table::parse(
      "t,a,r\n" +
          [] {
            std::string text;
            for (int i = 0; i < 20; ++i) {
              text += fmt::format("{},1,0\n", 100 * i);
            }
            return text;
          }(),
      "log.csv");
  const ImuLog without_tilt = imu_log(with, parse("time=t:ms,axial=a:g,roll_rate=r:rpm"));
  EXPECT_EQ(rates_lacking(without_tilt), (Words{"pitch", "yaw"}));
  EXPECT_NE(note(without_tilt, "rate").find("guide"), std::string::npos) << "its direction is kept";
  const ImuLog without_pitch = imu_log(with, parse("time=t:ms,axial=a:g,roll_rate=r:rpm,yaw_rate=r:rpm"));
  EXPECT_EQ(rates_lacking(without_pitch), Words{"pitch"});
  EXPECT_EQ(note(without_pitch, "rate").find("guide"), std::string::npos);
}

TEST(ImuLog, OfNothingButForceIsNoLog) {
  expect_refused(ErrorKind::bad_data, {"the column of the time is missing", "time=COLUMN:UNIT"},
                 [] { (void)imu_log(table(rows()), parse("axial=a:g")); });
  expect_refused(ErrorKind::bad_data, {"axial specific force"},
                 [] { (void)imu_log(table(rows()), parse("time=t:s")); });
}

TEST(ImuLog, TakesTheHeightOfABarometersOwnLog) {
  ImuLog log = imu_log(table(rows()), parse("time=t:ms,axial=a:g"));
  add_barometer(log, flight::Table::parse("s,z\n0,5\n1,6\n", "b.csv"), parse("time=s:s,height=z:m"));
  EXPECT_EQ(log.height.time_s, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(log.height.value, (std::vector<double>{5.0, 6.0}));
}

TEST(Gaps, AreLongerThanWhatIsBridged) {
  const Signal signal{.words = "a", .time_s = {0.0, 0.01, 0.02, 0.13, 0.23}, .value = {0, 0, 0, 0, 0}};
  const std::vector<Gap> found = gaps(signal, 0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].from_s, 0.02);
  EXPECT_EQ(found[0].to_s, 0.13);
}

TEST(Gaps, OfAFastLogBeginAtTheStaleTimeAndOfASlowOneAtTenIntervals) {
  EXPECT_EQ(longest_bridge_s(0.001, 0.005), 0.005);
  EXPECT_DOUBLE_EQ(longest_bridge_s(0.01, 0.005), 0.1);
}

}  // namespace
}  // namespace fantail::listen
