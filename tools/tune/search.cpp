// SPDX-License-Identifier: MIT
#include "tune/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "stability/gain_choice.hpp"
#include "stability/speed_range.hpp"
#include "tune/linear_trial.hpp"

namespace fantail::tune {
namespace {

using core::OffsetRejection;

constexpr double least_proportional_gain = 0.02;
constexpr double least_derivative_gain_s = 0.001;
constexpr double least_integral_gain_per_s = 0.01;
constexpr double least_observer_bandwidth_rad_s = 0.1;

double most_integral_gain_per_s() { return stability::plan_range("offset", "integral_gain_per_s").maximum; }
double most_observer_bandwidth_rad_s() { return stability::plan_range("offset", "observer_bandwidth_rad_s").maximum; }

/// One number beside kp and kd, and how fast the law rejects an offset with it.
struct Rejection {
  std::vector<double> values{};
  double Law::* member = nullptr;
  bool times_proportional = false;
};

Rejection numbers_of(OffsetRejection rejection) {
  switch (rejection) {
    case OffsetRejection::integral:
      return {.values = stability::round_numbers_between(least_integral_gain_per_s, most_integral_gain_per_s()),
              .member = &Law::integral_gain_per_s};
    case OffsetRejection::observer:
      return {
          .values = stability::round_numbers_between(least_observer_bandwidth_rad_s, most_observer_bandwidth_rad_s()),
          .member = &Law::observer_bandwidth_rad_s,
          .times_proportional = true};
    case OffsetRejection::none: break;
  }
  return {};
}

/// The fastest law of each group, and what stood in the way of the others.
class Search {
 public:
  Search(LinearTrial& trial, const Request& request)
      : trial_{trial}, settling_s_{request.settling_s}, rejection_{numbers_of(request.rejection)} {}

  void try_gains(const stability::Gains& gains) {
    const int third_of_decade = static_cast<int>(std::floor(3.0 * std::log10(gains.proportional)));
    Fastest& group = groups_[{trial_.exponent(), third_of_decade}];
    const double per_value = trial_.mean_factor() * (rejection_.times_proportional ? gains.proportional : 1.0);
    if (rejection_.member == nullptr) {
      const Law law{.gains = gains, .schedule_exponent = trial_.exponent()};
      if (gains.proportional * per_value > group.speed && has_phase_margin(law)) {
        consider(group, law, gains.proportional * per_value);
      }
      return;
    }
    const auto law_with = [&](std::size_t i) {
      Law law{.gains = gains, .schedule_exponent = trial_.exponent()};
      law.*rejection_.member = rejection_.values[i];
      return law;
    };
    // Only what would be faster than the group's fastest; of that, the largest with the phase margin: more of it has
    // less.
    const auto& values = rejection_.values;
    std::size_t good = 0;
    while (good < values.size() && values[good] * per_value <= group.speed) {
      ++good;
    }
    if (good == values.size() || !has_phase_margin(law_with(good))) {
      return;
    }
    const std::size_t first = good;
    std::size_t bad = values.size();
    while (bad - good > 1) {
      const std::size_t middle = (good + bad) / 2;
      (has_phase_margin(law_with(middle)) ? good : bad) = middle;
    }
    // The most of it may settle too slowly, where a little less settles in time.
    constexpr std::size_t steps_down = 8;
    for (std::size_t i = good + 1; i > first && good + 1 - i < steps_down; --i) {
      if (consider(group, law_with(i - 1), values[i - 1] * per_value)) {
        return;
      }
    }
  }

  [[nodiscard]] Found found() && {
    constexpr double many_times = 8.0;
    std::vector<Fastest> all;
    for (const auto& [key, group] : groups_) {
      if (group.speed > 0.0) {
        all.push_back(group);
      }
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, &Fastest::speed);
    for (const Fastest& group : all) {
      if (group.speed * many_times > all.front().speed) {
        found_.laws.push_back(group.law);
      }
    }
    return std::move(found_);
  }

 private:
  struct Fastest {
    double speed = 0.0;
    Law law{};
  };

