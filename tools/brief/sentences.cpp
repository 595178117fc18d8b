// SPDX-License-Identifier: MIT
#include "brief/sentences.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "flight/model_end.hpp"
#include "text/bearing.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::brief {
namespace {

using text::degrees;
using text::fixed;

double seconds(core::Microseconds time) { return 1e-6 * static_cast<double>(time.count()); }

std::string at(const Moment& moment) {
  return fmt::format("{} s, {} m, {} m/s over ground", fixed(moment.time_s, 2), fixed(moment.height_m, 0),
                     fixed(moment.speed_m_s, 0));
}

std::string beyond_guide(const core::GuidePlan& guide) {
  std::string all = fmt::format("{} m beyond the guide", text::brief(static_cast<double>(guide.clearance_m), 1));
  if (guide.minimum_speed_m_s > 0.0F) {
    all += fmt::format(" and faster than {} m/s", text::brief(static_cast<double>(guide.minimum_speed_m_s), 1));
  }
  return all;
}

bool waits_for_burn_out(core::DormantUntil until) {
  return until == core::DormantUntil::burn_out || until == core::DormantUntil::burn_out_and_height;
}
bool waits_for_pressure(core::DormantUntil until) {
  return until == core::DormantUntil::max_dynamic_pressure ||
         until == core::DormantUntil::max_dynamic_pressure_and_height;
}
bool waits_for_height(core::DormantUntil until) {
  return until == core::DormantUntil::height || until == core::DormantUntil::burn_out_and_height ||
         until == core::DormantUntil::max_dynamic_pressure_and_height;
}

std::string gate_conditions(const core::DormancyPlan& plan) {
  std::string all;
  const auto add = [&all](const std::string& condition) { all += (all.empty() ? "" : ", and ") + condition; };
  if (waits_for_burn_out(plan.until)) {
    add(fmt::format("burn-out is detected (axial force below 0.15 g for 0.1 s, at least {} s after first thrust)",
                    text::brief(static_cast<double>(plan.burn_clock_factor) * seconds(plan.burn_time), 2)));
  }
  if (waits_for_pressure(plan.until)) {
    add("the estimated dynamic pressure is 2 % below its maximum");
  }
  if (waits_for_height(plan.until)) {
    add(fmt::format("the estimated height, less its error, is above {} m",
                    text::brief(static_cast<double>(plan.height_m), 1)));
  }
  return all;
}

std::string opening(const Brief& of) {
  const NominalFlight& flight = of.nominal;
  if (flight.control_start) {
    return fmt::format("Simulated: control begins at {}{}.", at(*flight.control_start),
                       flight.burns_at_control_start ? "; the motor still burns" : "");
  }
  return fmt::format("Simulated: {}, and the canards are commanded to trim throughout.",
                     !flight.was_armed    ? "the avionics are never armed"
                     : flight.was_dormant ? "the gate never opens"
                                          : "control never begins");
}

std::string fall_sentence(const Landing& landing) {
  return fmt::format(
      "Without a parachute (fall without drag, lift or wind): {} m from the guide, with a failed canard up to {} m. "
      "Lift "
      "and wind can carry it farther.",
      fixed(landing.healthy_fall_m, 0), fixed(landing.failed_fall_m, 0));
}

std::string failed_landing(const Landing& landing) {
  if (!landing.failed_m) {
    return "With a failed canard: no flight reached the ground under its parachute.";
  }
  return fmt::format(
      "With a failed canard: within {} m of the guide.{}", fixed(*landing.failed_m, 0),
      landing.failed_without_landing > 0
          ? fmt::format(" {} of these flights did not land under the parachute and are not in this circle.",
                        landing.failed_without_landing)
          : "");
}

}  // namespace

std::string lean(const Brief& of) {
  return of.guide_tilt_rad > 0.0
             ? fmt::format("leans {} deg towards {} deg", text::brief(degrees(of.guide_tilt_rad), 1),
                           text::bearing_deg(of.guide_azimuth_rad))
             : "vertical";
}

