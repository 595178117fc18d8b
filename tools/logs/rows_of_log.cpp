// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "flight_log/integrity.hpp"
#include "flight_log/regenerate.hpp"
#include "logs/flight_file.hpp"
#include "report/figures.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::logs {
namespace {

constexpr double tick_s = 1e-3;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double in_seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& difference) {
  throw text::Error{text::ErrorKind::bad_data,
                    fmt::format("{}: flight.csv and flight.ftl do not show the same flight: {}; put the files of "
                                "each flight into a separate folder",
                                folder.string(), difference)};
}

/// What a table and a log both have of a tick.
struct Tick {
  double time_s = 0.0;
  bool is_control = false;
  double command_rad = 0.0;
  double roll_rad = 0.0;  ///< of a log not a number where no replay tells it
};

struct Signal {
  std::string_view name;
  double Tick::* value;
};
constexpr std::array signals{Signal{"roll command", &Tick::command_rad}, Signal{"roll angle", &Tick::roll_rad}};

std::vector<Tick> logged_ticks(const flight_log::LogFile& log) {
  std::vector<Tick> all;
  for (const flight_log::Flight& flight : log.flights) {
    const flight_log::Regeneration replay =
        flight.plan ? flight_log::regenerate(flight, *flight.plan) : flight_log::Regeneration{};
    for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
      const protocol::LogTick& tick = flight.ticks[i].tick;
      const bool is_replayed = replay.differing == 0 && i < replay.records.size() && replay.records[i];
      all.push_back(
          {.time_s = in_seconds(tick.time),
           .is_control = tick.phase == core::Phase::controlling,
           .command_rad = static_cast<double>(tick.command.radians()),
           .roll_rad = is_replayed ? static_cast<double>(replay.records[i]->motion.roll_angle.radians()) : unknown});
    }
  }
  return all;
}

/// Half of the last decimal that a table has, in degrees or radians; a part of a thousandth of a degree is lost where
/// it was written with seven digits.
double rounding_rad(const std::vector<Tick>& rows, double Tick::* value) {
  const auto is_all_on = [&](double grid_rad) {
    return std::ranges::all_of(rows, [&](const Tick& row) {
      const double steps = row.*value / grid_rad;
      return std::isnan(steps) || std::abs(steps - std::round(steps)) < 1e-6;
    });
  };
  for (const double grid_rad : {text::radians(0.1), 1e-3, text::radians(0.01), 1e-4}) {
    if (is_all_on(grid_rad)) {
      return 0.51 * grid_rad;
    }
  }
  return text::radians(1e-3);
}

struct Difference {
  std::size_t row = 0;  ///< of those under control
  std::string_view signal;
  double in_table_rad = 0.0;
  double in_log_rad = 0.0;  ///< of the ticks near that row the nearest
  bool by_turns = false;    ///< whole turns were added to that of the table
};

std::string text_of(const Difference& found, double time_s) {
  return fmt::format(
      "at {} s the {} is {} deg in flight.csv{}, and near that time {} {} deg in flight.ftl", text::fixed(time_s, 3),
      found.signal, text::fixed(text::degrees(found.in_table_rad), 3), found.by_turns ? ", except for whole turns" : "",
      found.in_log_rad < found.in_table_rad ? "at most" : "at least", text::fixed(text::degrees(found.in_log_rad), 3));
}

/// Rows under control, laid beside the ticks of a log at one shift of their clocks. Nobody knows the shift to a
/// millisecond, and a table may hold means, so that a value counts as the log's where one of the log's near it is.
class Beside {
 public:
  Beside(const std::vector<Tick>& rows, const std::vector<Tick>& ticks)
      : rows_{rows},
        ticks_{ticks},
        step_s_{rows.size() < 2 ? 0.0
                                : (rows.back().time_s - rows.front().time_s) / static_cast<double>(rows.size() - 1)},
        tolerance_rad_{rounding_rad(rows, signals[0].value), rounding_rad(rows, signals[1].value)} {}

  /// Between two shifts that are tried.
  [[nodiscard]] double reach_s() const { return std::max(2.0 * tick_s, step_s_); }

