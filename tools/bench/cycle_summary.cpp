// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/core.h>

#include "bench/cycle.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

constexpr std::size_t most_parts = 10;

std::vector<const Lap*> measured_laps(const Cycle& cycle) {
  std::vector<const Lap*> all;
  for (const Lap& lap : cycle.laps) {
    if (lap.measured()) {
      all.push_back(&lap);
    }
  }
  return all;
}

using Values = std::vector<double>;

double mean(const Values& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double root_mean_square(const Values& values) {
  double squares = 0.0;
  for (const double value : values) {
    squares += value * value;
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double largest(const Values& values) { return *std::ranges::max_element(values); }
double lowest(const Values& values) { return *std::ranges::min_element(values); }

Course course(const Cycle& cycle, const std::function<std::optional<double>(const Lap&)>& value,
              double (*of_tenth)(const Values&), double (*of_all)(const Values&)) {
  const std::vector<const Lap*> laps = measured_laps(cycle);
  const auto over = [&](std::size_t begin, std::size_t end, double (*summary)(const Values&)) {
    Values known;
    for (std::size_t i = begin; i < end; ++i) {
      if (const auto one = value(*laps[i])) {
        known.push_back(*one);
      }
    }
    return known.empty() ? std::nullopt : std::optional{summary(known)};
  };
  Course result;
  if (laps.empty()) {
    return result;
  }
  result.first = value(*laps.front());
  result.last = value(*laps.back());
  result.worst = over(0, laps.size(), of_all);
  const std::size_t parts = std::min(most_parts, laps.size());
  for (std::size_t part = 0; part < parts; ++part) {
    result.tenths.push_back(over(part * laps.size() / parts, (part + 1) * laps.size() / parts, of_tenth));
  }
  return result;
}

std::string laps_text(std::size_t number) { return number == 1 ? "1 lap" : fmt::format("{} laps", number); }

}  // namespace

Course lag_course(const Cycle& cycle, std::size_t canard) {
  return course(cycle, [canard](const Lap& lap) { return lap.canards[canard].lag_s; }, mean, largest);
}

Course tracking_rms_course(const Cycle& cycle, std::size_t canard) {
  return course(
      cycle, [canard](const Lap& lap) { return lap.canards[canard].tracking_rms_rad; }, root_mean_square, largest);
}

Course tracking_error_course(const Cycle& cycle, std::size_t canard) {
  return course(cycle, [canard](const Lap& lap) { return lap.canards[canard].tracking_error_rad; }, largest, largest);
}

Course battery_course(const Cycle& cycle) {
  return course(cycle, [](const Lap& lap) { return lap.battery_v; }, lowest, lowest);
}

bool knows_battery(const Cycle& cycle) {
  return std::ranges::any_of(cycle.laps, [](const Lap& lap) { return lap.battery_v.has_value(); });
}

Judgement judgement(const Cycle& cycle) {
  const std::vector<const Lap*> laps = measured_laps(cycle);
  if (laps.empty()) {
    return Judgement::none;
  }
  const bool all_well = std::ranges::all_of(laps, [](const Lap* lap) { return lap->passed; });
  return all_well ? Judgement::pass : Judgement::fail;
}

std::vector<std::string> conclusions(const Cycle& cycle) {
  const std::vector<const Lap*> laps = measured_laps(cycle);
  std::vector<std::string> all;
  const auto bad = std::ranges::find_if(laps, [](const Lap* lap) { return !lap->passed; });
  if (laps.empty()) {
    all.emplace_back("No lap was measured, so the canards are not judged.");
  } else if (bad == laps.end()) {
    all.push_back(fmt::format("All four canards stayed within their tolerances in {} of {} s each.",
                              laps_text(laps.size()), text::fixed(cycle.lap_s, 1)));
  } else {
    const auto failed = std::ranges::count_if(laps, [](const Lap* lap) { return !lap->passed; });
    all.push_back(fmt::format("{} of {} failed, the first one {} s after the start:", failed, laps_text(laps.size()),
                              text::fixed((*bad)->begin_s, 0)));
    all.insert(all.end(), (*bad)->conclusions.begin(), (*bad)->conclusions.end());
  }
  if (const std::size_t left_out = cycle.laps.size() - laps.size(); left_out > 0) {
    all.push_back(
        fmt::format("{} could not be measured and {} left out.", laps_text(left_out), left_out == 1 ? "is" : "are"));
  }
  if (!cycle.ended_because.empty()) {
    all.push_back(fmt::format("It ended after {} of {}: {}.", cycle.laps.size(), laps_text(cycle.planned_laps),
                              cycle.ended_because));
  }
  if (!laps.empty() && !knows_battery(cycle)) {
    all.emplace_back("The avionics does not report a battery voltage, so none is shown.");
  }
  return all;
}

}  // namespace fantail::bench
