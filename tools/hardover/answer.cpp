// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "flight/model_end.hpp"
#include "fly/to_ground.hpp"
#include "hardover/study.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::hardover {
namespace {

using result::Cell;
using result::Worse;
using text::degrees;
using text::fixed;
using namespace result::units;
using E = Effect;

/// With its sign: which stop it is.
std::string stop_words(double stop_deg) {
  return stop_deg == 0.0 ? "-" : fmt::format("{}{}", stop_deg > 0.0 ? "+" : "", text::brief(stop_deg, 1));
}

constexpr auto effect_fields = result::fields<E>({
    {"from", "fails after ignition", s, 2, &E::from_s, "when the canard fails, after ignition"},
    {"canard", "canard", none, 0, [](const E& e) { return Cell{std::uint64_t{e.canard + 1}}; }, "number of the canard"},
    {"stop", "stop", deg, 1, &E::stop_rad, "stop at which the canard stays; 0 with cut pulses", Worse::neither,
     stop_words},
    {"way_turned", "path deflection", deg, 1, &E::turned_rad,
     "largest angle between its velocity and the healthy rocket's, above 20 m/s", Worse::larger},
    {"apogee_moved", "apogee shift", m, 1, &E::away_m,
     "horizontal distance of its apogee from the healthy rocket's, in any direction", Worse::larger},
    {"apogee_east", "apogee to the east", m, 1, &E::apogee_east_m, "over ground, from the foot of the guide"},
    {"apogee_north", "apogee to the north", m, 1, &E::apogee_north_m, "over ground, from the foot of the guide"},
    {"landing_moved", "landing shift", m, 0, &E::landing_away_m,
     "horizontal distance of its landing point under the parachute from the healthy rocket's", Worse::larger},
    {"landing_from_guide", "landing from the guide", m, 0, &E::landing_from_guide_m,
     "horizontal distance of its landing point from the foot of the guide", Worse::larger},
    {"landing_east", "landing to the east", m, 0, &E::landing_east_m,
     "under the parachute, from the foot of the guide; null: not known"},
    {"landing_north", "landing to the north", m, 0, &E::landing_north_m,
     "under the parachute, from the foot of the guide; null: not known"},
    {"apogee", "apogee", m, 0, &E::apogee_m, "greatest height above the site", Worse::smaller},
    {"rolled", "roll change", deg, 0, &E::rolled_rad,
     "largest difference between its roll angle and the healthy rocket's", Worse::larger},
    {"roll_rate", "roll rate", deg_s, 0, &E::roll_rate_rad_s, "largest roll rate, in either direction", Worse::larger},
    {"side_force", "side force", n, 2, &E::side_force_n, "largest force of the canards across the axis of the rocket",
     Worse::larger},
    {"dynamic_pressure", "dynamic pressure", pa, 0, &E::pressure_pa, "dynamic pressure at the largest side force"},
    {"angle_of_attack", "angle of attack", deg, 1, &E::angle_of_attack_rad,
     "largest angle of attack while faster than 20 m/s", Worse::larger},
    {"moment", "bending moment", n_m, 2, &E::moment_n_m, "largest bending moment at the coupler", Worse::larger},
});

constexpr auto study_fields = result::fields<Study>({
    {"canard_side_area", "side area of a canard", m2, 6, &Study::side_area_m2, "area that produces the side force"},
    {"canard_position", "canards behind the tip", m, 3, &Study::position_m, "from the tip of the nose to the canards"},
    {"stop", "stop", deg, 1, &Study::stop_rad, "mechanical stop of the servos"},
    {"sound_apogee", "apogee without failure", m, 0, &Study::sound_apogee_m, "apogee of the flight without a failure"},
    {"sound_angle_of_attack", "angle of attack without failure", deg, 1, &Study::sound_angle_of_attack_rad,
     "largest angle of attack of the flight without a failure"},
    {"sound_roll_rate", "roll rate without failure", deg_s, 0, &Study::sound_roll_rate_rad_s,
     "largest roll rate of the flight without a failure"},
    {"flights", "flights", none, 0, [](const Study& of) { return Cell{std::uint64_t{of.effects.size()}}; },
     "flights with a failure"},
    {"instants", "instants", none, 0, &Study::instants, "instants at which each canard fails"},
    {"step", "between two instants", s, 2, [](const Study& of) { return Cell{of.options.step_s}; },
     "time between two instants"},
    {"coupler", "coupler behind the tip", m, 2,
     [](const Study& of) { return of.options.coupler_m ? Cell{*of.options.coupler_m} : Cell{}; },
     "from the tip of the nose to the station of the bending moment"},
});

std::string what_fails(const Study& study) {
  return study.options.failure == Failure::hard_over
             ? fmt::format("at its stop ({} deg either way)", text::brief(degrees(study.stop_rad), 1))
             : fmt::format("whose pulses are cut short for {} ms", fixed(1e3 * cut_s, 0));
}

/// The worst of all canards and instants.
std::string headline(const Study& study, const Effect& worst) {
  return fmt::format(
      "{}One canard {} moves the apogee by up to {} m{}. It turns the path by up to {} deg and the roll by up to "
      "{} deg; the canards push sideways with up to {} N.",
      flight::outside_model(study.beyond_model), what_fails(study), fixed(worst.away_m, 0),
      worst.landing_away_m ? fmt::format(" and the landing point by up to {} m", fixed(*worst.landing_away_m, 0)) : "",
      fixed(degrees(worst.turned_rad), 1), fixed(degrees(worst.rolled_rad), 0), fixed(worst.side_force_n, 1));
}

result::Figures at_worst(const Study& study, const Effect& worst) {
  result::Figures figures = result::figures("worst", worst, effect_fields, result::Wanted::that_can_be_worse);
  figures["apogee"].remark = fmt::format("healthy rocket: {} m", fixed(study.sound_apogee_m, 0));
  figures["apogee"].label = "lowest apogee";
  figures["apogee"].key = "lowest_apogee";
  figures["apogee_moved"].remark = "horizontal";
  if (worst.landing_away_m) {
    figures["landing_moved"].remark = "under the parachute";
    figures["landing_from_guide"].remark = fmt::format(
        "healthy rocket: {} m", fixed(std::hypot(*study.sound_landing_east_m, *study.sound_landing_north_m), 0));
  }
  figures["roll_rate"].remark = fmt::format("healthy rocket: {}", fixed(degrees(study.sound_roll_rate_rad_s), 0));
  figures["side_force"].remark = "of the canards";
  if (study.options.coupler_m) {
    figures["moment"].remark = fmt::format("{} m from the tip", fixed(*study.options.coupler_m, 2));
  }
  return figures;
}

/// What the rows are not.
std::string no_clearance(const Study& study) {
  return fmt::format(
      "The shifts are distances from the healthy rocket and not from the launch guide. The guide and the wind are "
      "those "
      "of the scenario{}; others can give larger distances. These rows do not clear a range: they contain no fall "
      "without a parachute.",
      study.has_parachute ? ", the parachute is that of the vehicle" : "");
}

/// How far the simulation tells where it lands.
std::string descent(const Study& study) {
  if (!study.has_parachute) {
    return "Landing points are not known: the vehicle has no parachute (section [recovery]). A fall without one, at "
           "large angles of attack, is outside the model.";
  }
  const auto unknown = std::ranges::count_if(study.effects, [](const Effect& of) { return !of.landing_east_m; });
  std::string all =
      "Each flight is simulated to the ground under the parachute of the vehicle's section [recovery]. "
      "Until it is open, the fall can be outside the model.";
  if (unknown > 0) {
    all += fmt::format(
        " {} of {} flights have no landing point: the parachute did not open, or they were in the air {} s after "
        "apogee.",
        unknown, study.effects.size(), fixed(fly::longest_fall_s, 0));
  }
  return all;
}

std::vector<std::string> definitions(const Effect& worst) {
  std::vector<std::string> all = result::meanings(worst, effect_fields);
  all.insert(all.begin(),
             "Healthy rocket: the same flight without the failure. The two are compared until apogee, "
             "and by where they land.");
  return all;
}

/// From how much the worst was taken.
std::string base(const Study& study) {
  constexpr std::size_t few = 20;
  return fmt::format(
      "The worst of {}. Each of the four canards{} fails at {}, every {} s from the end of the guide, {} s "
      "after ignition, to apogee at {} s.{}",
      text::counted(study.effects.size(), "flight"),
      study.options.failure == Failure::hard_over ? ", at each stop," : "",
      study.instants == 1 ? "one instant" : fmt::format("{} instants", study.instants), fixed(study.options.step_s, 2),
      fixed(study.first_s, 2), fixed(study.last_s, 2),
      study.instants < few ? " With so few instants, a failure between them can be worse (reduce --step)." : "");
}

std::string what_the_others_do(const Study& study) {
  switch (study.policy) {
    case core::CanardFaultPolicy::share:
      return "The real flight law continues to control with the other three. They make up for the failed one as far as "
             "their limit allows.";
    case core::CanardFaultPolicy::continue_control:
      return "The real flight law continues to control with the other three, as if the failed one followed its "
             "commands.";
    case core::CanardFaultPolicy::end_control:
      return "When the avionics detect that a canard does not follow its commands, control ends and the other three go "
             "to trim.";
  }
  return {};
}

/// Beyond the guide they wait, and a failed one changes nothing of that.
std::string before_the_gate(const Study& study) {
  return !study.has_gate ? ""
         : study.policy == core::CanardFaultPolicy::end_control
             ? " Before the plan's gate opens the other three stay at trim, and then control does not begin."
             : " Before the plan's gate opens the other three stay at trim.";
}

std::string up_to(const std::optional<double>& angle_rad) {
  return angle_rad ? fmt::format("up to {} deg", fixed(degrees(*angle_rad), 1)) : "never that fast";
}

std::vector<std::string> remarks(const Study& study, const Effect& worst) {
  std::vector<std::string> list{
      fmt::format(
          "Flown in six degrees of freedom with run.canard_fault = {}. {}{}{}", name_of(study.policy),
          study.options.failure == Failure::hard_over ? "The canard reaches its stop instantly and stays there. " : "",
          what_the_others_do(study), before_the_gate(study)),
      fmt::format("Side force: 1/2 rho v^2 times {:.4g} m2 times the vector sum of the four deflections across the "
                  "axis. It acts {} m from the tip of the nose. {}",
                  study.side_area_m2, fixed(study.position_m, 3),
                  study.stall_rad ? fmt::format("Lift grows with the angle up to the stall at {} deg.",
                                                fixed(degrees(*study.stall_rad), 0))
                                  : "The vehicle has no stall angle, so lift grows with the angle up to the stop."),
      fmt::format("Angle of attack while the air speed along the axis is above {} m/s: {}. The healthy rocket in the "
                  "same wind: {}. The healthy rocket rolls at up to {} deg/s. After the plan's tilt limit ends "
                  "control, the rocket rolls freely.",
                  fixed(slowest_m_s, 0), up_to(worst.angle_of_attack_rad), up_to(study.sound_angle_of_attack_rad),
                  fixed(degrees(study.sound_roll_rate_rad_s), 0)),
      "Structural failure is not modelled."};
  if (study.options.coupler_m) {
    list.push_back(*study.options.coupler_m > study.position_m
                       ? "Bending moment: side force of the canards times its distance to the station. The inertia of "
                         "the parts in front of the station reduces it; this is not included. The lift of the nose at "
                         "an angle of attack is not included either."
                       : "The station lies in front of the canards, so their force causes no bending there. The lift "
                         "of the nose at an angle of attack is not included.");
  }
  return list;
}

/// What a curve is.
std::string curves(const Study& study) {
  return study.options.failure == Failure::hard_over
             ? "Each curve is one stop and shows, at each instant, the worst of the four canards. A canard at its "
               "positive stop rolls the rocket in the positive direction."
             : "Each point is the worst of the four canards at that instant.";
}

std::vector<result::Fact> facts(const Study& study) {
  return {{"scenario", "scenario", study.scenario},
          {"vehicle", "", study.vehicle},
          {"plan", "plan", study.plan},
          {"changes", "changed", study.made.changes},
          {"seed", "seed", study.seed},
          {"canard_fault", "", name_of(study.policy)},
          {"outside_model", "", json::text_or_null(study.beyond_model)},
          {"failure", "", study.options.failure == Failure::hard_over ? "hard_over" : "cut_pulses"},
          {"version", "version", study.made.version},
          {"command", "command", study.made.command}};
}

}  // namespace

