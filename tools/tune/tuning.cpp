// SPDX-License-Identifier: MIT
#include "tune/tuning.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "fly/fly_scenario.hpp"
#include "predict/margins.hpp"
#include "sim/canard_aerodynamics.hpp"
#include "stability/canard_sense.hpp"
#include "stability/margins_asked.hpp"
#include "stability/roll_loop.hpp"
#include "text/degrees.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "tune/alternatives.hpp"
#include "tune/bound.hpp"
#include "tune/flights.hpp"
#include "tune/linear_trial.hpp"
#include "tune/results.hpp"

namespace fantail::tune {
namespace {

using text::brief;
using text::degrees;
using text::fixed;

/// What the search's coarse grid of speeds may miss.
constexpr double reserve_rad = text::radians(0.3);

constexpr double required_margin_rad = stability::least_phase_margin_rad;

std::vector<LoopAtSpeed> loop_over_speed(const sim::Scenario& scenario, const SpeedsFlown& speeds, double spread) {
  constexpr int steps = 80;
  const std::vector<sim::Scenario> airframes = corners_and_middles(scenario, spread);
  std::vector<LoopAtSpeed> all;
  for (const double speed_m_s : stability::speeds_between(scenario.plan, speeds.range, steps)) {
    LoopAtSpeed at{.speed_m_s = speed_m_s,
                   .least_phase_margin_rad = std::numbers::pi,
                   .open = stability::loop_at_speed(scenario, speed_m_s)};
    for (const sim::Scenario& airframe : airframes) {
      const auto margin_rad = stability::phase_margin_rad(stability::loop_at_speed(airframe, speed_m_s));
      at.least_phase_margin_rad = std::min(at.least_phase_margin_rad, margin_rad.value_or(std::numbers::pi));
    }
    if (const auto found = stability::margins(at.open)) {
      at.crossover_rad_s = found->crossover_rad_s;
    }
    all.push_back(at);
  }
  return all;
}

std::optional<double> slowest_settling_s(const sim::Scenario& scenario, const SpeedsFlown& speeds, double spread) {
  constexpr double longest_s = 10.0;
  double slowest_s = 0.0;
  for (const sim::Scenario& airframe : corners_and_middles(scenario, spread)) {
    for (const double speed_m_s : {speeds.median_m_s, speeds.range.highest_m_s}) {
      const auto found_s = settling_s(stability::loop_at_speed(airframe, speed_m_s), longest_s);
      if (!found_s) {
        return std::nullopt;
      }
      slowest_s = std::max(slowest_s, *found_s);
    }
  }
  return slowest_s;
}

Judged judged(sim::Scenario scenario, const core::FlightPlan& plan, const SpeedsFlown& speeds, double spread) {
  scenario.plan = plan;
  Judged all{.plan = plan,
             .loop = loop_over_speed(scenario, speeds, spread),
             .settling_s = slowest_settling_s(scenario, speeds, spread)};
  const auto least = std::ranges::min_element(all.loop, {}, &LoopAtSpeed::least_phase_margin_rad);
  all.least = {.speed_m_s = least->speed_m_s, .phase_margin_rad = least->least_phase_margin_rad};
  scenario.plan.excitation.form = core::ExcitationForm::none;
  all.flight = fly::fly_scenario(scenario);
  all.noise_rad = command_noise_rad(all.flight);
  return all;
}

double largest_offset_rad(const sim::Scenario& scenario) {
  double largest = 0.0;
  for (const sim::DisturbanceNode& node : scenario.disturbance) {
    largest = std::abs(node.angle_rad) > std::abs(largest) ? node.angle_rad : largest;
  }
  return largest;
}

void say_why_beyond_limit(Tuning& t) {
  t.why_none = fmt::format(
      "The fin offset of up to {} degrees is beyond the {}. While it is, the canards stay at their "
      "limit with any law. A wider limit (--set controller.canard_limit_deg=DEG) or straighter fins could.",
      brief(degrees(t.largest_offset_rad), 1), t.limit);
}

/// Never rounded up to what was asked for.
std::string floored(double value) { return fixed(std::floor(10.0 * value) / 10.0, 1); }

void say_why_not_found(Tuning& t, const Found& found) {
  const std::string asked = fmt::format("a phase margin of {} degrees at every speed from {} to {} m/s",
                                        brief(degrees(t.request.phase_margin_rad), 1),
                                        fixed(t.speeds.range.lowest_m_s, 0), fixed(t.speeds.range.highest_m_s, 0));
  const char* const law = t.request.rejection == core::OffsetRejection::integral   ? "law with integral action"
                          : t.request.rejection == core::OffsetRejection::observer ? "law with an observer"
                                                                                   : "law without offset rejection";
  const std::string given = fmt::format("Damping and torque were within a factor of {}, the servo lag was {} ms",
                                        brief(t.request.spread, 2), brief(1e3 * t.servo_lag_s, 1));
  if (!found.phase_margin_is_there) {
    t.why_none = fmt::format(
        "No tried {} has {}. {}. The largest margin found, at the worst speed of {} m/s, is {} degrees{}. "
        "Tried: {}.",
        law, asked, given, fixed(found.most.speed_m_s, 0), floored(degrees(found.most.phase_margin_rad)),
        t.request.schedule ? ", without a schedule" : "", found.tried);
  } else if (!found.gain_margin_is_there) {
    t.why_none =
        fmt::format("No tried {} has both {} and a gain margin of two. {}. Tried: {}.", law, asked, given, found.tried);
  } else {
    t.why_none = fmt::format(
        "No tried {} with {} settles fast enough. Required: {} s after a step of the reference, at the median speed of "
        "{} m/s and above; {}. {}. Tried: {}.",
        law, asked, brief(t.request.settling_s, 2), fixed(t.speeds.median_m_s, 0),
        found.shortest_settling_s ? fmt::format("the shortest time found is {} s",
                                                fixed(std::ceil(100.0 * *found.shortest_settling_s) / 100.0, 2))
                                  : fmt::format("none settles in {} s", brief(3.0 * t.request.settling_s, 2)),
        given, found.tried);
  }
}

SpeedsFlown speeds_of(const sim::Scenario& scenario) {
  std::vector<double> speeds_m_s = fly::speeds_under_control_m_s(scenario);
  if (speeds_m_s.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name + ": control never begins, so there is no loop to be tuned"};
  }
  return speeds_flown(std::move(speeds_m_s));
}

bool has_margin(sim::Scenario scenario, const core::FlightPlan& plan, const Tuning& t) {
  scenario.plan = plan;
  return std::ranges::all_of(loop_over_speed(scenario, t.speeds, t.request.spread), [&](const LoopAtSpeed& at) {
    return at.least_phase_margin_rad >= t.request.phase_margin_rad;
  });
}

/// The whole degrees, or tenths of a second, that the search found a law for.
std::optional<Request> within_reach(const Request& asked, const Found& found) {
  constexpr double longest_settling_s = 10.0;  // --settling allows it
  Request lowered = asked;
  if (!found.phase_margin_is_there) {
    lowered.phase_margin_rad = text::radians(std::floor(degrees(found.most.phase_margin_rad - reserve_rad)));
    return lowered.phase_margin_rad >= required_margin_rad - 1e-9 ? std::optional{lowered} : std::nullopt;
  }
  if (found.gain_margin_is_there && found.shortest_settling_s) {
    lowered.settling_s = 0.1 * std::ceil(10.0 * *found.shortest_settling_s);
    return lowered.settling_s <= longest_settling_s ? std::optional{lowered} : std::nullopt;
  }
  return std::nullopt;
}

/// Of the laws that the linear loop tolerates, that which flies best, with a few rockets that are none of the later
/// ones: it holds most of them, and is nearest to its reference.
std::optional<Law> best_law(Tuning& t, const sim::Scenario& scenario, const Look& look) {
  constexpr std::size_t rockets = 6;
  constexpr std::uint64_t other_rockets = 0x66696e616c;
  Request reserved = t.request;
  reserved.phase_margin_rad += reserve_rad;
  const Found found = search(scenario, t.speeds, reserved, [&look] { look(Stage::searching, 0); });
  Request few = t.request;
  few.flights = rockets;
  sim::Scenario other = scenario;
  other.seed ^= other_rockets;
  std::vector<Law> laws;
  std::vector<core::FlightPlan> plans;
  for (const Law& law : found.laws) {
    if (const auto plan = with_law(scenario, t.request.rejection, law, t.speeds.range); has_margin(scenario, plan, t)) {
      laws.push_back(law);
      plans.push_back(plan);
    }
  }
  const std::vector<Sum> flown = fly_each(other, plans, few, [&look](std::size_t) { look(Stage::choosing, 0); });
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    const bool is_better = !best || flown[i].steady > flown[*best].steady ||
                           (flown[i].steady == flown[*best].steady && flown[i].mean_rad &&
                            (!flown[*best].mean_rad || *flown[i].mean_rad < *flown[*best].mean_rad));
    best = is_better ? i : best;
  }
  if (found.laws.empty()) {
    say_why_not_found(t, found);
    t.within_reach = within_reach(t.request, found);
    if (const std::string left_out = t.request.schedule ? schedules_left_out(t.speeds.range) : ""; !left_out.empty()) {
      t.why_none += " " + left_out;
    }
  } else if (!best) {
    t.why_none = fmt::format(
        "All laws that were found miss the phase margin of {} degrees between the speeds of "
        "the search.",
        brief(degrees(t.request.phase_margin_rad), 1));
  }
  return best ? std::optional{laws[*best]} : std::nullopt;
}

