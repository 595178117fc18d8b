// SPDX-License-Identifier: MIT
#include "campaign/stop_rule.hpp"

#include <algorithm>

#include <fmt/core.h>

#include "campaign/runs_file.hpp"
#include "text/number.hpp"

namespace fantail::campaign {

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