std::string_view name_of(core::CanardFaultPolicy policy) {
  switch (policy) {
    case core::CanardFaultPolicy::share: return "share";
    case core::CanardFaultPolicy::continue_control: return "continue";
    case core::CanardFaultPolicy::end_control: return "end_control";
  }
  return "unknown";
}

Effect Study::worst() const {
  Effect worst = result::worst(effects, effect_fields);
  worst.apogee_m = std::min(worst.apogee_m, sound_apogee_m);
  return worst;
}

std::vector<result::Listed> listed_fields() {
  return {result::listed("", study_fields), result::listed("effects[], worst", effect_fields)};
}

result::Document answer(const Study& study) {
  const Effect worst = study.worst();
  const result::Table flights = result::table("effects", study.effects, effect_fields);
  std::vector<result::Block> plots{curves(study)};
  for (const std::string_view y : {"side_force", "way_turned", "apogee_moved", "apogee", "angle_of_attack", "rolled"}) {
    plots.emplace_back(result::plot(flights, y, {.x = "from", .curves = "stop"}));
    if (y == "angle_of_attack") {
      std::get<result::Picture>(plots.back()).caption += fmt::format(
          " The curve ends where no flight was faster than {} m/s after the failure.", fixed(slowest_m_s, 0));
    }
  }
  std::vector<result::Block> maps{
      result::Picture{apogee_map(study), "Apogee of each flight over ground, seen from above."}};
  const auto landing = landing_map(study);
  if (landing) {
    maps.emplace_back(result::Picture{*landing, "Landing point of each flight, seen from above."});
  }
  using enum result::Readers;
  return {.kind = "study: failure of one canard",
          .title = study.scenario,
          .subtitle = study.vehicle,
          .verdict = {.answer = result::Answer::none,
                      .heading = "Worst of " + text::counted(study.effects.size(), "flight"),
                      .sentence = headline(study, worst),
                      .not_in_it = {no_clearance(study)}},
          .facts = facts(study),
          .sections = {{landing ? "Apogee and landing" : "Apogee", maps, files},
                       {"Descent", {descent(study)}},
                       {"Worst value of each figure", {at_worst(study, worst)}},
                       {"Definitions", {result::Sentences{.all = definitions(worst)}}, files},
                       {"Effect over the time of failure", plots, files},
                       {"Method", {base(study), result::Sentences{.all = remarks(study, worst)}}},
                       {"The study", {result::figures("", study, study_fields)}, programs},
                       {"Every flight", {flights}, files}},
          .made = study.made};
}

}  // namespace fantail::hardover