/// Everything that is known without a new law.
Tuning begun(const sim::Scenario& scenario, const Request& request) {
  Tuning t{.scenario = scenario.name,
           .vehicle = scenario.vehicle.name,
           .request = request,
           .speeds = speeds_of(scenario),
           .servo_lag_s = scenario.vehicle.servo.lag_s,
           .delay_s = stability::loop_delay_s(scenario.vehicle),
           .rest_limit_rad = scenario.rest_limit_rad,
           .largest_offset_rad = largest_offset_rad(scenario),
           .is_measured = scenario.tunnel_result.has_value()};
  const predict::CanardReach reach = predict::canard_reach(scenario, t.largest_offset_rad);
  t.reach_rad = reach.angle_rad;
  t.limit = reach.text();
  t.before = judged(scenario, scenario.plan, t.speeds, request.spread);
  return t;
}

void search_and_fly(Tuning& t, const sim::Scenario& scenario, const Look& look) {
  if (const auto law = best_law(t, scenario, look)) {
    const core::FlightPlan plan = with_law(scenario, t.request.rejection, *law, t.speeds.range);
    t.after = judged(scenario, plan, t.speeds, t.request.spread);
    t.bound_by = bound_sentence(scenario, t.speeds, t.request, reserve_rad, *law);
    t.pairs = fly_pairs(scenario, plan, t.request, [&look](std::size_t done) { look(Stage::flying, done); });
  }
}

}  // namespace

