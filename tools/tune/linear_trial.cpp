// SPDX-License-Identifier: MIT
#include "tune/linear_trial.hpp"

#include <algorithm>
#include <utility>

#include "core/gain_schedule.hpp"
#include "tune/flights.hpp"

namespace fantail::tune {
namespace {

using stability::RollLoop;

constexpr double least_gain_margin = 2.0;

RollLoop with(RollLoop loop, const Law& law) {
  loop.proportional_gain = law.gains.proportional;
  loop.derivative_gain_s = law.gains.derivative_s;
  loop.integral_gain_per_s = law.integral_gain_per_s;
  loop.observer.bandwidth_rad_s = law.observer_bandwidth_rad_s;
  return loop;
}

}  // namespace

LinearTrial::LinearTrial(const sim::Scenario& scenario, const SpeedsFlown& speeds, const Request& request)
    : scenario_{scenario}, speeds_{speeds}, request_{request}, airframes_{corners(scenario, request.spread)} {
  set_exponent(0.0);
}

void LinearTrial::set_exponent(double exponent) {
  // Any gains: each law brings its own.
  const Law any{.gains = {.proportional = 1.0, .derivative_s = 0.1},
                .integral_gain_per_s = 1.0,
                .observer_bandwidth_rad_s = 1.0,
                .schedule_exponent = exponent};
  const core::FlightPlan plan = with_law(scenario_, request_.rejection, any, speeds_.range);
  constexpr int steps = 16;
  std::vector<double> speeds_m_s = stability::speeds_between(plan, speeds_.range, steps);
  speeds_m_s.push_back(speeds_.median_m_s);
  std::ranges::sort(speeds_m_s);
  exponent_ = exponent;
  all_.clear();
  for (const double speed_m_s : speeds_m_s) {
    LoopsAtSpeed at{.speed_m_s = speed_m_s, .loops = {}};
    for (sim::Scenario& airframe : airframes_) {
      airframe.plan = plan;
      at.loops.push_back(stability::loop_at_speed(airframe, speed_m_s));
    }
    all_.push_back(std::move(at));
  }
  double sum = 0.0;
  for (const double speed_m_s : speeds_.evenly_in_time_m_s) {
    sum += 1.0 / static_cast<double>(core::gain_factor(plan.gain_schedule, static_cast<float>(speed_m_s), false));
  }
  mean_factor_ = static_cast<double>(speeds_.evenly_in_time_m_s.size()) / sum;
}

bool LinearTrial::fails_at(const LoopsAtSpeed& at, const Law& law) const {
  return std::ranges::any_of(at.loops, [&](const RollLoop& loop) {
    const auto found = stability::phase_margin_rad(with(loop, law));
    return found && *found < request_.phase_margin_rad;
  });
}

bool LinearTrial::has_phase_margin(const Law& law) {
  // Where the last law failed the next one is likely to.
  failed_at_ = std::min(failed_at_, all_.size() - 1);
  if (fails_at(all_[failed_at_], law)) {
    return false;
  }
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (fails_at(all_[i], law)) {
      failed_at_ = i;
      return false;
    }
  }
  return true;
}

bool LinearTrial::has_gain_margin(const Law& law) const {
  for (const LoopsAtSpeed* at : {&all_.front(), &median(), &all_.back()}) {
    for (const RollLoop& loop : at->loops) {
      const auto found = stability::margins(with(loop, law));
      if (found && found->gain_margin && std::max(*found->gain_margin, 1.0 / *found->gain_margin) < least_gain_margin) {
        return false;
      }
    }
  }
  return true;
}

std::optional<double> LinearTrial::settling_s(const Law& law, double longest_s) {
  double slowest_s = 0.0;
  const LoopsAtSpeed& fastest = all_.back();
  for (const LoopsAtSpeed* at : {&median(), &fastest}) {
    for (std::size_t i = 0; i < at->loops.size(); ++i) {
      // The airframe that was too slow with the last law is likely to be the one again.
      const std::size_t airframe = (slow_airframe_ + i) % at->loops.size();
      const auto found_s = tune::settling_s(with(at->loops[airframe], law), longest_s);
      if (!found_s) {
        slow_airframe_ = airframe;
        return std::nullopt;
      }
      slowest_s = std::max(slowest_s, *found_s);
    }
  }
  return slowest_s;
}

stability::MarginAtSpeed LinearTrial::least_margin(const Law& law) const {
  stability::MarginAtSpeed least{.speed_m_s = all_.front().speed_m_s, .phase_margin_rad = 10.0};
  for (const LoopsAtSpeed& at : all_) {
    for (const RollLoop& loop : at.loops) {
      const auto found = stability::phase_margin_rad(with(loop, law));
      if (found && *found < least.phase_margin_rad) {
        least = {.speed_m_s = at.speed_m_s, .phase_margin_rad = *found};
      }
    }
  }
  return least;
}

const LinearTrial::LoopsAtSpeed& LinearTrial::median() const {
  return *std::ranges::find_if(all_, [&](const auto& at) { return at.speed_m_s >= speeds_.median_m_s; });
}

}  // namespace fantail::tune