std::string wind_flown(const Brief& of) {
  if (!of.is_six_dof) {
    return "none: the vehicle has no [airframe]";
  }
  return of.wind_m_s > 0.0
             ? fmt::format("{} m/s from {} deg", text::brief(of.wind_m_s, 1), text::bearing_deg(of.wind_from_rad))
             : "calm";
}

std::string doubts(const Brief& of) {
  std::string all = flight::outside_model(of.nominal.beyond_model);
  if (of.nominal.ascent_failed) {
    all += "The simulated ascent fails. ";
  }
  if (of.faults > 0) {
    all += fmt::format("Every flight here has the {} of the scenario. ", text::counted(of.faults, "fault"));
  }
  return all;
}

std::string headline(const Brief& of) {
  std::string all = fmt::format("{} {}Apogee {} m. ", never_flown, doubts(of), text::fixed(of.nominal.apogee_m, 0));
  if (!of.landing) {
    return all + "Where it comes down is not computed.";
  }
  const Landing& landing = *of.landing;
  const double fall_m = std::max(landing.healthy_fall_m, landing.failed_fall_m);
  const std::string fall = fmt::format("a fall without parachute, drag, lift and wind ends within {} m of the guide",
                                       text::fixed(fall_m, 0));
  const std::optional<double> landing_m = std::max(landing.healthy_m, landing.failed_m);
  if (!landing_m) {
    return fmt::format("{}A landing under a parachute is not computed. Healthy or with a failed canard, {}.", all,
                       fall);
  }
  const std::string unknown =
      landing.failed_without_landing == 0
          ? ""
          : fmt::format(" ({} did not land under it)", text::counted(landing.failed_without_landing, "flight"));
  return fmt::format(
      "{}Healthy or with a failed canard, {} it lands within {} m of the guide under its parachute{}; another wind "
      "moves that. And {}.",
      all, of.wind_m_s > 0.0 ? fmt::format("in a wind of {} m/s", text::brief(of.wind_m_s, 1)) : "in calm air",
      text::fixed(*landing_m, 0), unknown, fall);
}

std::vector<std::string> landing_sentences(const Brief& of) {
  if (!of.landing) {
    return {fmt::format("Not computed: {}.", of.why_no_landing)};
  }
  const Landing& landing = *of.landing;
  std::vector<std::string> all;
  if (!landing.has_parachute) {
    all.emplace_back("Under a parachute: not computed, the vehicle has no section [recovery].");
  } else {
    all.push_back(
        landing.healthy_m
            ? fmt::format("Under the parachute: {} m from the guide{}.", fixed(*landing.healthy_m, 0),
                          landing.healthy_bearing_rad
                              ? fmt::format(", bearing {} deg", text::bearing_deg(*landing.healthy_bearing_rad))
                              : "")
            : "Under the parachute: not computed, it did not reach the ground under it.");
    all.push_back(failed_landing(landing));
  }
  all.push_back(fall_sentence(landing));
  all.push_back(
      fmt::format("Failed canard: each of the four runs to each stop, every {} s from the guide to apogee ({}), "
                  "in the wind above. fantail campaign spreads the landings.",
                  text::brief(landing.step_s, 2), text::counted(landing.flights, "flight")));
  return all;
}