bool Tuning::is_proposed() const {
  const Sum old_plan = flown_before();
  const Sum new_plan = flown_after();
  return after && new_plan.steady > 0 && new_plan.steady >= old_plan.steady && new_plan.held >= old_plan.held;
}

bool Tuning::is_old_enough() const {
  return !after && old_alone && old_alone->flights > 0 && old_alone->held == old_alone->flights && before.settling_s &&
         before.least.phase_margin_rad >= std::min(request.phase_margin_rad, required_margin_rad) &&
         std::abs(largest_offset_rad) < reach_rad;
}

flight::Extremes Tuning::extremes() const {
  return flight::worst_of(
      {before.flight.extremes, flown_before().extremes, flown_after().extremes, old_alone.value_or(Sum{}).extremes});
}

bool Tuning::is_better() const {
  if (!is_proposed()) {
    return false;
  }
  const Sum old_plan = flown_before();
  const Sum new_plan = flown_after();
  return old_plan.mean_rad && new_plan.mean_rad && *new_plan.mean_rad < 0.98 * *old_plan.mean_rad;
}

Tuning tune(const sim::Scenario& scenario, const Request& request, const Look& look) {
  if (scenario.surroundings == sim::Surroundings::gimbal) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      scenario.name +
                          ": environment.surroundings is \"gimbal\", where no air turns the rocket; "
                          "allowed: \"flight\" or \"tunnel\""};
  }
  if (const std::string why = stability::why_uncontrollable(scenario); !why.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("{}: {}, so no gains can be tuned", scenario.name, why)};
  }
  Tuning t = begun(scenario, request);
  if (std::abs(t.largest_offset_rad) >= t.reach_rad) {
    say_why_beyond_limit(t);
    return t;
  }
  search_and_fly(t, scenario, look);
  const auto search_again = [&](Tuning& other) { search_and_fly(other, scenario, look); };
  if (!t.is_better()) {
    try_other_kinds(t, scenario, search_again);
  }
  if (!t.after && t.alternative.empty()) {
    try_lower_demands(t, search_again);
  }
  if (!t.after) {
    t.old_alone =
        fly_each(scenario, {scenario.plan}, t.request, [&look](std::size_t) { look(Stage::choosing, 0); }).at(0);
  }
  return t;
}

}  // namespace fantail::tune
