// SPDX-License-Identifier: MIT
#include "rare/margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/flight_plan.hpp"
#include "flight/model_end.hpp"
#include "report/verdict.hpp"
#include "sim/scenario.hpp"

namespace fantail::rare {
namespace {

constexpr double just_met = std::numeric_limits<double>::min();

double smallest_of_held(const sim::Scenario& scenario, const campaign::JudgedFlight& judged) {
  double smallest = 1.0;
  const auto take = [&smallest](const std::optional<double>& figure, double limit) {
    if (figure && limit > 0.0) {
      smallest = std::min(smallest, 1.0 - *figure / limit);
    }
  };
  take(judged.figures.largest_hold_error_rad, report::held_error_rad);
  take(judged.figures.rest_error_rad, judged.flight.rest_limit_rad);
  take(judged.flight.extremes.top_mach, flight::model_ends_at_mach);
  const double largest_bias_rad_s = core::largest_gyro_bias_rad_s(scenario.plan.motion);
  take(std::abs(scenario.vehicle.imu.rate_bias_rad_s), largest_bias_rad_s);
  if (scenario.plan.sensors.gyros != core::GyroRule::one) {
    take(std::abs(scenario.vehicle.second_imu.rate_bias_rad_s), largest_bias_rad_s);
  }
  return smallest;
}

}  // namespace

std::string objection_to(const campaign::Question& question) {
  return question.relation != campaign::Relation::is || question.outcome == report::name(report::Outcome::held)
             ? ""
             : "no figure tells how far a flight is from " + question.text() +
                   ", so the search has no way to go; allowed: outcome=held, or a figure with >= or <= and a number";
}

double margin(const campaign::Question& question, const sim::Scenario& scenario, const campaign::FlownRun& run,
              const campaign::JudgedFlight& judged) {
  double found = failed_by_an_event;
  if (question.relation == campaign::Relation::is) {
    found = smallest_of_held(scenario, judged);
  } else if (const auto& figure = run.figures[question.figure]; figure && run.outcome != "not_finite") {
    found = question.relation == campaign::Relation::at_least ? *figure - question.bound : question.bound - *figure;
  }
  if (question.is_failed_by(run)) {
    return found < 0.0 ? found : failed_by_an_event;
  }
  return std::max(found, just_met);
}

}  // namespace fantail::rare