std::vector<std::string> wind_sentences(const Brief& of) {
  if (!of.wind_limit) {
    return {fmt::format("No limit is computed: {}.",
                        of.is_six_dof ? "control does not begin" : "the vehicle has no section [airframe]")};
  }
  const WindLimit& limit = *of.wind_limit;
  if (!limit.passed_m_s) {
    return {fmt::format("No wind passes. Even in calm air {}.", limit.first_failure)};
  }
  return {
      fmt::format("Simulated in steps of {} m/s, from four directions: up to {} m/s control stays within the roll "
                  "model.",
                  text::brief(wind_step_m_s, 0), text::brief(*limit.passed_m_s, 0)),
      fmt::format("Not judged: the end of the guide, where the angle of attack then reaches {} deg, and slower flight "
                  "than there.",
                  fixed(degrees(limit.exit_attack_rad), 0)),
      fmt::format("Up to there the tilt limit ends control no more than the allowed {} s before apogee.",
                  text::brief(limit.tilt_end_before_apogee_s, 2)),
      limit.first_failure.empty() ? "Stronger wind was not tried."
                                  : fmt::format("A{}.", limit.first_failure.substr(1))};
}

std::vector<std::string> gate_sentences(const Brief& of) {
  const core::DormancyPlan& gate = of.plan.dormancy;
  std::vector<std::string> all;
  if (gate.until == core::DormantUntil::guide) {
    all.push_back(fmt::format("Canards are commanded to trim until the rocket is {}.", beyond_guide(of.plan.guide)));
  } else {
    all.push_back(fmt::format("Canards are commanded to trim until {}.", gate_conditions(gate)));
    all.push_back(fmt::format("The rocket must also be {}.", beyond_guide(of.plan.guide)));
    if (waits_for_burn_out(gate.until)) {
      all.emplace_back("Thrust below drag counts as burn-out. Axial force above 1 g for 0.1 s ends control again.");
    } else if (waits_for_pressure(gate.until)) {
      all.emplace_back("If the pressure rises to a new maximum, they are commanded to trim again.");
    }
  }
  all.push_back(opening(of));
  return all;
}

std::vector<std::string> end_sentences(const Brief& of) {
  const core::RunPlan& run = of.plan.run;
  std::vector<std::string> all{
      fmt::format("Trim is commanded at the first of: apogee; tilt over {} deg from {}; {} s of control; gyro "
                  "silent for {} s; timing or "
                  "memory fault{}{}.",
                  text::brief(degrees(static_cast<double>(run.tilt_limit.radians())), 1),
                  run.tilt_from == core::TiltOrigin::guide ? "the direction at rest on the guide" : "the vertical",
                  text::brief(seconds(run.control_time), 1), text::brief(seconds(of.plan.motion.longest_gyro_gap), 3),
                  run.canard_fault == core::CanardFaultPolicy::end_control ? "; a failed canard" : "",
                  run.abort_input == core::AbortInput::none ? "" : "; abort")};
  if (run.canard_fault == core::CanardFaultPolicy::share) {
    all.emplace_back("A failed canard does not end control: the others compensate for it.");
  } else if (run.canard_fault == core::CanardFaultPolicy::continue_control) {
    all.emplace_back("A failed canard is recorded and does not end control.");
  }
  if (const auto& end = of.nominal.control_end) {
    all.push_back(fmt::format("Simulated: control ends at {} s, {} s before apogee: {}.", fixed(end->time_s, 2),
                              fixed(end->before_apogee_s, 2), end->why));
  }
  return all;
}

std::string abort_sentence(core::AbortInput input) {
  switch (input) {
    case core::AbortInput::none: return "None fitted. After the launch nobody on the ground can end control.";
    case core::AbortInput::open_aborts: return "Fitted: an open contact aborts, and so does a broken wire.";
    case core::AbortInput::closed_aborts:
      return "Fitted: a closed contact aborts. A broken wire does not, and disables the abort.";
  }
  return {};
}

std::vector<std::string> disarm_sentences(core::AbortInput input) {
  std::vector<std::string> all{
      "Light steadily on: nobody approaches. The canards may move, and the arm switch is ignored.",
      "Else one person alone, away from the canards, opens the arm switch and waits for the light of Safe.",
      "If the light of Armed stays: servos off, then avionics off.", "Dark: treat it as Armed."};
  if (input != core::AbortInput::none) {
    all.emplace_back("Before the launch the abort input disarms, too.");
  }
  return all;
}

}  // namespace fantail::brief
