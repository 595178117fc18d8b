// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "flight/model_end.hpp"
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
    {"stop", "stop", deg, 1, &E::stop_rad, "the stop at which it stands; 0 with cut pulses", Worse::neither,
     stop_words},
    {"way_turned", "way turned", deg, 1, &E::turned_rad,
     "the largest angle between its velocity and the sound rocket's, above 20 m/s", Worse::larger},
    {"apogee_moved", "apogee moved", m, 1, &E::away_m,
     "how far its apogee is from the sound rocket's over ground, to whichever side", Worse::larger},
    {"apogee", "apogee", m, 0, &E::apogee_m, "greatest height above the site", Worse::smaller},
    {"rolled", "rolled away", deg, 0, &E::rolled_rad,
     "the largest difference of its roll angle from the sound rocket's", Worse::larger},
    {"roll_rate", "roll rate", deg_s, 0, &E::roll_rate_rad_s, "the largest roll rate, either way", Worse::larger},
    {"side_force", "side force", n, 2, &E::side_force_n, "the largest force of the canards across the axis",
     Worse::larger},
    {"dynamic_pressure", "dynamic pressure", pa, 0, &E::pressure_pa, "dynamic pressure at the largest side force"},
    {"angle_of_attack", "angle of attack", deg, 1, &E::angle_of_attack_rad,
     "the largest angle of attack while faster than 20 m/s", Worse::larger},
    {"moment", "bending moment", n_m, 2, &E::moment_n_m, "the largest bending moment at the coupler", Worse::larger},
});