  bool has_phase_margin(const Law& law) {
    const bool has = trial_.has_phase_margin(law);
    found_.phase_margin_is_there = found_.phase_margin_is_there || has;
    return has;
  }

  /// Keeps a law with the phase margin if it has the gain margin, too, and settles in time.
  bool consider(Fastest& group, const Law& law, double speed) {
    const auto takes_s = trial_.settling_s(law, is_found_ ? settling_s_ : 3.0 * settling_s_);
    if ((is_found_ && !takes_s) || !trial_.has_gain_margin(law)) {
      return false;
    }
    found_.gain_margin_is_there = true;
    if (takes_s && !is_found_) {
      found_.shortest_settling_s = std::min(found_.shortest_settling_s.value_or(*takes_s), *takes_s);
    }
    if (!takes_s || *takes_s > settling_s_) {
      return false;
    }
    is_found_ = true;
    group = {.speed = speed, .law = law};
    return true;
  }

  LinearTrial& trial_;
  double settling_s_;
  Rejection rejection_;
  std::map<std::pair<double, int>, Fastest> groups_;
  Found found_{};
  bool is_found_ = false;
};

std::string tried(OffsetRejection rejection, const stability::Gains& largest) {
  std::string text = fmt::format("kp from {} to {}, kd from {} to {} s", least_proportional_gain, largest.proportional,
                                 least_derivative_gain_s, largest.derivative_s);
  if (rejection == OffsetRejection::integral) {
    text += fmt::format(", ki from {} to {} 1/s", least_integral_gain_per_s, most_integral_gain_per_s());
  } else if (rejection == OffsetRejection::observer) {
    text +=
        fmt::format(", bandwidth from {} to {} rad/s", least_observer_bandwidth_rad_s, most_observer_bandwidth_rad_s());
  }
  return text;
}

/// A few numbers in a decade are near enough to say how far it would go.
stability::MarginAtSpeed most_margin(LinearTrial& trial, const Request& request,
                                     const std::vector<double>& proportional, const std::vector<double>& derivative,
                                     const std::function<void()>& look) {
  const Rejection least = numbers_of(request.rejection);
  stability::MarginAtSpeed most{.speed_m_s = 0.0, .phase_margin_rad = -10.0};
  trial.set_exponent(0.0);
  for (std::size_t i = 0; i < proportional.size(); i += 4) {
    look();
    for (std::size_t j = 0; j < derivative.size(); j += 4) {
      Law law{.gains = {.proportional = proportional[i], .derivative_s = derivative[j]}};
      if (least.member != nullptr) {
        law.*least.member = least.values.front();
      }
      const stability::MarginAtSpeed at = trial.least_margin(law);
      most = at.phase_margin_rad > most.phase_margin_rad ? at : most;
    }
  }
  return most;
}

}  // namespace

Found search(const sim::Scenario& scenario, const SpeedsFlown& speeds, const Request& request,
             const std::function<void()>& look) {
  const stability::Gains largest = stability::largest_gains();
  const std::vector<double> proportional =
      stability::round_numbers_between(least_proportional_gain, largest.proportional);
  const std::vector<double> derivative =
      stability::round_numbers_between(least_derivative_gain_s, largest.derivative_s);
  LinearTrial trial{scenario, speeds, request};
  Search search{trial, request};
  // Beside another number every second kp is near enough; alone it is what counts.
  const std::size_t step = request.rejection == OffsetRejection::none ? 1 : 2;
  const auto over_gains = [&] {
    for (std::size_t i = 0; i < proportional.size(); i += step) {
      look();
      for (const double kd : derivative) {
        search.try_gains({.proportional = proportional[i], .derivative_s = kd});
      }
    }
  };
  over_gains();
  for (const double exponent : stability::schedule_exponents) {
    if (request.schedule && stability::has_room_for_schedule(speeds.range) &&
        stability::is_within_plan(exponent, speeds.range)) {
      trial.set_exponent(exponent);
      over_gains();
    }
  }
  Found found = std::move(search).found();
  found.tried = tried(request.rejection, largest);
  if (!found.phase_margin_is_there) {
    found.most = most_margin(trial, request, proportional, derivative, look);
  }
  return found;
}

}  // namespace fantail::tune
