// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "predict/assumed_fins.hpp"
#include "predict/fields.hpp"
#include "predict/sentences.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using text::brief;
using text::degrees;
using text::fixed;
using A = AssumedAirframe;

constexpr auto airframe_fields = result::fields<A>({
    {"damping_factor", "damping, times the vehicle's", u::none, 1, &A::damping_factor,
     "factor on the vehicle's damping"},
    {"torque_factor", "torque, times the vehicle's", u::none, 1, &A::torque_factor,
     "factor on the vehicle's canard torque"},
    {"alpha", "damping", u::m2, 6, &A::damping_m2, "damping of these flights"},
    {"beta", "torque", u::m, 6, &A::torque_m, "canard torque of these flights"},
    {"phase_margin", "least phase margin", u::deg, 1, &A::phase_margin_rad,
     "phase margin at the worst speed under control"},
    {"held_to", "held to a fin offset of", u::deg, 2, &A::held_to_rad,
     "the roll is held with every fin offset tried up to this size, of both senses", Worse::neither, nullptr, "none"},
    {"fails_at", "not held at", u::deg, 2, &A::fails_at_rad, "the next size that was tried", Worse::neither, nullptr,
     "none tried"},
    {"why", "why", u::none, 0, &A::why, "why not, at that size"},
});

/// As the table has it.
std::string deg(double angle_rad) { return fixed(degrees(angle_rad), 2); }

std::string word(double factor) { return factor < 1.0 ? "half" : factor > 1.0 ? "twice" : "once"; }

std::string which(const A& airframe) {
  return airframe.damping_factor == 1.0 && airframe.torque_factor == 1.0
             ? "the vehicle's own values"
             : fmt::format("{} the damping and {} the torque", word(airframe.damping_factor),
                           word(airframe.torque_factor));
}

bool holds_straight_fins(const A& airframe) { return airframe.held_to_rad.has_value(); }

bool holds_nothing(const AssumedFins& all) {
  return std::ranges::all_of(all.airframes, [](const A& airframe) { return airframe.held_rad.empty(); });
}

/// Straight fins with the vehicle's own values, too: then nothing else is to blame.
bool is_outside_model(const AssumedFins& all) {
  return holds_nothing(all) && all.runs.front().outcome == report::Outcome::outside_model;
}

/// Of those that hold straight fins, and of all where none does.
const A& first_to_fail(const AssumedFins& all) {
  return *std::ranges::min_element(all.airframes, {}, [&](const A& airframe) {
    return holds_straight_fins(airframe) ? *airframe.held_to_rad : all.largest_offset_rad + 1.0;
  });
}

std::string up_to(const A& airframe) {
  return *airframe.held_to_rad > 0.0
             ? fmt::format("with every fin offset that was tried up to {} degrees", deg(*airframe.held_to_rad))
             : "without a fin offset";
}

std::string failure(const A& airframe) {
  return airframe.fails_at_rad ? fmt::format(" At {} degrees it is not, with {}: {}.", deg(*airframe.fails_at_rad),
                                             which(airframe), airframe.why)
                               : " More than that the canards cannot balance.";
}

struct Said {
  result::Answer answer;
  std::string heading;
  std::string sentence;
};

constexpr std::string_view tried_airframes =
    "damping and torque as in the vehicle file, and with half or twice of each";

