// SPDX-License-Identifier: MIT
#include "detection/tally.hpp"

#include <cmath>

#include "detection/shapes.hpp"
#include "sim/units.hpp"

namespace fantail::detection {
namespace {

void keep_worst(Worst& worst, std::uint64_t event, double value) {
  if (value > worst.value || (value == worst.value && event < worst.event)) {
    worst = {.event = event, .value = value};
  }
}

int whole(double value) { return static_cast<int>(std::lround(value)); }

void count_launch(Count& count, std::uint64_t event, const Answer& answer, const LaunchTruth& truth, float guide_m) {
  const auto crossing = answer.crossing.value_or(truth.ignition);
  count.all_by_peak_g.add(truth.peak_g);
  if (truth.still_s) {
    count.all_by_still_s.add(*truth.still_s);
  }
  if (answer.detected) {
    const auto latency = static_cast<int>(*answer.detected) - static_cast<int>(crossing);
    count.latency_ms.add(latency);
    if (latency > late_ms) {
      count.late_by_peak_g.add(truth.peak_g);
    }
    keep_worst(count.worst, event, answer.controlling ? static_cast<double>(latency) : Worst::missed);
    const int tilt_error = whole(std::abs(static_cast<double>(answer.tilt_error_rad)) * 10.0 / sim::radians_per_degree);
    count.tilt_error_ddeg.add(tilt_error);
    if (truth.still_s && tilt_error > tilted_ddeg) {
      count.tilted_by_still_s.add(*truth.still_s);
    }
  } else {
    count.missed_by_peak_g.add(truth.peak_g);
    if (truth.still_s) {
      count.missed_by_still_s.add(*truth.still_s);
    }
    keep_worst(count.worst, event, Worst::missed);
  }
  if (answer.controlling) {
    count.control_ms.add(static_cast<int>(*answer.controlling) - static_cast<int>(truth.ignition));
    count.error_cm.add(whole(100.0 * static_cast<double>(answer.distance_error_m)));
    count.distance_cm.add(whole(100.0 * static_cast<double>(answer.distance_m)));
    count.inside_guide += answer.distance_m < guide_m ? 1 : 0;
  }
}

}  // namespace

void Histogram::add(const Histogram& other) {
  for (const auto& [value, times] : other.counts_) {
    add(value, times);
  }
}

std::uint64_t Histogram::total() const {
  std::uint64_t sum = 0;
  for (const auto& [value, times] : counts_) {
    sum += times;
  }
  return sum;
}

std::uint64_t Histogram::times(int value) const {
  const auto found = counts_.find(value);
  return found == counts_.end() ? 0 : found->second;
}

std::optional<int> Histogram::point(double share) const {
  const double wanted = share * static_cast<double>(total());
  std::uint64_t sum = 0;
  for (const auto& [value, times] : counts_) {
    sum += times;
    if (static_cast<double>(sum) >= wanted) {
      return value;
    }
  }
  return std::nullopt;
}

LaunchTruth truth_of(const Motion& motion) {
  LaunchTruth truth{.ignition = motion.ignition,
                    .peak_g = static_cast<int>(motion.peak_thrust_m_s2 / sim::gravity_m_s2)};
  if (motion.still_from > 0) {
    truth.still_s = static_cast<int>(step_s * static_cast<double>(motion.ignition - motion.still_from));
  }
  return truth;
}

void Tally::count(Kind kind, std::uint64_t event, const std::vector<Rule>& rules, const std::vector<Answer>& answers,
                  const LaunchTruth& truth) {
  for (std::size_t rule = 0; rule < answers.size(); ++rule) {
    const Answer& answer = answers[rule];
    Count& count = of_rule[rule][static_cast<std::size_t>(condition_of(kind, event))];
    if (answer.flown) {
      ++count.flown;
      continue;
    }
    ++count.events;
    count.detected += answer.detected ? 1 : 0;
    count.controlling += answer.controlling ? 1 : 0;
    if (is_launch(kind)) {
      count_launch(count, event, answer, truth, rules[rule].plan.guide.length_m);
    } else {
      keep_worst(count.worst, event, static_cast<double>(answer.nearness));
      if (is_flight(kind) && answer.controlling) {
        count.control_by_part.add(static_cast<int>(answer.part));
      }
    }
  }
}

void Tally::add(const Tally& later) {
  for (std::size_t rule = 0; rule < of_rule.size(); ++rule) {
    for (std::size_t condition = 0; condition < conditions; ++condition) {
      Count& sum = of_rule[rule][condition];
      const Count& more = later.of_rule[rule][condition];
      sum.events += more.events;
      sum.detected += more.detected;
      sum.controlling += more.controlling;
      sum.flown += more.flown;
      sum.control_by_part.add(more.control_by_part);
      sum.inside_guide += more.inside_guide;
      if (more.events > 0) {
        keep_worst(sum.worst, more.worst.event, more.worst.value);
      }
      sum.latency_ms.add(more.latency_ms);
      sum.control_ms.add(more.control_ms);
      sum.error_cm.add(more.error_cm);
      sum.distance_cm.add(more.distance_cm);
      sum.all_by_peak_g.add(more.all_by_peak_g);
      sum.missed_by_peak_g.add(more.missed_by_peak_g);
      sum.late_by_peak_g.add(more.late_by_peak_g);
      sum.tilt_error_ddeg.add(more.tilt_error_ddeg);
      sum.all_by_still_s.add(more.all_by_still_s);
      sum.missed_by_still_s.add(more.missed_by_still_s);
      sum.tilted_by_still_s.add(more.tilted_by_still_s);
    }
  }
}

}  // namespace fantail::detection
