// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "airframe/controlled_ascent.hpp"
#include "airframe/new_rocket.hpp"
#include "sim/scenario.hpp"
#include "sim/units.hpp"
#include "stability/margins_asked.hpp"
#include "stability/roll_loop.hpp"
#include "stability/schedule.hpp"
#include "stability/speed_range.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

/// At every corner of the ranges. With more there the roll would settle far from its reference.
constexpr double phase_margin_rad = stability::least_phase_margin_rad;
constexpr int speeds = 12;

/// Over the computed model alone, with a degree for the speeds of a flight in wind.
constexpr double computed_phase_margin_rad = stability::comfortable_phase_margin_rad + text::radians(1.0);
constexpr double slower_in_wind = 0.93;

/// A schedule is one more thing that can be wrong, so it has to make the slowest return to the reference this much
/// faster.
constexpr double worth_a_schedule = 1.5;

/// The largest that leaves the margin is taken: it ends an offset soonest.
constexpr std::array observer_bandwidths_rad_s{10.0, 7.0, 5.0, 3.0, 2.0, 1.0, 0.5};

/// Farther from its reference the fins may not keep the roll without an observer.
const double rest_limit_rad = text::radians(2.0);

using Speeds = stability::SpeedRange;

/// Of every corner of the ranges. Canards that lose their torque to the fins turn the rocket less and, without an
/// observer, swing less: half of the computed torque stands for all that is below it.
stability::LoopsAtSpeeds loops(const sim::Vehicle& vehicle, const model::BuildUp& computed,
                               const core::FlightPlan& plan, const ControlledAscent& ascent) {
  const model::Estimate& damping = computed.roll_damping_m4;
  const double torque_m3 = computed.roll_torque_m3->value;
  std::vector inertias_kg_m2{vehicle.roll_plant.inertia_kg_m2};
  if (computed.after_burnout) {
    inertias_kg_m2.push_back(computed.after_burnout->roll_inertia_kg_m2);
  }
  sim::Scenario scenario;
  scenario.plan = plan;
  scenario.vehicle = vehicle;
  sim::RollPlant& plant = scenario.vehicle.roll_plant;
  stability::LoopsAtSpeeds all;
  for (const double speed_m_s : stability::speeds_between(plan, ascent.range, speeds - 1)) {
    std::vector<stability::RollLoop> at_speed;
    for (const double inertia_kg_m2 : inertias_kg_m2) {
      plant.inertia_kg_m2 = inertia_kg_m2;
      for (const double air : {1.0, ascent.thinner(speed_m_s)}) {
        for (const double damping_m4 : {damping.low, damping.value, damping.high}) {
          for (const double torque : {0.5 * torque_m3, torque_m3, computed.roll_torque_m3->high}) {
            plant.damping_m2 = air * damping_m4 / plant.reference_area_m2;
            plant.torque_m = air * torque / plant.reference_area_m2;
            at_speed.push_back(stability::loop_at_speed(scenario, speed_m_s));
          }
        }
      }
    }
    all.push_back(std::move(at_speed));
  }
  return all;
}

/// Of the vehicle as it was computed, alone.
stability::LoopsAtSpeeds computed_loops(const sim::Vehicle& vehicle, const core::FlightPlan& plan,
                                        const ControlledAscent& ascent) {
  const Speeds& range = ascent.range;
  sim::Scenario scenario;
  scenario.plan = plan;
  scenario.vehicle = vehicle;
  stability::LoopsAtSpeeds all;
  for (const double speed_m_s : {slower_in_wind * range.lowest_m_s, range.lowest_m_s,
                                 0.5 * (range.lowest_m_s + range.highest_m_s), range.highest_m_s}) {
    std::vector<stability::RollLoop> at_speed;
    for (const double air : {1.0, ascent.thinner(speed_m_s)}) {
      scenario.vehicle.roll_plant.damping_m2 = air * vehicle.roll_plant.damping_m2;
      scenario.vehicle.roll_plant.torque_m = air * vehicle.roll_plant.torque_m;
      at_speed.push_back(stability::loop_at_speed(scenario, speed_m_s));
    }
    all.push_back(std::move(at_speed));
  }
  return all;
}

