// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fantail/log_names.hpp"
#include "logs/compare.hpp"
#include "logs/roll_log.hpp"
#include "result/document.hpp"

namespace fantail::tool {

/// Two logs, what was asked of them and what came of it.
struct CompareResults {
  std::string a;  ///< "out/flight (measured)"
  std::string b;
  LogNames names;
  std::string window;  ///< "control"; may be empty
  bool shift_found = false;
  logs::Comparison comparison{};
  std::optional<double> required_angle_rad{};
  std::optional<double> required_rate_rad_s{};
  std::vector<std::string> warnings{};
  std::vector<std::filesystem::path> logs{};  ///< both files, which no result may replace

  /// Of both logs and of their comparison.
  void take_warnings(const logs::RollLog& log_a, const logs::RollLog& log_b);
  [[nodiscard]] bool required() const { return required_angle_rad || required_rate_rad_s; }
  /// A mean over a few samples says nothing of the others.
  [[nodiscard]] bool is_known() const { return comparison.known_s >= 0.9 * comparison.asked_s - 1e-9; }
  /// Which mean difference is larger than required, or why that is not known, a sentence each; empty when the
  /// requirement is met.
  [[nodiscard]] std::vector<std::string> objections() const;
};

/// Yes: the mean differences are no larger than required; none where nothing is. With differences.csv.
[[nodiscard]] result::Document comparison(const CompareResults& results, const result::Made& made);
/// The same of two flights on A's clock: also command, canards, speed and height as far as both logs have them.
[[nodiscard]] result::Document overlay(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b,
                                       const result::Made& made);
[[nodiscard]] std::vector<result::Listed> listed_comparison();

}  // namespace fantail::tool
