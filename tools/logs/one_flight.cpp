// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/core.h>

#include "logs/flight_file.hpp"
#include "report/figures.hpp"
#include "report/results.hpp"
#include "text/error.hpp"
#include "text/input_file.hpp"
#include "text/number.hpp"
#include "text/sha256.hpp"

namespace fantail::logs {
namespace {

// Times in a table may be written with three decimals.
constexpr double rounding_s = 0.002;

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& difference) {
  throw text::Error{
      text::ErrorKind::bad_data,
      fmt::format("{}: its files are of two flights: {}; put the files of each into a separate folder, or remove "
                  "summary.json",
                  folder.string(), difference)};
}

struct Change {
  bool is_there = false;  ///< between two rows, and when it is said to be
  std::optional<double> elsewhere_s{};
};

/// The rows come under control, or leave it, and one time that this is said to have been.
Change find_change(const std::vector<flight::Row>& rows, bool begins, const std::optional<double>& said_s) {
  Change change;
  for (std::size_t i = 1; said_s && !change.is_there && i < rows.size(); ++i) {
    const bool is_before = rows[i - 1].phase == core::Phase::controlling;
    if (is_before != begins && (rows[i].phase == core::Phase::controlling) == begins) {
      change.elsewhere_s = rows[i].time_s;
      change.is_there = *said_s > rows[i - 1].time_s - rounding_s && *said_s < rows[i].time_s + rounding_s;
    }
  }
  if (change.is_there) {
    change.elsewhere_s.reset();
  }
  return change;
}

/// The folder's flight.ftl is the log that summary.json was written with.
void expect_log_of_summary(const std::filesystem::path& folder) {
  const std::optional<std::string> said = report::summary_log_sha256(folder / "summary.json");
  const std::optional<std::string> bytes = said ? text::read_if_there(folder / "flight.ftl") : std::nullopt;
  if (bytes && text::sha256(std::as_bytes(std::span{*bytes})) != *said) {
    refuse(folder, "flight.ftl does not have the SHA-256 that summary.json gives as log_sha256");
  }
}

void expect_rows_of_summary(const flight::Flight& rows, const std::filesystem::path& folder) {
  const report::SummaryOfControl said = report::summary_of_control(folder / "summary.json");
  const Change begins = find_change(rows.rows, true, said.start_s);
  const Change ends = find_change(rows.rows, false, said.end_s);
  for (const auto& [change, said_s, what] :
       {std::tuple{begins, said.start_s, "come under"}, {ends, said.end_s, "leave"}}) {
    if (change.elsewhere_s) {
      refuse(folder, fmt::format("the rows of flight.csv {} control at {} s, but at {} s in summary.json", what,
                                 text::fixed(*change.elsewhere_s, 3), text::fixed(*said_s, 3)));
    }
  }
  const report::Figures figures = report::figures(rows);
  // Of all rows under control, and none but they.
  if (begins.is_there && ends.is_there && said.time_s && figures.control_time_s && figures.roll_turns &&
      said.roll_turns && std::abs(*said.time_s - *figures.control_time_s) < rounding_s &&
      std::abs(*said.roll_turns - *figures.roll_turns) > 0.001) {
    refuse(folder, fmt::format("under control the rocket makes {} turns in flight.csv, but {} in summary.json",
                               text::fixed(*figures.roll_turns, 3), text::fixed(*said.roll_turns, 3)));
  }
}

}  // namespace

void expect_one_flight(const std::filesystem::path& folder, const flight::Flight* rows) {
  if (rows != nullptr) {
    expect_rows_of_summary(*rows, folder);
  }
  expect_log_of_summary(folder);
  std::error_code ignored;
  if (rows != nullptr && std::filesystem::exists(folder / "flight.ftl", ignored)) {
    const flight_log::LogFile log = flight_log::read_log_file(folder / "flight.ftl");
    if (flight_log::is_one_flight(log)) {
      expect_rows_of_log(*rows, log, folder);
    }
  }
}

}  // namespace fantail::logs