Said said(const AssumedFins& all) {
  const auto straight = static_cast<std::size_t>(std::ranges::count_if(all.airframes, holds_straight_fins));
  if (!all.tilt.empty()) {
    return {result::Answer::no, "No go", fmt::format("No go: whatever the fins are, {}.", all.tilt)};
  }
  if (is_outside_model(all)) {
    return {result::Answer::undecided, "Outside the model",
            fmt::format("Outside the model: {}. No fins can be judged there.", all.beyond_model)};
  }
  if (holds_nothing(all)) {
    const A& own = all.airframes.front();
    return {result::Answer::no, "No go",
            fmt::format("No go: no fin offset from -{0} to {0} degrees meets the requirements. Tried were {1}. "
                        "With the vehicle's own values and straight fins, {2}.",
                        deg(all.largest_offset_rad), tried_airframes, own.why)};
  }
  if (straight == all.airframes.size()) {
    const A& first = first_to_fail(all);
    const A& own = all.airframes.front();
    std::string sentence = fmt::format("Depends on the fins: the roll is held {}, with {}.{}", up_to(first),
                                       tried_airframes, failure(first));
    if (&own != &first) {
      sentence += fmt::format(" With the vehicle's own values it is held {}.", up_to(own));
    }
    return {result::Answer::undecided, "Depends on the fins", std::move(sentence)};
  }
  std::string sentence = fmt::format(
      "Could be a go: of {} pairs of damping and torque, {} the roll with straight "
      "fins.",
      all.airframes.size(),
      straight == 0 ? "none holds" : fmt::format("{} {}", straight, straight == 1 ? "holds" : "hold"));
  for (const A& airframe : all.airframes) {
    sentence += holds_straight_fins(airframe) ? fmt::format(" With {} it is held {}.", which(airframe), up_to(airframe))
                                              : fmt::format(" With {} it is not: {}.", which(airframe), airframe.why);
  }
  return {result::Answer::undecided, "Could be a go", std::move(sentence)};
}

/// A cant of fins pushes with their lift, as their damping does.
double offset_per_cant(const AssumedFins& all, const A& airframe) {
  return *all.offset_per_cant * airframe.damping_factor / airframe.torque_factor;
}

std::string cant_sentence(const AssumedFins& all) {
  if (!all.offset_per_cant || !std::ranges::all_of(all.airframes, holds_straight_fins)) {
    return {};
  }
  const auto cant_deg = [&](const A& airframe) {
    return degrees(*airframe.held_to_rad) / offset_per_cant(all, airframe);
  };
  const A& own = all.airframes.front();
  double least_deg = cant_deg(own);
  double least_per = offset_per_cant(all, own);
  double most_per = least_per;
  for (const A& airframe : all.airframes) {
    least_deg = std::min(least_deg, cant_deg(airframe));
    least_per = std::min(least_per, offset_per_cant(all, airframe));
    most_per = std::max(most_per, offset_per_cant(all, airframe));
  }
  return fmt::format(
      "One degree of cant of all fins is a fin offset of {:.2g} degrees with the vehicle's own values, {:.2g} to "
      "{:.2g} "
      "with the others. So all of them hold a cant of {:.2g} degrees, and the vehicle's own one of {:.2g}.",
      offset_per_cant(all, own), least_per, most_per, least_deg, cant_deg(own));
}

std::vector<std::string> what_a_session_settles(const AssumedFins& all) {
  if (!all.tilt.empty()) {
    return all.tilt_advice.empty() ? std::vector<std::string>{} : std::vector{all.tilt_advice};
  }
  if (is_outside_model(all)) {
    return {"Mend this first: less wind, or a slower or a more stable rocket."};
  }
  if (holds_nothing(all)) {
    return {"Mend this first: a tunnel session does not change it."};
  }
  std::vector<std::string> sentences;
  if (std::string cant = cant_sentence(all); !cant.empty()) {
    sentences.push_back(std::move(cant));
  } else if (!all.offset_per_cant) {
    sentences.emplace_back(
        "What a cant of the fins is as a fin offset is not known: that needs the vehicle's shape and canards.");
  }
  sentences.push_back(
      fmt::format("Next: measure fin offset, damping and torque in a wind tunnel. {}",
                  std::ranges::all_of(all.airframes, holds_straight_fins)
                      ? "Small offsets are held by all pairs that were tried, larger ones by some or none."
                      : "Damping and torque decide whether even straight fins are held."));
  sentences.push_back(
      "fantail tunnel steps writes what it finds to steps.csv, and fantail predict SCENARIO --tunnel steps.csv --swirl "
      "DEG "
      "gives a go or a no go.");
  return sentences;
}

std::vector<std::string> not_counted(const AssumedFins& all) {
  std::vector<std::string> sentences{
      fmt::format(
          "Not judged before a measurement: roll resonance, another wind than {} m/s, and all other values that "
          "may differ (fantail campaign varies them).",
          brief(all.flown.wind.speed_m_s, 1)),
      fmt::format("Damping and torque beyond a factor of two of the vehicle's, and offsets between the {} sizes that "
                  "were tried.",
                  assumed_offset_steps + 1)};
  if (!all.beyond_model.empty()) {
    sentences.push_back(fmt::format("Flights outside the model count as not held: {}.", all.beyond_model));
  }
  return sentences;
}