  /// The first row that has not what the log has; empty: there is none.
  [[nodiscard]] std::optional<Difference> difference(double shift_s) const {
    const double window_s = 1.5 * reach_s();
    auto first = ticks_.begin();
    auto last = first;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const double at_s = rows_[i].time_s + shift_s;
      first = std::find_if(first, ticks_.end(), [&](const Tick& tick) { return tick.time_s >= at_s - window_s; });
      last = std::find_if(std::max(first, last), ticks_.end(),
                          [&](const Tick& tick) { return tick.time_s > at_s + window_s; });
      if (static_cast<double>(last - first) < std::floor(2.0 * window_s / tick_s + 1e-6)) {
        continue;  // the tick itself may be one of those that are missing
      }
      for (std::size_t s = 0; s < signals.size(); ++s) {
        if (const auto found = difference(i, s, first, last)) {
          return found;
        }
      }
    }
    return {};
  }

 private:
  using Place = std::vector<Tick>::const_iterator;

  [[nodiscard]] std::optional<Difference> difference(std::size_t row, std::size_t signal, Place first,
                                                     Place last) const {
    const auto [name, value] = signals[signal];
    if (std::any_of(first, last, [of = value](const Tick& tick) { return std::isnan(tick.*of); })) {
      return {};
    }
    const auto [low, high] =
        std::minmax_element(first, last, [of = value](const Tick& a, const Tick& b) { return a.*of < b.*of; });
    constexpr double turn_rad = 2.0 * std::numbers::pi;
    const double table_rad = rows_[row].*value;
    double turns = std::round((0.5 * (*low.*value + *high.*value) - table_rad) / turn_rad);  // it may be kept in one
    turns = std::abs(turns) < 1e6 ? turns : 0.0;
    const double here_rad = table_rad + turns * turn_rad;
    const double log_rad = std::clamp(here_rad, *low.*value, *high.*value);
    if (!(std::abs(here_rad - log_rad) > tolerance_rad_[signal])) {  // nor where the table has no number
      return {};
    }
    return Difference{
        .row = row, .signal = name, .in_table_rad = here_rad, .in_log_rad = log_rad, .by_turns = turns != 0.0};
  }

  const std::vector<Tick>& rows_;
  const std::vector<Tick>& ticks_;
  double step_s_;
  std::array<double, signals.size()> tolerance_rad_;
};

struct Table {
  std::vector<Tick> controlled{};
  std::optional<double> before_s{};  ///< the row before them
};

Table table_of(const flight::Flight& flight) {
  Table table;
  for (const flight::Row& row : flight.rows) {
    if (row.phase == core::Phase::controlling) {
      table.controlled.push_back(
          {.time_s = row.time_s, .is_control = true, .command_rad = row.command_rad, .roll_rad = row.roll_angle_rad});
    } else if (table.controlled.empty()) {
      table.before_s = row.time_s;
    }
  }
  return table;
}

/// When on the log's clock the first row under control may have been. Of a log that begins or ends under control, half
/// of the rows at least are taken to be in it: fewer agree with anything.
std::pair<double, double> possible_begin_s(const Table& table, const std::vector<Tick>& ticks) {
  const auto begin = std::ranges::find(ticks, true, &Tick::is_control);
  const auto end = std::find_if(ticks.rbegin(), ticks.rend(), [](const Tick& tick) { return tick.is_control; });
  const double first_s = table.controlled.front().time_s;
  const double lasts_s = table.controlled.back().time_s - first_s;
  const double from_s = begin == ticks.begin() ? begin->time_s - 0.5 * lasts_s : std::prev(begin)->time_s + tick_s;
  const double ends_s = end == ticks.rbegin() ? end->time_s - 0.5 * lasts_s : end.base()->time_s - lasts_s;
  const double to_s = table.before_s ? std::min(begin->time_s + first_s - *table.before_s, ends_s) : ends_s;
  return {from_s, std::max(from_s, to_s)};
}

void expect_as_long(const flight::Flight& rows, const flight_log::Flight& log, const std::filesystem::path& folder) {
  std::optional<core::Microseconds> begin;
  std::optional<core::Microseconds> end;
  for (const protocol::LogEvent& event : log.events) {
    if (event.kind == protocol::LogEventKind::phase) {
      auto& time = static_cast<core::Phase>(event.value) == core::Phase::controlling ? begin : end;
      time = event.time;
    }
  }
  const flight::Events& events = rows.events;
  if (!begin || !end || !events.control_start_s || !events.control_end_s || *end < *begin) {
    return;
  }
  const double logged_s = in_seconds(*end - *begin);
  const double rows_s = *events.control_end_s - *events.control_start_s;
  if (std::abs(logged_s - rows_s) > 0.05 + 2.0 * report::figures(rows).roll.usual_step_s) {
    refuse(folder, fmt::format("control lasts {} s in flight.csv, and {} s in flight.ftl", text::fixed(rows_s, 2),
                               text::fixed(logged_s, 2)));
  }
}

}  // namespace

void expect_rows_of_log(const flight::Flight& rows, const flight_log::LogFile& log,
                        const std::filesystem::path& folder) {
  std::error_code ignored;
  // A summary takes an outage out of the time under control, and is held against the table itself.
  if (log.flights.size() == 1 && !std::filesystem::exists(folder / "summary.json", ignored)) {
    expect_as_long(rows, log.flights.front(), folder);
  }
  const Table table = table_of(rows);
  const std::vector<Tick> ticks = logged_ticks(log);
  if (table.controlled.empty() || ticks.empty()) {
    return;
  }
  if (std::ranges::none_of(ticks, &Tick::is_control)) {
    if (flight_log::intact(log) && flight_log::has_end(log.flights.back())) {
      refuse(folder, "there is no control in flight.ftl");
    }
    return;
  }
  const Beside beside{table.controlled, ticks};
  std::optional<Difference> latest;
  const auto [from_s, to_s] = possible_begin_s(table, ticks);
  double begin_s = from_s;
  while (begin_s < to_s + beside.reach_s()) {
    const auto found = beside.difference(begin_s - table.controlled.front().time_s);
    if (!found) {
      return;
    }
    latest = latest && latest->row > found->row ? latest : found;
    begin_s += beside.reach_s();
  }
  refuse(folder, text_of(*latest, table.controlled[latest->row].time_s));
}

}  // namespace fantail::logs
