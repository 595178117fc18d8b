// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "flight/write_csv.hpp"
#include "flight_log/made_flight.hpp"
#include "logs/flight_file.hpp"
#include "logs/refused.hpp"
#include "logs/roll_log.hpp"
#include "system/folder.hpp"
#include "text/degrees.hpp"

namespace fantail::logs {
namespace {

using flight_log::MadeFlight;
using test::expect_refused;
using text::ErrorKind;

TEST(OneFlight, ATableThatIsLongerUnderControlThanTheLogIsRefused) {
  flight_log::LogFile log;
  log.flights.emplace_back();
  const auto change = [&log](core::Phase phase, double time_s) {
    log.flights[0].events.push_back(
        {.time = std::chrono::duration_cast<core::Microseconds>(std::chrono::duration<double>{time_s}),
         .kind = protocol::LogEventKind::phase,
         .value = static_cast<std::uint8_t>(phase)});
  };
  change(core::Phase::controlling, 100.0);
  change(core::Phase::finished, 102.0);
  flight::Flight rows;
  rows.events = {.control_start_s = 1.0, .control_end_s = 3.0};
  expect_rows_of_log(rows, log, "day");
  rows.events.control_end_s = 3.2;
  expect_refused(
      ErrorKind::bad_data,
      {"day: flight.csv and flight.ftl do not show the same flight: control lasts 2.20 s", "2.00 s in flight.ftl"},
      [&] { expect_rows_of_log(rows, log, "day"); });
  const test::Folder folder;
  folder.write("summary.json", "{}");  // knows of outages
  expect_rows_of_log(rows, log, folder.path());
  rows.events.control_end_s.reset();  // of a part
  expect_rows_of_log(rows, log, "day");
}

// Of the made flight, a table as fantail fly writes one, with another zero of time.
class TableBesideLog : public testing::Test {
 protected:
  TableBesideLog() {
    folder_.write("day/flight.ftl", test::as_text(made_.bytes));
    rows_ = read_flight_log(folder_.path() / "day/flight.ftl");
    for (flight::Row& row : rows_.rows) {
      row.time_s -= 0.006;
    }
    first_ = static_cast<std::size_t>(std::ranges::find(rows_.rows, core::Phase::controlling, &flight::Row::phase) -
                                      rows_.rows.begin());
  }

  void write() { folder_.write("day/flight.csv", flight::csv(rows_)); }
  void expect_one_flight() {
    write();
    EXPECT_TRUE(read_flight(folder_.path() / "day").known.plan);
    EXPECT_FALSE(read_roll_log(folder_.path() / "day", {}, {}).time_s.empty());
    EXPECT_TRUE(flown_plan(folder_.path() / "day", {}));
  }
  void expect_two_flights(std::initializer_list<const char*> words) {
    write();
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_flight(folder_.path() / "day"); });
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_roll_log(folder_.path() / "day", {}, {}); });
    expect_refused(ErrorKind::bad_data, words, [&] { (void)read_roll_log(folder_.path() / "day/flight.csv", {}, {}); });
  }
  void each_controlled(const std::function<void(flight::Row&)>& change) {
    for (flight::Row& row : rows_.rows) {
      if (row.phase == core::Phase::controlling) {
        change(row);
      }
    }
  }
  flight::Row& controlled(std::size_t i) { return rows_.rows[first_ + i]; }

  const MadeFlight made_ = flight_log::make_flight();
  const test::Folder folder_;
  flight::Flight rows_;
  std::size_t first_ = 0;
};

TEST_F(TableBesideLog, OfTheSameFlightIsTaken) { expect_one_flight(); }

TEST_F(TableBesideLog, WithACommandThatTheLogDoesNotHaveIsRefusedWithTheTime) {
  controlled(500).command_rad += text::radians(0.1);
  const std::string at = fmt::format("at {:.3f} s the roll command is ", controlled(500).time_s);
  expect_two_flights({"day: flight.csv and flight.ftl do not show the same flight", at.c_str(),
                      "deg in flight.csv, and near that time at most ", "deg in flight.ftl"});
}

TEST_F(TableBesideLog, WithARollThatTheLogDoesNotHaveIsRefused) {
  controlled(500).roll_angle_rad += text::radians(1.0);
  expect_two_flights({"do not show the same flight", "the roll angle is "});
  controlled(500).roll_angle_rad = 1e300;
  expect_two_flights({"the roll angle is 5.73e+301 deg in flight.csv, and near that time at most "});
}

TEST_F(TableBesideLog, WithoutTheBeginOfControlIsLaidBesideItAllTheSame) {
  rows_.rows.erase(rows_.rows.begin(), rows_.rows.begin() + static_cast<std::ptrdiff_t>(first_) + 400);
  first_ = 0;
  expect_one_flight();
  controlled(500).command_rad += text::radians(0.1);
  expect_two_flights({"do not show the same flight"});
}

TEST_F(TableBesideLog, WhoseNumbersAreRoundedIsTaken) {
  each_controlled([](flight::Row& row) {
    row.command_rad = text::radians(0.1 * std::round(10.0 * text::degrees(row.command_rad)));
    row.roll_angle_rad = 0.001 * std::round(1000.0 * row.roll_angle_rad);
  });
  expect_one_flight();
}

TEST_F(TableBesideLog, WithFewerRowsOrATurnOfItsOwnIsTaken) {
  rows_.rows_per_line = 20;
  each_controlled(
      [](flight::Row& row) { row.roll_angle_rad = std::remainder(row.roll_angle_rad, text::radians(30.0 * 12)); });
  expect_one_flight();
  rows_.rows_per_line = 1;
  std::erase_if(rows_.rows, [](const flight::Row& row) { return row.time_s > 1.0 && row.time_s < 1.5; });
  expect_one_flight();
}

TEST_F(TableBesideLog, IsTakenWhereNothingOfItCanBeCompared) {
  each_controlled([](flight::Row& row) { row.command_rad = row.roll_angle_rad = std::nan(""); });
  write();
  EXPECT_TRUE(read_flight(folder_.path() / "day").known.plan);
}

TEST_F(TableBesideLog, UnderControlIsRefusedWhereTheWholeLogShowsNone) {
  flight_log::MadeFlightOptions on_the_pad;
  on_the_pad.length = core::Microseconds{400'000};
  folder_.write("day/flight.ftl", test::as_text(flight_log::make_flight(on_the_pad).bytes));
  expect_two_flights({"do not show the same flight", "no control in flight.ftl"});
}

}  // namespace
}  // namespace fantail::logs
