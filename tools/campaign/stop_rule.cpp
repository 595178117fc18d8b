// SPDX-License-Identifier: MIT
#include "campaign/stop_rule.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "campaign/runs_file.hpp"
#include "text/number.hpp"

namespace fantail::campaign {
namespace {

constexpr double miss = 0.05;

/// Between a share that is in and one that is out.
template <typename IsIn>
double edge(double in, double out, IsIn is_in) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (in + out);
    (is_in(middle) ? in : out) = middle;
  }
  return in;
}

}  // namespace

Bounds confidence_sequence(std::uint64_t count, std::uint64_t of) {
  const auto yes = static_cast<double>(count);
  const auto no = static_cast<double>(of - count);
  // Logarithm of the mean likelihood over all shares.
  const double mixture = std::lgamma(yes + 1.0) + std::lgamma(no + 1.0) - std::lgamma(yes + no + 2.0);
  const auto is_in = [&](double share) {
    const double likelihood = (yes > 0.0 ? yes * std::log(share) : 0.0) + (no > 0.0 ? no * std::log1p(-share) : 0.0);
    return mixture - likelihood < -std::log(miss);
  };
  const double seen = of == 0 ? 0.5 : yes / (yes + no);
  return {.low = is_in(0.0) ? 0.0 : edge(seen, 0.0, is_in), .high = is_in(1.0) ? 1.0 : edge(seen, 1.0, is_in)};
}

std::string StopRule::text() const {
  return question.text() + (within ? fmt::format(" within {}", *within) : "") +
         (required ? fmt::format(" decided at {}", *required) : "");
}

std::string StopRule::words() const {
  return question.words() + (within ? fmt::format(", known to {} % either way", text::brief(100.0 * *within, 3)) : "") +
         (required ? fmt::format(", decided at {} %", text::brief(100.0 * *required, 3)) : "");
}

bool Stopping::take(std::span<const FlownRun> runs) {
  for (const FlownRun& run : runs) {
    count_ += rule_.question.is_met_by(run) ? 1U : 0U;
  }
  of_ += runs.size();
  const auto [low, high] = bounds();
  return (rule_.within && high - low <= 2.0 * *rule_.within) ||
         (rule_.required && (low >= *rule_.required || high < *rule_.required));
}

std::size_t stops_at(const StopRule& rule, std::span<const FlownRun> runs) {
  Stopping stopping{rule};
  std::size_t taken = 0;
  while (taken < runs.size()) {
    const std::size_t count = std::min<std::size_t>(runs_of_a_part, runs.size() - taken);
    const bool enough = stopping.take(runs.subspan(taken, count));
    taken += count;
    if (enough) {
      break;
    }
  }
  return taken;
}

}  // namespace fantail::campaign