page::Chart map(const AssumedFins& all) {
  page::Series held{.name = "held", .role = page::Role::measured, .mark = page::Mark::points};
  page::Series failed{.name = "not held", .role = page::Role::limit, .mark = page::Mark::points};
  std::vector<page::Level> levels;
  const std::size_t count = all.airframes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto height = static_cast<double>(count - i);
    const auto put = [height](page::Series& series, const std::vector<double>& offsets_rad) {
      for (const double offset_rad : offsets_rad) {
        series.x.push_back(degrees(offset_rad));
        series.y.push_back(height);
      }
    };
    put(held, all.airframes[i].held_rad);
    put(failed, all.airframes[i].failed_rad);
    levels.push_back({.value = height, .label = which(all.airframes[i])});
  }
  const double largest_deg = 1.05 * std::max(0.1, degrees(all.largest_offset_rad));
  return {.label = "Fin offsets with which the roll is held, for pairs of damping and torque",
          .x_label = "fin offset / deg",
          .y_label = "pair of damping and torque",
          .series = {held, failed},
          .levels = std::move(levels),
          .x_range = page::Range{-largest_deg, 1.9 * largest_deg},  // room for the names
          .y_range = page::Range{0.5, static_cast<double>(count) + 0.7}};
}

std::vector<std::string> basis(const AssumedFins& all) {
  std::vector<std::string> sentences{
      fmt::format("{} flights with seed {}: {} fin offsets, the same during the whole flight, with each of {} pairs of "
                  "damping and torque. The fin offset of the scenario is not used.",
                  all.runs.size(), all.seed, 2 * assumed_offset_steps + 1, all.airframes.size()),
      fmt::format(
          "Held means: as fantail fly judges it, with control beyond the guide and a phase margin of {} degrees "
          "or more at every speed under control.",
          deg(all.asked_phase_margin_rad))};
  for (const auto* more : {&all.flown.vehicle.assumed, &all.flight_notes}) {
    sentences.insert(sentences.end(), more->begin(), more->end());
  }
  return sentences;
}

}  // namespace

result::Listed listed_airframe_fields() {
  return result::listed("airframes[], without a tunnel result", airframe_fields);
}

result::Document answer(const AssumedFins& assumed, const result::Made& made) {
  using enum result::Readers;
  const Said verdict = said(assumed);
  const std::vector<std::string> next = what_a_session_settles(assumed);
  const std::vector<std::string> beside = not_counted(assumed);
  const std::string changes =
      assumed.request.changes.empty() ? "" : fmt::format(". Changed: {}", fmt::join(assumed.request.changes, ", "));
  return {
      .kind = "launch prediction with assumed fins",
      .title = assumed.scenario,
      .subtitle = fmt::format("{}plan {}; assumed fins, seed {}{}",
                              assumed.vehicle == assumed.scenario ? "" : assumed.vehicle + ", ", assumed.plan_name,
                              assumed.seed, changes),
      .verdict = {.answer = verdict.answer,
                  .heading = verdict.heading,
                  .sentence = verdict.sentence,
                  .beside = next,
                  .not_in_it = beside},
      .facts = {{"scenario", "", assumed.scenario},
                {"vehicle", "", assumed.vehicle},
                {"plan", "", assumed.plan_name},
                {"seed", "", assumed.seed},
                {"changes", "", assumed.request.changes},
                {"go", "", false},
                {"verdict", "", verdict.sentence},
                {"not_in_verdict", "", beside},
                {"version", "", made.version}},
      .sections = {{"How much fin offset is held",
                    {result::Picture{map(assumed),
                                     "Each point is a flight: held, or not. The fin offset is the canard angle that "
                                     "pushes as hard as the misaligned fins."},
                     result::table("airframes", assumed.airframes, airframe_fields)}},
                   {"How this was found", {result::Sentences{"basis", basis(assumed)}}},
                   {"For programs", {result::Sentences{"advice", next}}, programs}},
      .spreadsheets = {result::numbered(result::table("runs", assumed.runs, run_fields), "run")},
      .made = made};
}

}  // namespace fantail::predict
