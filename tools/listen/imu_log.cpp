// SPDX-License-Identifier: MIT
#include "listen/imu_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "logs/interpolator.hpp"
#include "text/error.hpp"

namespace fantail::listen {
namespace {

constexpr std::size_t fewest_samples = 10;
constexpr double most_lost_share = 0.01;

[[noreturn]] void refuse(const std::string& message) { throw text::Error{text::ErrorKind::bad_data, message}; }

struct Place {
  Quantity quantity;
  Signal ImuLog::* signal;
};
constexpr std::array places{
    Place{Quantity::axial, &ImuLog::axial},         Place{Quantity::second_axial, &ImuLog::second_axial},
    Place{Quantity::lateral_y, &ImuLog::lateral_y}, Place{Quantity::lateral_z, &ImuLog::lateral_z},
    Place{Quantity::roll_rate, &ImuLog::roll_rate}, Place{Quantity::pitch_rate, &ImuLog::pitch_rate},
    Place{Quantity::yaw_rate, &ImuLog::yaw_rate},   Place{Quantity::height, &ImuLog::height},
    Place{Quantity::speed, &ImuLog::speed},
};

// Rows that count, with their times.
struct Clock {
  std::vector<std::size_t> rows;
  std::vector<double> time_s;
};

std::size_t column_of(const flight::Table& table, const Source& source) {
  const auto found = table.find(source.column);
  if (!found || source.column.empty()) {
    refuse(fmt::format("{}: {}; say it with --columns {}=COLUMN:UNIT", table.name(),
                       flight::missing_column(source.column, table.columns()), name(source.quantity)));
  }
  return *found;
}

Clock clock_of(const flight::Table& table, const Sources& sources, std::vector<std::string>& notes) {
  const Source* const source = find(sources, Quantity::time);
  if (source == nullptr) {
    refuse(fmt::format("{}: nobody said which column is the time: --columns time=COLUMN:UNIT", table.name()));
  }
  const std::size_t column = column_of(table, *source);
  Clock clock;
  std::vector<std::size_t> lost;
  std::size_t repeated = 0;
  std::size_t first_repeated = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto number = table.number(row, column);
    if (!number) {
      lost.push_back(row);
      continue;
    }
    const double time_s = *number * source->factor;
    if (!clock.rows.empty() && time_s < clock.time_s.back()) {
      refuse(
          fmt::format("{}: the time {} in column {} is before that of {}, {}; a log of one flight has times that "
                      "increase",
                      table.where(row), table.cell(row, column), source->column, table.place(clock.rows.back()),
                      table.cell(clock.rows.back(), column)));
    }
    if (!clock.rows.empty() && time_s == clock.time_s.back()) {
      first_repeated = repeated++ == 0 ? row : first_repeated;
    }
    clock.rows.push_back(row);
    clock.time_s.push_back(time_s);
  }
  if (static_cast<double>(lost.size()) > most_lost_share * static_cast<double>(table.rows())) {
    refuse(fmt::format("{}: {} of {} rows have no number in the column {} of the time, the first in {}", table.name(),
                       lost.size(), table.rows(), source->column, table.place(lost.front())));
  }
  if (!lost.empty()) {
    notes.push_back(fmt::format("{} without a number for the time {} left out, the first in {}.",
                                lost.size() == 1 ? "One row" : fmt::format("{} rows", lost.size()),
                                lost.size() == 1 ? "is" : "are", table.place(lost.front())));
  }
  if (repeated > 0) {
    notes.push_back(
        fmt::format("{} of {} rows have the time of the row before them, the first in {}; of rows with one "
                    "time the last number of each column counts.",
                    repeated, clock.rows.size(), table.place(first_repeated)));
  }
  return clock;
}

Signal signal_of(const flight::Table& table, const Clock& clock, const Source& source,
                 std::vector<std::string>& notes) {
  const std::size_t column = column_of(table, source);
  Signal signal{.words = source.words};
  std::size_t lost = 0;
  std::size_t first_lost = 0;
  for (std::size_t i = 0; i < clock.rows.size(); ++i) {
    const auto number = table.number(clock.rows[i], column);
    if (!number) {
      first_lost = lost++ == 0 ? clock.rows[i] : first_lost;
      continue;
    }
    const double value = *number * source.factor + (source.from_rest ? one_g_m_s2 : 0.0);
    if (signal.is_there() && clock.time_s[i] == signal.time_s.back()) {
      signal.value.back() = value;
      continue;
    }
    signal.time_s.push_back(clock.time_s[i]);
    signal.value.push_back(value);
  }
  if (lost > 0 && signal.is_there()) {
    notes.push_back(fmt::format("{} of {} cells of {} are no numbers, the first in {}; they count as not sampled.",
                                lost, clock.rows.size(), source.column, table.place(first_lost)));
  }
  return signal;
}

// "roll, pitch and yaw"
std::string in_a_row(const std::vector<std::string>& words) {
  std::string row = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    row += (i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return row;
}

void note_what_is_missing(ImuLog& log) {
  const auto missing = [&](const Signal& signal) { return !signal.is_there(); };
  if (missing(log.lateral_y) || missing(log.lateral_z)) {
    log.notes.push_back(fmt::format("Specific force along {} is not in the log; it is taken as 0.",
                                    !missing(log.lateral_y)   ? "z"
                                    : !missing(log.lateral_z) ? "y"
                                                              : "y and z, the sides,"));
  }
  std::vector<std::string> rates;
  for (const auto& [what, signal] :
       {std::pair{"roll", &log.roll_rate}, std::pair{"pitch", &log.pitch_rate}, std::pair{"yaw", &log.yaw_rate}}) {
    if (missing(*signal)) {
      rates.emplace_back(what);
    }
  }
  if (!rates.empty()) {
    const bool one = rates.size() == 1;
    log.notes.push_back(
        fmt::format("The {} of {} {} not in the log; {} taken as 0{}.", one ? "rate" : "rates", in_a_row(rates),
                    one ? "is" : "are", one ? "it is" : "they are",
                    knows_tilt(log) ? "" : ", so the rocket is taken to keep the direction of its guide"));
  }
}

double longest_interval_s(const Signal& signal) {
  double longest_s = 0.0;
  for (std::size_t i = 1; i < signal.time_s.size(); ++i) {
    longest_s = std::max(longest_s, signal.time_s[i] - signal.time_s[i - 1]);
  }
  return longest_s;
}

std::string merging(const ImuLog& log) {
  double motion_s = 0.0;
  for (const Place& place : places) {
    const bool is_motion = place.quantity != Quantity::height && place.quantity != Quantity::speed;
    motion_s = std::max(motion_s, is_motion ? longest_interval_s(log.*place.signal) : 0.0);
  }
  return fmt::format(
      "Motion and height were logged apart and are merged, each sample at its own time. The largest gap is {:.4g} ms "
      "in "
      "the motion and {:.4g} ms in the height.",
      1e3 * motion_s, 1e3 * longest_interval_s(log.height));
}

void refuse_few_samples(const ImuLog& log) {
  if (log.axial.time_s.size() < fewest_samples) {
    refuse(fmt::format("{}: {} samples of the axial specific force; at least {} are needed", log.name,
                       log.axial.time_s.size(), fewest_samples));
  }
}

void refuse_unlikely_time(const ImuLog& log, const Sources& sources) {
  const Source& time = *find(sources, Quantity::time);
  const auto doubt_unit = [&](const std::string& what) {
    refuse(fmt::format("{}: {}; is the time {} really in {}?", log.name, what, time.column, time.unit));
  };
  const double long_s = log.end_s() - log.begin_s();
  const auto from_first_to_last = [&](const std::string& length, const std::string& than) {
    doubt_unit(fmt::format("from its first sample to its last it is {}, {} s", length, than));
  };
  if (long_s > longest_log_s) {
    from_first_to_last(input::about(long_s) + " s", fmt::format("longer than {}", longest_log_s));
  }
  if (long_s < shortest_log_s) {
    from_first_to_last(input::about(1e3 * long_s) + " ms", fmt::format("shorter than {}", shortest_log_s));
  }
  if (log.interval_s * fastest_log_hz < 1.0 - 1e-9) {
    doubt_unit(fmt::format("{} samples a second, faster than {}", input::about(1.0 / log.interval_s), fastest_log_hz));
  }
}

}  // namespace

ImuLog imu_log(const flight::Table& table, const Sources& sources, Clocks clocks) {
  ImuLog log{.name = table.name(), .rows = table.rows()};
  std::vector<std::string> of_rows;
  const Clock clock = clock_of(table, sources, of_rows);
  const Source* const axial = find(sources, Quantity::axial);
  if (axial == nullptr) {
    refuse(fmt::format("{}: nobody said which column is the axial specific force: --columns axial=COLUMN:UNIT",
                       table.name()));
  }
  for (const Place& place : places) {
    const Source* const source = find(sources, place.quantity);
    if (source != nullptr && (source->must_be_there || table.find(source->column))) {
      log.*place.signal = signal_of(table, clock, *source, of_rows);
    }
  }
  refuse_few_samples(log);
  log.interval_s = logs::usual_interval_s(log.axial.time_s);
  refuse_unlikely_time(log, sources);
  if (clocks == Clocks::one) {
    log.notes = of_rows;
  } else if (log.height.is_there()) {
    log.notes.push_back(merging(log));
  }
  note_what_is_missing(log);
  return log;
}

void add_barometer(ImuLog& log, const flight::Table& table, const Sources& sources) {
  std::vector<std::string> notes;
  const Clock clock = clock_of(table, sources, notes);
  for (const auto& [quantity, signal] :
       {std::pair{Quantity::height, &ImuLog::height}, std::pair{Quantity::speed, &ImuLog::speed}}) {
    if (const Source* const source = find(sources, quantity)) {
      log.*signal = signal_of(table, clock, *source, notes);
    }
  }
  for (const std::string& note : notes) {
    log.notes.push_back(fmt::format("{}: {}", table.name(), note));
  }
}

std::vector<Gap> gaps(const Signal& signal, double longest_gap_s) {
  std::vector<Gap> found;
  for (std::size_t i = 1; i < signal.time_s.size(); ++i) {
    if (signal.time_s[i] - signal.time_s[i - 1] > longest_gap_s * (1.0 + 1e-9)) {
      found.push_back({signal.time_s[i - 1], signal.time_s[i]});
    }
  }
  return found;
}

double longest_bridge_s(double interval_s, double stale_time_s) {
  constexpr double most_intervals = 10.0;
  return 2.0 * interval_s <= stale_time_s ? stale_time_s : most_intervals * interval_s;
}

}  // namespace fantail::listen