constexpr auto study_fields = result::fields<Study>({
    {"canard_side_area", "side area of a canard", m2, 6, &Study::side_area_m2, "area that makes the side force"},
    {"canard_position", "canards behind the tip", m, 3, &Study::position_m, "from the tip of the nose to the canards"},
    {"stop", "stop", deg, 1, &Study::stop_rad, "mechanical stop of the servos"},
    {"sound_apogee", "sound apogee", m, 0, &Study::sound_apogee_m, "apogee of the flight without a failure"},
    {"sound_angle_of_attack", "sound angle of attack", deg, 1, &Study::sound_angle_of_attack_rad,
     "largest angle of attack of that flight"},
    {"sound_roll_rate", "sound roll rate", deg_s, 0, &Study::sound_roll_rate_rad_s, "largest roll rate of that flight"},
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
             ? fmt::format("that runs to a stop, at {} deg either way,", text::brief(degrees(study.stop_rad), 1))
             : fmt::format("whose pulses are cut off for {} ms", fixed(1e3 * cut_s, 0));
}

/// The worst of all canards and instants.
std::string headline(const Study& study, const Effect& worst) {
  return fmt::format(
      "{}One canard {} turns this rocket's way by up to {} deg and moves its apogee by up to {} m. It rolls the rocket "
      "away by up to {} deg and pushes it aside by up to {} N.",
      flight::outside_model(study.beyond_model), what_fails(study), fixed(degrees(worst.turned_rad), 1),
      fixed(worst.away_m, 0), fixed(degrees(worst.rolled_rad), 0), fixed(worst.side_force_n, 1));
}

result::Figures at_worst(const Study& study, const Effect& worst) {
  result::Figures figures = result::figures("worst", worst, effect_fields, result::Wanted::that_can_be_worse);
  figures["apogee"].remark = fmt::format("sound rocket: {} m", fixed(study.sound_apogee_m, 0));
  figures["apogee"].label = "lowest apogee";
  figures["apogee"].key = "lowest_apogee";
  figures["apogee_moved"].remark = "over ground";
  figures["roll_rate"].remark = fmt::format("sound rocket: {}", fixed(degrees(study.sound_roll_rate_rad_s), 0));
  figures["side_force"].remark = "of the canards";
  if (study.options.coupler_m) {
    figures["moment"].remark = fmt::format("{} m from the tip", fixed(*study.options.coupler_m, 2));
  }
  return figures;
}

/// What the rows are not.
std::string_view no_clearance() {
  return "Distances count from the sound rocket's apogee and not from the launch guide; the launch guide and the wind "
         "are those of the scenario, and others can give more. These rows clear no range by themselves: they have no "
         "point of impact and no flight without a parachute.";
}

std::vector<std::string> definitions(const Effect& worst) {
  std::vector<std::string> all = result::meanings(worst, effect_fields);
  all.insert(all.begin(), "Sound rocket: the same flight without the failure; the two are compared until apogee.");
  return all;
}

/// From how much the worst was taken.
std::string base(const Study& study) {
  constexpr std::size_t few = 20;
  return fmt::format(
      "The worst of {} flights: each of four canards{} at {}, every {} s from the end of the guide, {} s "
      "after ignition, to apogee at {} s.{}",
      study.effects.size(), study.options.failure == Failure::hard_over ? ", each stop," : "",
      study.instants == 1 ? "one instant" : fmt::format("{} instants", study.instants), fixed(study.options.step_s, 2),
      fixed(study.first_s, 2), fixed(study.last_s, 2),
      study.instants < few ? " With so few instants what lies between them can be worse (--step)." : "");
}

std::string what_the_others_do(const Study& study) {
  switch (study.policy) {
    case core::CanardFaultPolicy::share:
      return "The other three go on controlling, by the real avionics, and carry what the failed one does not do, as "
             "far as their limit allows.";
    case core::CanardFaultPolicy::continue_control:
      return "The other three go on controlling, by the real avionics, as if the failed one followed.";
    case core::CanardFaultPolicy::end_control:
      return "When the avionics finds that a canard does not follow, control ends, and the other three go to trim.";
  }
  return {};
}

std::string up_to(const std::optional<double>& angle_rad) {
  return angle_rad ? fmt::format("up to {} deg", fixed(degrees(*angle_rad), 1)) : "it was never that fast";
}

std::vector<std::string> remarks(const Study& study, const Effect& worst) {
  std::vector<std::string> list{
      fmt::format("Flown in six degrees of freedom with run.canard_fault = {}. {}{}", name_of(study.policy),
                  study.options.failure == Failure::hard_over
                      ? "The canard stands at its stop from one instant to the next. "
                      : "",
                  what_the_others_do(study)),
      fmt::format("Side force: 1/2 rho v^2 times {:.4g} m2 times the sum of the four deflections as vectors across the "
                  "axis, at {} m from the tip of the nose. {}",
                  study.side_area_m2, fixed(study.position_m, 3),
                  study.stall_rad ? fmt::format("Lift grows with the angle up to the stall at {} deg.",
                                                fixed(degrees(*study.stall_rad), 0))
                                  : "The vehicle states no stall, so that lift grows with the angle up to the stop."),
      fmt::format("Angle of attack while faster than {} m/s through the air, along the axis: {}; of the sound rocket "
                  "in the same "
                  "wind: {}. The sound rocket rolls at up to {} deg/s. Where the plan's tilt limit ends control, a "
                  "rocket rolls on from there.",
                  fixed(slowest_m_s, 0), up_to(worst.angle_of_attack_rad), up_to(study.sound_angle_of_attack_rad),
                  fixed(degrees(study.sound_roll_rate_rad_s), 0)),
      "How far it drifts under a parachute is the same as for the sound rocket, from another apogee. A rocket that "
      "breaks is not in here."};
  if (study.options.coupler_m) {
    list.push_back(*study.options.coupler_m > study.position_m
                       ? "Bending moment: side force of the canards times its distance to the station. The inertia of "
                         "what lies in front of it takes some of that off, and the lift of the nose at an angle of "
                         "attack is not in it."
                       : "The station lies in front of the canards, whose force does not bend it; the lift of the nose "
                         "at an angle of attack is not in this figure.");
  }
  return list;
}

/// What a curve is.
std::string curves(const Study& study) {
  return study.options.failure == Failure::hard_over
             ? "A curve is a stop, and at each instant the worst of the four canards. A canard at its positive stop "
               "rolls the rocket the positive way."
             : "At each instant the worst of the four canards.";
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
  }
  using enum result::Readers;
  return {.kind = "study: one canard that fails",
          .title = study.scenario,
          .subtitle = study.vehicle,
          .verdict = {.answer = result::Answer::none,
                      .heading = fmt::format("At worst of {} flights", study.effects.size()),
                      .sentence = headline(study, worst),
                      .not_in_it = {std::string{no_clearance()}}},
          .facts = facts(study),
          .sections = {{"Where the apogee lies",
                        {result::Picture{
                            apogee_map(study),
                            "Apogee of each flight over ground, seen from above. The rocket lands farther downwind."}},
                        files},
                       {"At worst, each figure by itself", {at_worst(study, worst)}},
                       {"What the words mean", {result::Sentences{.all = definitions(worst)}}, files},
                       {"When it fails", plots, files},
                       {"How this is known", {base(study), result::Sentences{.all = remarks(study, worst)}}},
                       {"The study", {result::figures("", study, study_fields)}, programs},
                       {"Every flight", {flights}, files}},
          .made = study.made};
}

}  // namespace fantail::hardover
