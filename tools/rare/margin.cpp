// SPDX-License-Identifier: MIT
#include "rare/margin.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/flight_plan.hpp"
#include "flight/model_end.hpp"
#include "report/verdict.hpp"
#include "sim/scenario.hpp"

namespace fantail::rare {
namespace {

enum : std::size_t { hold, rest, authority, phase, tilt, mach, stability, attack, bias, second_bias };
constexpr double just_met = std::numeric_limits<double>::min();
constexpr double share_beyond = 1e-3;
/// Of the largest gyro bias: what noise in the mean of a self-test can add.
constexpr double share_of_noise = 0.05;

std::optional<double> below(double limit, const std::optional<double>& figure) {
  return figure ? std::optional{limit - *figure} : std::nullopt;
}

std::optional<double> least_phase_margin_rad(const flight::Flight& flight) {
  const auto least = std::ranges::min_element(flight.loop_margins, {}, &flight::LoopMargin::phase_margin_rad);
  return least == flight.loop_margins.end() ? std::nullopt : std::optional{least->phase_margin_rad};
}

Left left_of_held(const sim::Scenario& scenario, const campaign::FlownRun& run, const campaign::JudgedFlight& judged) {
  Left left;
  const flight::Flight& flight = judged.flight;
  left.of[hold] = below(report::held_error_rad, judged.figures.largest_hold_error_rad);
  left.of[rest] = below(flight.rest_limit_rad, judged.figures.rest_error_rad);
  left.of[authority] = judged.figures.authority_margin_rad;
  left.of[phase] = least_phase_margin_rad(flight);
  if (judged.verdict.ended_by_tilt || judged.verdict.allowed_tilt_end_s) {
    left.of[tilt] = below(flight.tilt_end_before_apogee_s, run.figures[campaign::uncontrolled_time_column]);
  }
  left.of[mach] = below(flight::model_ends_at_mach, flight.extremes.top_mach);
  left.of[stability] = flight.extremes.static_margin_calibres;
  left.of[attack] = below(flight::model_ends_at_attack_rad, flight.extremes.angle_of_attack_rad);
  const double largest_bias_rad_s = core::largest_gyro_bias_rad_s(scenario.plan.motion);
  left.of[bias] = below(largest_bias_rad_s, std::abs(scenario.vehicle.imu.rate_bias_rad_s));
  if (scenario.plan.sensors.gyros != core::GyroRule::one) {
    left.of[second_bias] = below(largest_bias_rad_s, std::abs(scenario.vehicle.second_imu.rate_bias_rad_s));
  }
  const bool is_tipped = judged.verdict.outcome == report::Outcome::no_control;
  for (const std::size_t which : {bias, second_bias}) {
    std::optional<double>& one = left.of[which];
    if (is_tipped && one && *one >= 0.0 && *one < share_of_noise * largest_bias_rad_s) {
      one = just_failed;
    }
  }
  return left;
}

}  // namespace

std::string objection_to(const campaign::Question& question) {
  return question.relation != campaign::Relation::is || question.outcome == report::name(report::Outcome::held)
             ? ""
             : "no figure tells how far a flight is from " + question.text() +
                   ", so the search has no way to go; allowed: outcome=held, or a figure with >= or <= and a number";
}

Left left_of(const campaign::Question& question, const sim::Scenario& scenario, const campaign::FlownRun& run,
             const campaign::JudgedFlight& judged) {
  if (question.relation == campaign::Relation::is) {
    return left_of_held(scenario, run, judged);
  }
  Left left;
  if (const auto& figure = run.figures[question.figure]; figure && run.outcome != "not_finite") {
    left.of.front() =
        question.relation == campaign::Relation::at_least ? *figure - question.bound : question.bound - *figure;
  }
  return left;
}

Yardstick::Yardstick(const campaign::Question& question, std::span<const Left> plain) {
  if (question.relation != campaign::Relation::is) {
    unit_.front() = 1.0;
    return;
  }
  for (std::size_t i = 0; i < unit_.size(); ++i) {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;
    for (const Left& one : plain) {
      if (one.of[i]) {
        count += 1.0;
        const double from_mean = *one.of[i] - mean;
        mean += from_mean / count;
        squares += from_mean * (*one.of[i] - mean);
      }
    }
    if (squares > 0.0) {
      unit_[i] = std::sqrt(squares / (count - 1.0));
    }
  }
}

double Yardstick::margin(const Left& left, bool is_failed) const {
  const auto which = nearest(left);
  if (!which) {
    return is_failed ? failed_by_an_event : just_met;
  }
  const double found = *left.of[*which] / *unit_[*which];
  if (is_failed) {
    return found < 0.0 ? std::min(found, just_failed) : failed_by_an_event;
  }
  return found > 0.0 ? found : just_met_at(left);
}

// Held beyond a limit that alone does not decide, as canards too small for a moment: nearer to failing than all others,
// and among those the way goes on by the rest.
double Yardstick::just_met_at(Left left) const {
  for (auto& one : left.of) {
    one = one && *one <= 0.0 ? std::nullopt : one;
  }
  const auto which = nearest(left);
  return which ? std::max(just_met, share_beyond * *left.of[*which] / *unit_[*which]) : just_met;
}

std::optional<std::size_t> Yardstick::nearest(const Left& left) const {
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < unit_.size(); ++i) {
    if (left.of[i] && unit_[i] && (!found || *left.of[i] / *unit_[i] < *left.of[*found] / *unit_[*found])) {
      found = i;
    }
  }
  return found;
}

}  // namespace fantail::rare