/// Nearest to those of the plan: with the margin over all ranges, and with more than that where some gains have it.
std::optional<stability::Gains> gains_for(const sim::Vehicle& vehicle, const model::BuildUp& computed,
                                          const core::FlightPlan& plan, const ControlledAscent& ascent) {
  const stability::LoopsAtSpeeds all = loops(vehicle, computed, plan, ascent);
  const stability::LoopsAtSpeeds as_computed = computed_loops(vehicle, plan, ascent);
  std::optional<stability::Gains> least;
  for (const double more_deg : {0.0, 5.0, 10.0, 15.0}) {
    const auto found = stability::nearest_gains(all, gains_of(plan), stability::largest_gains(),
                                                {.phase_margin_rad = phase_margin_rad + text::radians(more_deg)});
    if (found && stability::meets(as_computed, *found, {.phase_margin_rad = computed_phase_margin_rad})) {
      return found;
    }
    least = least ? least : found;
  }
  return least;
}

/// What the shape gives, for most of a flight: the motor has burnt out.
core::RollModelPlan roll_model(const sim::Vehicle& vehicle, const model::BuildUp& computed) {
  const sim::RollPlant& plant = vehicle.roll_plant;
  const double inertia_kg_m2 =
      computed.after_burnout ? computed.after_burnout->roll_inertia_kg_m2 : plant.inertia_kg_m2;
  return {.roll_inertia_kg_m2 = static_cast<float>(inertia_kg_m2),
          .reference_area_m2 = static_cast<float>(plant.reference_area_m2),
          .damping_m2 = static_cast<float>(plant.damping_m2),
          .torque_m = static_cast<float>(plant.torque_m),
          .density_kg_m3 = static_cast<float>(sim::Scenario{}.atmosphere.density_kg_m3(0.0))};
}

double rest_rad(double fin_offset_rad, const stability::Gains& gains) {
  return std::abs(fin_offset_rad) / gains.proportional;
}

/// The fastest observer with which any gains have the margin. Unlike integral action it needs no schedule: its model
/// says how much stronger the canards are in faster air.
void add_observer(FirstGains& first, const sim::Vehicle& vehicle, const model::BuildUp& computed, core::FlightPlan plan,
                  const ControlledAscent& ascent, double fin_offset_rad) {
  plan.offset.rejection = core::OffsetRejection::observer;
  plan.roll_model = roll_model(vehicle, computed);
  for (const double bandwidth_rad_s : observer_bandwidths_rad_s) {
    plan.offset.observer_bandwidth_rad_s = static_cast<float>(bandwidth_rad_s);
    const auto found = gains_for(vehicle, computed, plan, ascent);
    if (found) {
      first.gains = *found;
      first.rest_rad = rest_rad(fin_offset_rad, *found);
      first.observer_bandwidth_rad_s = bandwidth_rad_s;
      first.roll_model = plan.roll_model;
      return;
    }
  }
}

/// How fast the roll comes back to its reference, where that is slowest: kp b / (a + kd b), of the slower of the loop's
/// two poles, which an observer leaves where it is.
double slowest_return_per_s(const sim::Vehicle& vehicle, core::FlightPlan plan, const FirstGains& first,
                            const Speeds& range) {
  sim::Scenario scenario;
  scenario.vehicle = vehicle;
  scenario.plan = std::move(plan);
  double slowest_per_s = std::numeric_limits<double>::infinity();
  for (const double speed_m_s : stability::speeds_between(scenario.plan, range, speeds - 1)) {
    const stability::RollLoop loop = stability::loop_at_speed(scenario, speed_m_s);
    const double stronger_per_s2 = loop.gain_factor * loop.authority_per_s2;
    slowest_per_s = std::min(slowest_per_s, first.gains.proportional * stronger_per_s2 /
                                                (loop.damping_rate_per_s + first.gains.derivative_s * stronger_per_s2));
  }
  return slowest_per_s;
}

bool rests_near(const FirstGains& first) {
  return first.observer_bandwidth_rad_s.has_value() || first.rest_rad <= rest_limit_rad;
}

/// With the schedule of the plan, or without one.
FirstGains scheduled(const sim::Vehicle& vehicle, const model::BuildUp& computed, const core::FlightPlan& plan,
                     const ControlledAscent& ascent, double fin_offset_rad) {
  const auto found = gains_for(vehicle, computed, plan, ascent);
  FirstGains first{.gains = found.value_or(gains_of(plan)),
                   .schedule = plan.gain_schedule,
                   .reach_phase_margin = found.has_value(),
                   .begin_speed_m_s = ascent.begin_m_s,
                   .lowest_speed_m_s = ascent.range.lowest_m_s,
                   .highest_speed_m_s = ascent.range.highest_m_s,
                   .servo_lag_s = vehicle.servo.lag_s};
  first.rest_rad = rest_rad(fin_offset_rad, first.gains);
  const auto reach_rad = static_cast<double>(plan.controller.canard_limit.radians());
  if (found && first.rest_rad > rest_limit_rad && std::abs(fin_offset_rad) < reach_rad) {
    add_observer(first, vehicle, computed, plan, ascent, fin_offset_rad);
  }
  return first;
}

}  // namespace

