// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "logs/roll_log.hpp"

namespace fantail::logs {

struct CompareOptions {
  std::optional<double> from_s{};  ///< on A's clock, both ends included; empty: all that both have
  std::optional<double> to_s{};
  /// What B's clock shows at A's zero: B's value at t + shift belongs to A's t.
  double shift_s = 0.0;
  bool find_shift = false;     ///< take the shift that makes the roll rates agree best instead
  double most_shift_s = 2.0;   ///< how far it is looked for, to both sides
  bool remove_offset = false;  ///< roll angles count from different zeros: they agree at the first sample compared
  double longest_gap_s = 0.1;  ///< between samples of B farther apart nothing is known
};

struct Difference {
  double mean_abs = 0.0;
  double rms = 0.0;
  double max_abs = 0.0;
  double max_at_s = 0.0;  ///< A's clock
};

/// At the samples of A inside the window at which B is known too.
struct Comparison {
  /// Of the window, where one is given; else from the first to the last sample that is compared.
  double asked_s = 0.0;
  double known_s = 0.0;        ///< of that, without the holes of either log
  std::vector<double> time_s;  ///< A's clock
  std::vector<double> a_angle_rad;
  std::vector<double> b_angle_rad;           ///< with the offset
  std::vector<double> angle_difference_rad;  ///< A minus B
  std::vector<double> a_rate_rad_s;
  std::vector<double> b_rate_rad_s;
  std::vector<double> rate_difference_rad_s;
  Difference angle{};  ///< rad
  Difference rate{};   ///< rad/s
  double shift_s = 0.0;
  double offset_rad = 0.0;              ///< added to B's angles
  std::vector<std::string> warnings{};  ///< a sentence each
};

/// B runs straight between two of its samples. Both logs need roll angle and rate. Throws text::Error:
/// bad_configuration for a window that ends before it begins; bad_data when no sample of A in the window lies inside B,
/// or when a shift is to be found and no motion tells one from another.
[[nodiscard]] Comparison compare(const RollLog& a, const RollLog& b, const CompareOptions& options);

}  // namespace fantail::logs
