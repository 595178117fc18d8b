// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "campaign/question.hpp"
#include "distributions/shares.hpp"

namespace fantail::campaign {

using distributions::Bounds;
using distributions::confidence_sequence;

/// When a campaign has flown enough before all its runs are flown. It is looked at after every part, in their order,
/// with bounds that hold however often one looks (confidence_sequence()): where it stops is the same with every number
/// of threads.
struct StopRule {
  Question question{};
  std::optional<double> within{};    ///< the bounds are at most so far from their middle: 0.01
  std::optional<double> required{};  ///< the bounds are all above this share, or all below it

  /// For the identity of a campaign: what is asked, and both numbers.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string words() const;  ///< for a person
};

/// Counts runs for a rule.
class Stopping {
 public:
  explicit Stopping(StopRule rule) : rule_{std::move(rule)} {}

  /// The next runs. True: these and those before are enough.
  bool take(std::span<const FlownRun> runs);
  [[nodiscard]] Bounds bounds() const { return confidence_sequence(count_, of_); }

 private:
  StopRule rule_;
  std::uint64_t count_ = 0;
  std::uint64_t of_ = 0;
};

/// After how many of these runs, which are all from the first on, a rule stops; all when it does not.
[[nodiscard]] std::size_t stops_at(const StopRule& rule, std::span<const FlownRun> runs);

}  // namespace fantail::campaign
