// SPDX-License-Identifier: MIT
#include "tune/bound.hpp"

#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "stability/gain_choice.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tune/linear_trial.hpp"

namespace fantail::tune {
namespace {

using text::brief;

struct Number {
  std::string_view name;
  std::string_view unit;
  double* value;
  double most;
};

Number number_of(core::OffsetRejection rejection, Law& law) {
  switch (rejection) {
    case core::OffsetRejection::integral:
      return {"an integral gain", " 1/s", &law.integral_gain_per_s,
              stability::plan_range("offset", "integral_gain_per_s").maximum};
    case core::OffsetRejection::observer:
      return {"an observer's bandwidth", " rad/s", &law.observer_bandwidth_rad_s,
              stability::plan_range("offset", "observer_bandwidth_rad_s").maximum};
    case core::OffsetRejection::none: break;
  }
  return {"a kp", "", &law.gains.proportional, stability::largest_gains().proportional};
}

/// Its neighbour among the numbers that the search tries.
std::optional<double> next_larger(double value, double most) {
  for (const double one : stability::round_numbers_between(value, most)) {
    if (one > 1.01 * value) {
      return one;
    }
  }
  return {};
}

std::string missed(LinearTrial& trial, const Request& request, double reserve_rad, const Law& law) {
  if (const auto least = trial.least_margin(law); least.phase_margin_rad < request.phase_margin_rad + reserve_rad) {
    return fmt::format("the phase margin at {} m/s would be {} degrees, and {} are required, {} of them in reserve",
                       text::fixed(least.speed_m_s, 0),
                       text::fixed(std::floor(10.0 * text::degrees(least.phase_margin_rad)) / 10.0, 1),
                       brief(text::degrees(request.phase_margin_rad + reserve_rad), 1),
                       brief(text::degrees(reserve_rad), 1));
  }
  if (!trial.has_gain_margin(law)) {
    return "the gain margin would be below two";
  }
  return trial.settling_s(law, request.settling_s)
             ? std::string{}
             : fmt::format("the loop would take longer than {} s to settle", brief(request.settling_s, 2));
}

}  // namespace

std::string bound_sentence(const sim::Scenario& scenario, const SpeedsFlown& speeds, const Request& request,
                           double reserve_rad, const Law& law) {
  Law more = law;
  const Number number = number_of(request.rejection, more);
  const auto larger = next_larger(*number.value, number.most);
  if (!larger) {
    return "It is bound by the range that a plan allows.";
  }
  const double now = *number.value;
  *number.value = *larger;
  LinearTrial trial{scenario, speeds, request};
  trial.set_exponent(law.schedule_exponent);
  const std::string why = missed(trial, request, reserve_rad, more);
  const std::string with =
      fmt::format("With {} of {}{} (now {})", number.name, brief(*larger, 3), number.unit, brief(now, 3));
  return why.empty() ? fmt::format(
                           "{}, every demand on the loop would be met, too: it is bound by its flights, in which "
                           "it came nearest to the reference.",
                           with)
                     : fmt::format("{}, {}: that binds it.", with, why);
}

}  // namespace fantail::tune