stability::Gains gains_of(const core::FlightPlan& plan) {
  return {.proportional = static_cast<double>(plan.controller.proportional_gain),
          .derivative_s = static_cast<double>(plan.controller.derivative_gain_s)};
}

std::optional<FirstGains> first_gains(const sim::Vehicle& vehicle, const model::BuildUp& computed,
                                      const core::FlightPlan& plan, double fin_offset_rad) {
  const auto ascent = controlled_ascent(vehicle, plan);
  if (!ascent || !computed.roll_torque_m3) {
    return std::nullopt;
  }
  const Speeds& range = ascent->range;
  FirstGains best = scheduled(vehicle, computed, plan, *ascent, fin_offset_rad);
  double best_per_s = best.reach_phase_margin ? slowest_return_per_s(vehicle, plan, best, range) : 0.0;
  for (const double exponent : stability::schedule_exponents) {
    if (!stability::has_room_for_schedule(range) || !stability::is_within_plan(exponent, range)) {
      continue;
    }
    core::FlightPlan with_schedule = plan;
    with_schedule.gain_schedule = stability::gain_schedule(exponent, range);
    const FirstGains other = scheduled(vehicle, computed, with_schedule, *ascent, fin_offset_rad);
    const double per_s = slowest_return_per_s(vehicle, with_schedule, other, range);
    if (other.reach_phase_margin && (rests_near(other) || !rests_near(best)) && per_s > worth_a_schedule * best_per_s) {
      best = other;
      best_per_s = per_s;
    }
  }
  return best;
}

std::string why_none(const core::FlightPlan& plan) {
  using text::brief;
  return fmt::format(
      "No gains were chosen: in a straight ascent, control does not begin. It needs {} g for {} s, and {} m/s {} m "
      "from the foot of the guide.",
      brief(static_cast<double>(plan.launch_detection.threshold_m_s2) / sim::gravity_m_s2, 2),
      brief(static_cast<double>(core::seconds(plan.launch_detection.hold)), 2),
      brief(static_cast<double>(plan.guide.minimum_speed_m_s), 1),
      brief(static_cast<double>(plan.guide.length_m + plan.guide.clearance_m), 1));
}

std::string sentence(const FirstGains& first) {
  using text::brief;
  const std::size_t rows = first.schedule.speeds_count;
  const std::string schedule =
      rows == 0 ? std::string{}
                : fmt::format(", times {} at {} m/s and falling to 1 at {} m/s",
                              brief(static_cast<double>(first.schedule.factors.front()), 3),
                              text::fixed(first.lowest_speed_m_s, 0), text::fixed(first.highest_speed_m_s, 0));
  const std::string gains =
      fmt::format("{} and {} s{}{}", brief(first.gains.proportional, 4), brief(first.gains.derivative_s, 4), schedule,
                  first.observer_bandwidth_rad_s
                      ? fmt::format(", with an observer of {} rad/s", brief(*first.observer_bandwidth_rad_s, 4))
                      : "");
  const std::string why_observer = first.observer_bandwidth_rad_s
                                       ? fmt::format(
                                             " Without the observer the fin offset would, with these gains, keep the "
                                             "roll {}{} deg from its reference.",
                                             rows == 0 ? "" : "up to ", text::fixed(text::degrees(first.rest_rad), 0))
                                       : "";
  const std::string where = fmt::format(
      "from {} to {} m/s up to apogee. Damping and torque may be anywhere within a factor of two, with a servo lag of "
      "{} "
      "ms",
      text::fixed(first.lowest_speed_m_s, 0), text::fixed(first.highest_speed_m_s, 0),
      brief(1e3 * first.servo_lag_s, 1));
  return first.reach_phase_margin
             ? fmt::format("Gains of {}. In the loop model their phase margin is {} degrees or more {}.{}", gains,
                           brief(text::degrees(phase_margin_rad), 0), where, why_observer)
             : fmt::format(
                   "Gains of {}, the usual ones: no gains of a plan have a phase margin of {} degrees in the loop "
                   "model {}. Measure damping and torque in a tunnel.",
                   gains, brief(text::degrees(phase_margin_rad), 0), where);
}

}  // namespace fantail::airframe
