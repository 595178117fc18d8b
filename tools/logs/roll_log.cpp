// SPDX-License-Identifier: MIT
#include "logs/roll_log.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

#include "logs/flight_file.hpp"
#include "logs/log_doubts.hpp"
#include "logs/roll_columns.hpp"
#include "logs/roll_rows.hpp"
#include "logs/summary.hpp"
#include "logs/table.hpp"
#include "logs/turns.hpp"
#include "report/csv.hpp"
#include "sim/input_error.hpp"
#include "sim/units.hpp"

namespace fantail::logs {
namespace {

using sim::InputError;
using sim::InputFault;

// By way of the table, so that a log gives the same figures as the flight.csv that was made of it.
RollLog roll_log_of_flight_log(const std::filesystem::path& file, const Reading& reading, const Needs& needs) {
  const std::string_view asked = reading.truth                          ? "--truth"
                                 : !reading.columns.empty()             ? "--column"
                                 : reading.angles != AngleUnit::degrees ? "--units"
                                                                        : "";
  if (!asked.empty()) {
    throw InputError{
        InputFault::bad_configuration,
        fmt::format("{}: {}: a flight log says itself what its values are, and holds no truth", file.string(), asked)};
  }
  const report::Flight flight = read_flight_log(file);
  RollLog log = make_roll_log(Table::parse(report::csv(flight), file.string()), reading, needs);
  log.burnout_s = flight.events.burnout_s;
  log.apogee_s = flight.events.apogee_s;
  log.warnings.insert(log.warnings.begin(), flight.notes.begin(), flight.notes.end());
  return log;
}

}  // namespace

RollLog make_roll_log(const Table& table, const Reading& reading, const Needs& needs) {
  RollLog log;
  log.name = table.name();
  const std::vector<FoundColumn> columns = find_roll_columns(table, reading, needs);
  read_roll_rows(table, columns, find_phase_column(table, reading), log);
  note_doubtful_units(log, reading.angles);
  if (reading.angles == AngleUnit::degrees) {
    for (const FoundColumn& column : columns) {
      if (column.is_angle) {
        std::ranges::for_each(log.*column.list, [](double& angle) { angle *= sim::radians_per_degree; });
      }
    }
  }
  if (const std::size_t turns = continue_over_turns(log); turns > 0) {
    log.warnings.push_back(
        fmt::format("the roll angle jumps by a whole turn {} times; it is read as one that goes on", turns));
  }
  note_doubtful_motion(log);
  return log;
}

RollLog read_roll_log(const std::filesystem::path& path, const Reading& reading, const Needs& needs) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    return is_flight_log(path) ? roll_log_of_flight_log(path, reading, needs)
                               : make_roll_log(Table::load(path.string()), reading, needs);
  }
  const std::filesystem::path file = path / "flight.csv";
  if (!std::filesystem::exists(file, ignored)) {
    if (std::filesystem::exists(path / "flight.ftl", ignored)) {
      return roll_log_of_flight_log(path / "flight.ftl", reading, needs);
    }
    throw InputError{InputFault::no_such_input, path.string() + ": this folder holds no flight.csv or flight.ftl"};
  }
  RollLog log = make_roll_log(Table::load(file.string()), reading, needs);
  log.name = path.string();
  const report::Events events = summary_events(path / "summary.json");
  log.burnout_s = events.burnout_s;
  log.apogee_s = events.apogee_s;
  return log;
}

}  // namespace fantail::logs
