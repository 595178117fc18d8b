// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "logs/compare.hpp"
#include "logs/roll_log.hpp"

namespace fantail::tool {

/// Two logs, what was asked of them and what came of it.
struct CompareResults {
  std::string a;  ///< "out/flight (measured)"
  std::string b;
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

[[nodiscard]] std::string compare_text(const CompareResults& results);
[[nodiscard]] std::string compare_json(const CompareResults& results);
[[nodiscard]] std::string compare_html(const CompareResults& results);
/// A page with two flights on A's clock: what compare_html() draws, and command, canards, speed and height as far as
/// both logs have them.
[[nodiscard]] std::string overlay_html(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b);
[[nodiscard]] std::string compare_csv(const logs::Comparison& comparison);

/// compare.html, compare.json and differences.csv, all or none, and over neither of the logs.
void write_compare_results(const CompareResults& results, const std::filesystem::path& folder);

}  // namespace fantail::tool
