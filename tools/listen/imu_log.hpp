// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "files/load.hpp"
#include "files/sources.hpp"
#include "flight/table.hpp"

namespace fantail::listen {

inline constexpr double one_g_m_s2 = 9.80665;

/// One quantity of a log over time, SI and radians, where the log has it.
struct Signal {
  std::string words{};           ///< the column as it was asked for; empty: the log does not have it
  std::vector<double> time_s{};  ///< the log's clock, strictly increasing
  std::vector<double> value{};

  [[nodiscard]] bool is_there() const { return !time_s.empty(); }
};

/// A stretch without samples that is too long to be bridged.
struct Gap {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// A log of any logger.
struct ImuLog {
  std::string name{};
  std::size_t rows = 0;
  Signal axial{};
  Signal second_axial{};
  Signal lateral_y{};
  Signal lateral_z{};
  Signal roll_rate{};
  Signal pitch_rate{};
  Signal yaw_rate{};
  Signal height{};
  Signal speed{};
  double interval_s = 0.0;           ///< the usual one of `axial`; of a log that was flown the one around lift-off
  std::string columns_from{};        ///< "columns of the map altos"; where all are the person's own, empty
  std::string doubt{};               ///< of the logger itself, a sentence; empty: none
  std::vector<std::string> notes{};  ///< a sentence each: what was left out, assumed, doubtful

  [[nodiscard]] double begin_s() const { return axial.time_s.front(); }
  [[nodiscard]] double end_s() const { return axial.time_s.back(); }
};

/// Does the log say how the rocket turns about its sides?
[[nodiscard]] inline bool knows_tilt(const ImuLog& log) { return log.pitch_rate.is_there() || log.yaw_rate.is_there(); }

/// Longest and shortest log that is flown, and the fastest: beyond them time is hardly in the unit that was stated.
inline constexpr double longest_log_s = 6.0 * 3600.0;
inline constexpr double shortest_log_s = 1.0;
inline constexpr double fastest_log_hz = 20'000.0;

/// Quantities read from a log; height and speed are for comparison, the law never receives them.
inline constexpr std::array heard_quantities{
    files::Quantity::time,      files::Quantity::axial,     files::Quantity::second_axial, files::Quantity::lateral_y,
    files::Quantity::lateral_z, files::Quantity::roll_rate, files::Quantity::pitch_rate,   files::Quantity::yaw_rate,
    files::Quantity::height,    files::Quantity::speed,
};

/// The columns of a table that `sources` name. Of rows with one time the last number of each column counts. Throws
/// text::Error (bad_data), naming file and line: as files::read_rows() does, a column that is not there, no time or
/// axial force among the sources, fewer than ten samples of the axial force, a log longer than longest_log_s, shorter
/// than shortest_log_s or faster than fastest_log_hz.
[[nodiscard]] ImuLog imu_log(const files::Loaded& file, const files::Sources& sources);

/// Height and speed of another file: a barometer's own log.
void add_barometer(ImuLog& log, const flight::Table& table, const files::Sources& sources);

/// Stretches of a signal longer than `longest_gap_s` without a sample.
[[nodiscard]] std::vector<Gap> gaps(const Signal& signal, double longest_gap_s);

/// What is bridged by a straight line: ten usual intervals, and of a log about as fast as the law's own stale time only
/// that time.
[[nodiscard]] double longest_bridge_s(double interval_s, double stale_time_s);

}  // namespace fantail::listen
