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

/// Steps of the offset differ by it.
std::string deg(const AssumedFins& all, double angle_rad) {
  return fixed(degrees(angle_rad), all.largest_offset_rad < text::radians(5.0) ? 2 : 1);
}

std::string word(double factor) { return factor < 1.0 ? "half" : factor > 1.0 ? "twice" : "once"; }

std::string which(const A& airframe) {
  return airframe.damping_factor == 1.0 && airframe.torque_factor == 1.0
             ? "the vehicle's own values"
             : fmt::format("{} the damping and {} the torque", word(airframe.damping_factor),
                           word(airframe.torque_factor));
}

bool holds_straight_fins(const A& airframe) { return airframe.held_to_rad.has_value(); }

/// Of those that hold straight fins, and of all where none does.
const A& first_to_fail(const AssumedFins& all) {
  return *std::ranges::min_element(all.airframes, {}, [&](const A& airframe) {
    return holds_straight_fins(airframe) ? *airframe.held_to_rad : all.largest_offset_rad + 1.0;
  });
}

std::string up_to(const AssumedFins& all, const A& airframe) {
  return *airframe.held_to_rad > 0.0
             ? fmt::format("with every fin offset that was tried up to {} degrees", deg(all, *airframe.held_to_rad))
             : "without a fin offset";
}

std::string failure(const AssumedFins& all, const A& airframe) {
  return airframe.fails_at_rad ? fmt::format(" At {} degrees it is not, with {}: {}.", deg(all, *airframe.fails_at_rad),
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
  const bool none = std::ranges::all_of(all.airframes, [](const A& airframe) { return airframe.held_rad.empty(); });
  if (none) {
    const A& own = all.airframes.front();
    return {result::Answer::no, "No go",
            fmt::format("No go: whatever the fins are, no fin offset from -{0} to {0} degrees is held. Tried were {1}. "
                        "With the vehicle's own values and straight fins, {2}.",
                        deg(all, all.largest_offset_rad), tried_airframes, own.why)};
  }
  if (straight == all.airframes.size()) {
    const A& first = first_to_fail(all);
    const A& own = all.airframes.front();
    std::string sentence = fmt::format("Depends on the fins: they are not measured. The roll is held {}, with {}.{}",
                                       up_to(all, first), tried_airframes, failure(all, first));
    if (&own != &first) {
      sentence += fmt::format(" With the vehicle's own values it is held {}.", up_to(all, own));
    }
    return {result::Answer::undecided, "Depends on the fins", std::move(sentence)};
  }
  std::string sentence = fmt::format(
      "Could be a go: the fins are not measured. Of {} pairs of damping and torque, {} hold the roll with straight "
      "fins.",
      all.airframes.size(), straight == 0 ? "none" : fmt::format("{}", straight));
  for (const A& airframe : all.airframes) {
    sentence += holds_straight_fins(airframe)
                    ? fmt::format(" With {} it is held {}.", which(airframe), up_to(all, airframe))
                    : fmt::format(" With {} it is not: {}.", which(airframe), airframe.why);
  }
  return {result::Answer::undecided, "Could be a go", std::move(sentence)};
}

std::vector<std::string> what_a_session_settles(const AssumedFins& all, result::Answer answer) {
  std::vector<std::string> sentences;
  const A& first = first_to_fail(all);
  if (all.offset_per_cant && answer != result::Answer::no && first.held_to_rad && *first.held_to_rad > 0.0) {
    const auto& per = *all.offset_per_cant;
    const std::string range = std::isfinite(per.high) ? fmt::format("{} to {}", brief(per.low, 1), brief(per.high, 1))
                                                      : fmt::format("{} or more", brief(per.low, 1));
    sentences.push_back(fmt::format(
        "One degree of cant of all fins is a fin offset of {} degrees ({} by the method's error). By the first number, "
        "{} degrees are a cant of {} degrees.",
        brief(per.value, 1), range, deg(all, *first.held_to_rad), brief(degrees(*first.held_to_rad) / per.value, 2)));
  }
  if (answer == result::Answer::no) {
    return {"A tunnel session alone does not make it a go: change plan or canards first."};
  }
  const bool offset_alone = std::ranges::all_of(all.airframes, holds_straight_fins);
  sentences.push_back(offset_alone ? "A session in a wind tunnel settles it: the fin offset decides."
                                   : "A session in a wind tunnel settles it: damping and torque decide, and the fin "
                                     "offset.");
  sentences.push_back(
      "fantail tunnel steps writes what it finds to steps.csv, and fantail predict --tunnel steps.csv gives a go or a "
      "no go.");
  return sentences;
}

std::vector<std::string> not_counted(const AssumedFins& all) {
  std::vector<std::string> sentences{
      "Not judged before a measurement: roll resonance, another wind than the stated one, and all other values that "
      "may differ (fantail campaign varies them).",
      fmt::format("Damping and torque beyond a factor of two of the vehicle's, and offsets between the {} sizes that "
                  "were tried.",
                  assumed_offset_steps + 1)};
  if (!all.tilt.empty()) {
    sentences.push_back(fmt::format("The tilt limit: {}.", all.tilt));
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
  return {.label = "Fin offsets with which the roll is held, for pairs of damping and torque",
          .x_label = "fin offset / deg",
          .y_label = "pair of damping and torque",
          .height = 380.0,
          .series = {held, failed},
          .levels = std::move(levels),
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
          deg(all, all.asked_phase_margin_rad))};
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
  const std::vector<std::string> next = what_a_session_settles(assumed, verdict.answer);
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
