// SPDX-License-Identifier: MIT
#include "logs/flight_file.hpp"

#include <fmt/core.h>

#include "flight_log/integrity.hpp"
#include "flight_log/to_report.hpp"
#include "report/results.hpp"
#include "text/error.hpp"
#include "text/quoting.hpp"

namespace fantail::logs {
namespace {

using text::Error;
using text::ErrorKind;

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// Of what fantail fly writes together: a folder, or flight.csv or flight.ftl in one. Empty for every other file.
std::filesystem::path folder_of_flight(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return path;
  }
  if (path.filename() != "flight.csv" && path.filename() != "flight.ftl") {
    return {};
  }
  return path.has_parent_path() ? path.parent_path() : ".";
}

/// The log at `path`, or the one beside the flight.csv of fantail fly; empty where there is none.
std::optional<flight_log::LogFile> log_of(const std::filesystem::path& path) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  const bool is_log = !is_folder && is_flight_log(path);
  if (!is_folder && !is_log && path.filename() != "flight.csv") {
    return {};
  }
  const std::filesystem::path log = is_log ? path : (is_folder ? path : path.parent_path()) / "flight.ftl";
  return is_there(log) ? std::optional{flight_log::read_log_file(log)} : std::nullopt;
}

/// The rows of a table, with what is kept beside it of its columns.
flight::Flight read_rows(const std::filesystem::path& file, Reading reading) {
  const std::string kept = follow_kept_sources(file, reading);
  flight::Flight flight =
      read_flight_csv(files::load(file, files::Beside::ftl), reading, {.roll_angle = false, .roll_rate = false});
  if (!kept.empty()) {
    flight.notes.insert(flight.notes.begin(), kept);
  }
  return flight;
}

/// Before something is taken from beside `path`.
void expect_one_flight_beside(const std::filesystem::path& path, const std::filesystem::path& folder,
                              const Reading& reading) {
  if (path.filename() == "flight.csv") {
    const flight::Flight rows = read_rows(path, reading);
    expect_one_flight(folder, &rows);
  } else {
    expect_one_flight(folder, nullptr);
  }
}

// It knows the plan; a run in the tunnel shows in it too.
void add_plan(flight::Flight& flight, const flight_log::LogFile& log) {
  if (!flight_log::is_one_flight(log) || !log.flights.front().plan) {
    return;
  }
  flight.plan = *log.flights.front().plan;
  flight.known.plan = true;
  flight.tunnel = flight.plan.run.start == core::Start::tunnel;
}

}  // namespace

std::filesystem::path flight_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(path, ignored)) {
    return path;
  }
  for (const char* const name : {"flight.csv", "flight.ftl"}) {
    if (is_there(path / name)) {
      return path / name;
    }
  }
  throw Error{ErrorKind::no_such_input, path.string() + ": this folder contains no flight.csv or flight.ftl"};
}

std::optional<flight::FlownAirframe> flown_airframe(const std::filesystem::path& path, const Reading& reading) {
  const std::filesystem::path folder = folder_of_flight(path);
  auto airframe = folder.empty() ? std::nullopt : report::summary_airframe(folder / "summary.json");
  if (airframe) {
    expect_one_flight_beside(path, folder, reading);
  }
  return airframe;
}

std::optional<core::FlightPlan> flown_plan(const std::filesystem::path& path, const Reading& reading) {
  const std::optional<flight_log::LogFile> log = log_of(path);
  if (!log || !flight_log::is_one_flight(*log)) {
    return {};
  }
  if (!is_flight_log(path)) {
    expect_one_flight_beside(path, folder_of_flight(path), reading);
  }
  return log->flights.front().plan;
}

void expect_rows_of_log_beside(const flight::Flight& rows, const std::filesystem::path& path) {
  const std::optional<flight_log::LogFile> log = log_of(path);
  if (log && flight_log::is_one_flight(*log)) {
    std::error_code ignored;
    expect_rows_of_log(rows, *log, std::filesystem::is_directory(path, ignored) ? path : path.parent_path());
  }
}

bool is_flight_log(const std::filesystem::path& path) { return path.extension() == ".ftl"; }

flight::Flight read_flight_log(const std::filesystem::path& file) {
  return replayed_flight(flight_log::read_log_file(file));
}

flight::Flight replayed_flight(const flight_log::LogFile& log) {
  const auto refuse = [&log](const std::string& complaint) {
    throw Error{ErrorKind::bad_data, log.name + ": " + complaint};
  };
  if (!flight_log::is_one_flight(log)) {
    refuse(
        fmt::format("contains {} flights; extract one with fantail log export {} --to csv --flight N, N from 1 to {}",
                    log.flights.size(), text::shell_word(log.name), log.flights.size()));
  }
  std::vector<flight_log::Regeneration> replays;
  for (const flight_log::Flight& flight : log.flights) {
    if (!flight.plan) {
      refuse("the flight cannot be replayed: " +
             (flight.plan_fault.empty() ? std::string{"its plan is missing"} : flight.plan_fault));
    }
    replays.push_back(flight_log::regenerate(flight, *flight.plan));
    if (replays.back().compared == 0) {
      refuse("the flight cannot be replayed. " + replays.back().obstacle);
    }
  }
  std::vector<flight_log::Part> parts;
  parts.reserve(replays.size());
  for (std::size_t i = 0; i < replays.size(); ++i) {
    parts.push_back({log.flights[i], replays[i]});
  }
  flight::Flight result = flight_log::to_report(parts);
  if (const std::string foreign = flight_log::foreign_bytes_text(log); !foreign.empty()) {
    result.notes.push_back("In the log, " + foreign + ".");
  }
  return result;
}

flight::Flight read_flight(const std::filesystem::path& path) {
  const std::filesystem::path file = flight_file(path);
  if (is_flight_log(file)) {
    if (file != path) {
      expect_one_flight(path, nullptr);
    }
    return read_flight_log(file);
  }
  flight::Flight flight = read_rows(file, {.options = ""});
  if (file == path) {
    flight.scenario = path.filename().string();
    return flight;
  }
  expect_one_flight(path, &flight);
  report::add_summary(flight, path / "summary.json");
  if (flight.scenario.empty()) {  // no summary, or one that names none
    flight.scenario = std::filesystem::absolute(file).lexically_normal().parent_path().filename().string();
  }
  if (is_there(path / "trajectory.csv")) {
    const flight::Table table = flight::Table::load((path / "trajectory.csv").string());
    flight.path_frame = flight::path_frame(table);
    flight.path = flight::read_trajectory(table, flight.path_frame);
  }
  if (is_there(path / "turning.csv")) {
    flight.turning = flight::read_turning(flight::Table::load((path / "turning.csv").string()));
  }
  if (is_there(path / "without_control.csv")) {
    flight.without_control = flight::read_free_roll(flight::Table::load((path / "without_control.csv").string()));
  }
  if (const std::optional<flight_log::LogFile> log = log_of(path)) {
    add_plan(flight, *log);
  }
  return flight;
}

}  // namespace fantail::logs
