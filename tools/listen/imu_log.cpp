// SPDX-License-Identifier: MIT
#include "listen/imu_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "files/rows.hpp"
#include "input/messages.hpp"
#include "logs/interpolator.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::listen {
namespace {

using files::Quantity;
using files::Sources;

constexpr std::size_t fewest_samples = 10;

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

void require(const flight::Table& table, const Sources& sources, Quantity quantity, const char* what) {
  if (files::find(sources, quantity) == nullptr) {
    text::refuse(fmt::format("{}: the column of the {} is missing; name it with --columns {}=COLUMN:UNIT", table.name(),
                             what, files::known(quantity).name));
  }
}

// The signals that are asked for and named, each with the samples that it has.
void read_signals(ImuLog& log, const flight::Table& table, const Sources& sources, std::span<const Place> asked,
                  std::vector<std::string>& notes) {
  require(table, sources, Quantity::time, "time");
  std::vector<files::Found> columns{files::find_column(table, sources, Quantity::time, "--columns")};
  columns.front().needed = true;
  std::vector<std::pair<const Place*, const files::Source*>> read;
  for (const Place& place : asked) {
    const files::Source* const source = files::find(sources, place.quantity);
    if (source != nullptr && (source->must_be_there || table.find(source->column))) {
      columns.push_back(files::find_column(table, sources, place.quantity, "--columns"));
      read.emplace_back(&place, source);
    }
  }
  const files::Rows rows = files::read_rows(table, columns, {.same_time = files::SameTime::last_of_a_cell});
  notes.insert(notes.end(), rows.notes.begin(), rows.notes.end());
  for (std::size_t i = 0; i < read.size(); ++i) {
    Signal& signal = log.*read[i].first->signal;
    signal = {.words = read[i].second->words};
    for (std::size_t row = 0; row < rows.rows.size(); ++row) {
      if (const double value = rows.values[i + 1][row]; !std::isnan(value)) {
        signal.time_s.push_back(rows.values[0][row]);
        signal.value.push_back(value);
      }
    }
    const files::Rows::Lost& lost = rows.lost[i + 1];
    if (lost.empty + lost.words > 0 && signal.is_there()) {
      notes.push_back(fmt::format("{} of {} cells of {} are not numbers, the first in {}; they count as not sampled.",
                                  lost.empty + lost.words, rows.read, read[i].second->column,
                                  table.place(lost.first_row)));
    }
  }
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
    log.notes.push_back(fmt::format("Specific force along {} is not in the log; it is assumed to be 0.",
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
        fmt::format("The {} of {} {} not in the log; {} assumed to be 0{}.", one ? "rate" : "rates", in_a_row(rates),
                    one ? "is" : "are", one ? "it is" : "they are",
                    knows_tilt(log) ? "" : ", so the rocket is assumed to keep the direction of its guide"));
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
      "Motion and height were logged separately and are merged, each sample at its own time. The largest gap is "
      "{:.4g} ms in the motion and {:.4g} ms in the height.",
      1e3 * motion_s, 1e3 * longest_interval_s(log.height));
}

void refuse_few_samples(const ImuLog& log) {
  if (log.axial.time_s.size() < fewest_samples) {
    text::refuse(fmt::format("{}: {} of the axial specific force; at least {} are needed", log.name,
                             text::counted(log.axial.time_s.size(), "sample"), fewest_samples));
  }
}

void refuse_unlikely_time(const ImuLog& log, const Sources& sources) {
  const files::Source& time = *files::find(sources, Quantity::time);
  const auto doubt_unit = [&](const std::string& what) {
    text::refuse(fmt::format("{}: {}; check that the time {} is in {}", log.name, what, time.column,
                             time.unit == nullptr ? "s" : time.unit->name));
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

ImuLog imu_log(const files::Loaded& file, const Sources& sources) {
  ImuLog log{.name = file.table.name(), .rows = file.table.rows()};
  std::vector<std::string> of_rows;
  require(file.table, sources, Quantity::axial, "axial specific force");
  read_signals(log, file.table, sources, places, of_rows);
  refuse_few_samples(log);
  log.interval_s = logs::usual_interval_s(log.axial.time_s);
  refuse_unlikely_time(log, sources);
  if (!file.several_clocks) {
    log.notes = of_rows;
  } else if (log.height.is_there()) {
    log.notes.push_back(merging(log));
  }
  note_what_is_missing(log);
  return log;
}

void add_barometer(ImuLog& log, const flight::Table& table, const Sources& sources) {
  std::vector<std::string> notes;
  read_signals(log, table, sources, std::span{places}.last(2), notes);
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
