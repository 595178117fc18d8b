// SPDX-License-Identifier: MIT
#include "stability/gain_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "stability/speed_range.hpp"

namespace fantail::stability {
namespace {

/// Below these a gain does nothing that a flight would show, and a factor from zero on has no meaning.
constexpr Gains smallest{.proportional = 0.01, .derivative_s = 0.001};

std::vector<double> candidates(double present, double from, double to) {
  std::vector<double> all = round_numbers_between(from, to);
  all.insert(all.begin(), present);
  return all;
}

double ratio(double value, double present, double small) { return std::log((value + small) / (present + small)); }

RollLoop with_gains(RollLoop loop, const Gains& gains) {
  loop.proportional_gain = gains.proportional;
  loop.derivative_gain_s = gains.derivative_s;
  return loop;
}

bool meets_at_speed(const std::vector<RollLoop>& loops, const Gains& gains, const PhaseMarginDemand& demand) {
  // As many as lie below the point that a share of the airframes is above.
  const auto allowed =
      static_cast<std::size_t>(std::floor((1.0 - demand.share) * static_cast<double>(loops.size() - 1)));
  std::size_t below = 0;
  for (const RollLoop& loop : loops) {
    const auto found = phase_margin_rad(with_gains(loop, gains));
    below += found && *found < demand.phase_margin_rad ? 1 : 0;
    if (below > allowed) {
      return false;
    }
  }
  return true;
}

}  // namespace

Gains largest_gains() {
  return {.proportional = plan_range("controller", "proportional_gain").maximum,
          .derivative_s = plan_range("controller", "derivative_gain_s").maximum};
}

bool meets(const LoopsAtSpeeds& loops, const Gains& gains, const PhaseMarginDemand& demand) {
  return std::ranges::all_of(loops, [&](const auto& at_speed) { return meets_at_speed(at_speed, gains, demand); });
}

std::optional<Gains> nearest_gains(const LoopsAtSpeeds& loops, const Gains& present, const Gains& largest,
                                   const PhaseMarginDemand& demand, Search search) {
  struct Candidate {
    double distance;
    Gains gains;
  };
  const std::vector<double> proportional =
      present.proportional == 0.0 || search == Search::derivative_gain
          ? std::vector{present.proportional}
          : candidates(present.proportional, smallest.proportional, largest.proportional);
  std::vector<Candidate> all;
  for (const double kp : proportional) {
    for (const double kd : candidates(present.derivative_s, smallest.derivative_s, largest.derivative_s)) {
      all.push_back({std::hypot(ratio(kp, present.proportional, smallest.proportional),
                                ratio(kd, present.derivative_s, smallest.derivative_s)),
                     {kp, kd}});
    }
  }
  std::ranges::stable_sort(all, {}, &Candidate::distance);
  // The speed at which the last pair failed is likely to be where the next one does.
  std::size_t failed_at = 0;
  for (const Candidate& candidate : all) {
    const auto fails = [&](std::size_t speed) { return !meets_at_speed(loops[speed], candidate.gains, demand); };
    bool failed = !loops.empty() && fails(failed_at);
    for (std::size_t speed = 0; !failed && speed < loops.size(); ++speed) {
      if (fails(speed)) {
        failed = true;
        failed_at = speed;
      }
    }
    if (!failed) {
      return candidate.gains;
    }
  }
  return std::nullopt;
}

std::optional<double> longest_servo_lag_s(const LoopsAtSpeeds& loops, const Gains& gains, double shortest_s,
                                          const PhaseMarginDemand& demand) {
  constexpr double step_s = 1e-4;
  const auto with_lag = [&loops](double lag_s) {
    LoopsAtSpeeds changed = loops;
    for (auto& at_speed : changed) {
      std::ranges::for_each(at_speed, [lag_s](RollLoop& loop) { loop.servo_lag_s = lag_s; });
    }
    return changed;
  };
  const auto reaches = [&](double lag_s) { return meets(with_lag(lag_s), gains, demand); };
  if (loops.empty() || !reaches(shortest_s)) {
    return std::nullopt;
  }
  // More lag is less phase at a lower crossover, and so less margin in every loop that turns faster than it is damped;
  // what is answered was tried in any case.
  double good_s = shortest_s;
  double bad_s = loops.front().front().servo_lag_s;
  while (bad_s - good_s > step_s) {
    const double middle_s = 0.5 * (good_s + bad_s);
    (reaches(middle_s) ? good_s : bad_s) = middle_s;
  }
  const double round_s = std::floor(good_s / step_s) * step_s;
  return round_s >= shortest_s && reaches(round_s) ? round_s : good_s;
}

std::vector<double> round_numbers_between(double from, double to) {
  constexpr std::array numbers{1.0, 1.1, 1.2, 1.3, 1.5, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0,
                               3.3, 3.6, 3.9, 4.3, 4.7, 5.1, 5.6, 6.2, 6.8, 7.5, 8.2, 9.1};
  std::vector<double> all;
  // Through whole exponents and a division: 0.43 is then the number that a person types.
  for (int exponent = static_cast<int>(std::floor(std::log10(from))); std::pow(10.0, exponent) <= to; ++exponent) {
    for (const double number : numbers) {
      const double value = exponent < 0 ? number / std::pow(10.0, -exponent) : number * std::pow(10.0, exponent);
      if (value >= from && value <= to) {
        all.push_back(value);
      }
    }
  }
  return all;
}

}  // namespace fantail::stability
