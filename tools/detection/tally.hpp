// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "detection/kind.hpp"
#include "detection/rehearsal.hpp"
#include "runs/row_text.hpp"

namespace fantail::detection {

/// How often each whole number came.
class Histogram {
 public:
  void add(int value, std::uint64_t times = 1) { counts_[value] += times; }
  void add(const Histogram& other);
  [[nodiscard]] std::uint64_t total() const;
  [[nodiscard]] std::uint64_t times(int value) const;
  /// The least of its numbers with at least this share of all at or below it; empty without any.
  [[nodiscard]] std::optional<int> point(double share) const;
  [[nodiscard]] const std::map<int, std::uint64_t>& counts() const { return counts_; }

  friend bool operator==(const Histogram&, const Histogram&) = default;
  friend void fields(runs::RowText& text, Histogram& histogram) { text(histogram.counts_); }

 private:
  std::map<int, std::uint64_t> counts_;
};

inline constexpr int late_ms = 300;
inline constexpr int tilted_ddeg =
    50;  ///< tenths of a degree: beyond this an attitude is wrong, and not its sensors' zeros

/// What is true of a launch.
struct LaunchTruth {
  std::size_t ignition = 0;      ///< the step
  int peak_g = 0;                ///< largest thrust over the weight, rounded down
  std::optional<int> still_s{};  ///< of a rail that was raised: since then, rounded down
};
[[nodiscard]] LaunchTruth truth_of(const Motion& motion);

/// The event that came worst, so that it can be shown again.
struct Worst {
  std::uint64_t event = 0;
  /// Of events the largest nearness, of launches the longest latency in ms; a launch that was missed has `missed`.
  double value = -1.0;
  static constexpr double missed = 1e6;

  friend bool operator==(const Worst&, const Worst&) = default;
};

/// What one rule made of the events of one kind whose accelerometers were in one condition.
struct Count {
  std::uint64_t events = 0;
  std::uint64_t detected = 0;     ///< detected a launch
  std::uint64_t controlling = 0;  ///< the canards could move
  Worst worst{};

  // Of flights that come down.
  std::uint64_t flown = 0;  ///< controlled as they should be, and in none of the other figures
  Histogram control_by_part{};

  // Of launches.
  std::uint64_t inside_guide = 0;  ///< control began while the rocket was truly in the guide
  Histogram latency_ms{};          ///< from the first crossing of the threshold by the thrust to the detection
  Histogram control_ms{};          ///< from ignition to control start
  Histogram error_cm{};            ///< estimated less true distance along the guide at control start
  Histogram distance_cm{};         ///< the true one
  Histogram all_by_peak_g{};       ///< by the largest thrust over the weight, rounded down
  Histogram missed_by_peak_g{};
  Histogram late_by_peak_g{};   ///< detected more than `late_ms` after the crossing
  Histogram tilt_error_ddeg{};  ///< estimated less true tilt at detection, without sign, in tenths of a degree
  // Of rails that were raised, by the whole seconds between that and ignition.
  Histogram all_by_still_s{};
  Histogram missed_by_still_s{};
  Histogram tilted_by_still_s{};  ///< detected with a tilt that is off by more than `tilted_ddeg`

  friend bool operator==(const Count&, const Count&) = default;
};

inline void fields(runs::RowText& text, Worst& worst) { text(worst.event, worst.value); }
inline void fields(runs::RowText& text, Count& count) {
  text(count.events, count.detected, count.controlling, count.worst, count.flown, count.control_by_part,
       count.inside_guide, count.latency_ms, count.control_ms, count.error_cm, count.distance_cm, count.all_by_peak_g,
       count.missed_by_peak_g, count.late_by_peak_g, count.tilt_error_ddeg, count.all_by_still_s,
       count.missed_by_still_s, count.tilted_by_still_s);
}

/// Of events that follow each other, of one kind: a count for each rule and condition.
struct Tally {
  explicit Tally(std::size_t rules) : of_rule(rules) {}
  std::vector<std::array<Count, conditions>> of_rule;

  void count(Kind kind, std::uint64_t event, const std::vector<Rule>& rules, const std::vector<Answer>& answers,
             const LaunchTruth& truth);
  void add(const Tally& later);

  friend bool operator==(const Tally&, const Tally&) = default;
};
inline void fields(runs::RowText& text, Tally& tally) { text(tally.of_rule); }

}  // namespace fantail::detection
