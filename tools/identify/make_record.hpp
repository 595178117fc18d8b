// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "identify/record.hpp"
#include "logs/roll_log.hpp"
#include "sim/atmosphere.hpp"

namespace fantail::identify {

/// A stretch of a log by its clock, both ends included.
struct Window {
  std::optional<double> from_s{};  ///< empty: from the first sample
  std::optional<double> to_s{};
  std::string name{};
};

/// By the log's events: "control", "thrust" and "coast" (the parts of control before and after burn-out), "step:N"
/// (from the N-th change of the reference under control, counted from 1, to the next), or "A:B" in seconds; either may
/// be left out. Throws sim::InputError: bad_configuration for a word that is none of these, bad_data when the log does
/// not say when that was.
[[nodiscard]] Window find_window(const logs::RollLog& log, const std::string& text);

/// When the motor burnt out: from the log's summary, or where the axial specific force falls below zero for good.
[[nodiscard]] std::optional<double> burnout_s(const logs::RollLog& log);

struct RecordOptions {
  /// How much later the canard column is than the gyro's: its value at t + lag belongs to t. Of either sign.
  double lag_s = 0.0;
  std::optional<double> density_kg_m3{};  ///< the same everywhere; empty: from the height by `atmosphere`
  sim::Atmosphere atmosphere{};
  std::optional<double> speed_m_s{};  ///< for a log without speeds, or instead of them
  double longest_gap_s = 0.1;         ///< samples farther apart have a gap between them (but see below)
};

/// A gap is longer than `longest_gap_s` and than five times the usual distance of the samples. Throws sim::InputError
/// (bad_data): window outside the data, fewer than three samples in it, no speed.
[[nodiscard]] Record make_record(const logs::RollLog& log, const Window& window, const RecordOptions& options);

}  // namespace fantail::identify
