// SPDX-License-Identifier: MIT
#include "predict/answer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "flight/flight.hpp"
#include "json/value.hpp"
#include "predict/assumed_fins.hpp"
#include "predict/fields.hpp"
#include "predict/sentences.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::predict {
namespace {

using page::Role;
using text::brief;
using text::degrees;
using Json = json::Value;
namespace u = result::units;

Json resonance(const Prediction& p) {
  if (!p.resonance) {
    return {};
  }
  const RollResonance& r = *p.resonance;
  return {{"pitch_frequency_per_speed_rad_m",
           Json::array({json::rounded(r.least_frequency_1_m), json::rounded(r.most_frequency_1_m)})},
          {"resonant_deg", result::json_of(u::deg, r.resonant_rad)},
          {"near_runs", r.near},
          {"past_runs", r.past},
          {"with_canards_runs", r.with_canards},
          {"warning", resonance_warning(p)}};
}

Json tunnel(const Prediction& p) {
  return {{"file", p.tunnel.name},
          {"steps", p.tunnel.steps.size()},
          {"swirl_deg", json::rounded(degrees(p.tunnel.swirl_rad))},
          {"sources", p.tunnel.sources},
          {"vehicle", p.tunnel.vehicle ? Json{*p.tunnel.vehicle} : Json{}},
          {"reference_area_m2", p.tunnel.reference_area_m2 ? Json{*p.tunnel.reference_area_m2} : Json{}},
          {"area_factor", p.area ? Json::array({json::rounded(p.area->low), json::rounded(p.area->high)}) : Json{}},
          {"damping_factor", Json::array({p.damping.low, p.damping.high})}};
}

result::Table band(const P& p) {
  std::vector<Instant> instants;
  instants.reserve(p.band.time_s.size());
  for (std::size_t i = 0; i < p.band.time_s.size(); ++i) {
    instants.push_back({p.band.time_s[i], p.band.roll_angle_rad[i], p.band.roll_rate_rad_s[i]});
  }
  return result::table("band", instants, band_fields);
}

std::vector<result::Block> roll(const P& p, const result::Table& band) {
  if (band.rows.empty()) {
    return {"No run left the pad."};
  }
  result::Picture angle = result::plot(band, "roll_angle", {.x = "time"}).wide();
  angle.chart.series.push_back(reference(p));
  angle.caption = flight::rejects_offset(p.flown.plan)
                      ? "True roll angle of the rocket. This law subtracts its estimate of the fin offset from the "
                        "command, so it settles at the reference if the canards reach far enough."
                      : "True roll angle of the rocket. A proportional-derivative loop settles at the "
                        "reference plus the fin offset over the gain, not at the reference.";
  result::Picture rate = result::plot(band, "roll_rate", {.x = "time"}).wide();
  rate.caption = "Roll rate. The band is the spread of the runs at each instant, not one run.";
  if (p.gate_time_s) {
    for (page::Chart* chart : {&angle.chart, &rate.chart}) {
      chart->shaded_ranges = {{.begin = 0.0, .end = p.gate_time_s->p50, .label = "canards at trim (median)"}};
    }
  }
  return {angle, rate};
}

std::vector<result::Block> stability(const P& p, const Decision& decision) {
  if (p.over_speed.empty()) {
    return {"No phase margin could be computed: control never begins, or its gains are zero."};
  }
  result::Table over_speed = result::table({}, p.over_speed, margin_fields);
  over_speed.read_every = 4;
  result::Picture margin = result::plot(over_speed, "phase_margin", {.x = "speed"}).wide();
  const double asked_deg = degrees(decision.thresholds.phase_margin_rad);
  margin.chart.levels = {
      {.value = asked_deg, .label = fmt::format("{} degrees required", brief(asked_deg, 1)), .role = Role::limit}};
  margin.caption = fmt::format(
      "How far the loop is from oscillating, from 20 m/s, or from control start if that is slower, to the top speed. "
      "The "
      "servo lag is {} ms, "
      "the dead time {} ms.",
      brief(1e3 * p.servo_lag_s, 1), brief(1e3 * p.delay_s, 1));
  std::vector<result::Block> all{margin, over_speed};
  if (std::ranges::any_of(p.over_speed, may_swing_with_less)) {
    all.emplace_back(
        "Where the loop is stable, a gain margin below 1 is the factor on the gain, at or below which it oscillates.");
  }
  return all;
}

std::vector<result::Block> unless_empty(const std::string& sentence) {
  return sentence.empty() ? std::vector<result::Block>{} : std::vector<result::Block>{sentence};
}

std::vector<result::Block> roll_and_pitch(const P& p) {
  std::vector<result::Block> all = unless_empty(resonance_warning(p));
  if (p.resonance) {
    all.emplace_back(result::Picture{
        resonance_chart(p),
        "Steady roll rates of the runs (5 to 95 %), and the rates near which roll and pitch resonate."});
  }
  return all;
}

std::vector<result::Block> offset_and_airframe(const P& p) {
  using result::Picture;
  std::vector<result::Block> all;
  if (auto chart = authority_chart(p)) {
    all.emplace_back(Picture{
        std::move(*chart),
        "Authority over speed. Where the fin offset needs more than the canards can give, no gains balance it."});
  }
  if (auto chart = cant_chart(p)) {
    all.emplace_back(
        Picture{std::move(*chart),
                "Canard against fin cant: the fins computed from the shape, the canard torque as flown (median of the "
                "runs). The points are the fin offset of the runs."});
  }
  all.emplace_back(Picture{offset_chart(p), "The fin offset against what the canards can balance."});
  all.emplace_back(
      Picture{airframe_chart(p), "The airframes that were flown, and the identified ones they were drawn from."});
  return all;
}

std::vector<result::Block> medians(const P& p) {
  std::vector<result::Block> all{result::figures("", p, median_fields)};
  if (p.worst_speed) {
    all.emplace_back("At the worst speed:");
    all.emplace_back(result::figures("stability.worst", *p.worst_speed, margin_fields));
  } else {
    all.emplace_back(result::Data{"stability.worst", {}});
  }
  return all;
}

/// What could not be judged is no go, and not a no.
result::Answer answer_of(const Decision& decision) {
  const auto is_no = [](const C& c) { return c.judgement == Judgement::not_met; };
  return decision.go                                     ? result::Answer::yes
         : std::ranges::any_of(decision.criteria, is_no) ? result::Answer::no
                                                         : result::Answer::undecided;
}

}  // namespace

std::vector<result::Listed> listed_fields() {
  return {result::listed("", median_fields),
          result::listed("", count_fields),
          result::listed("stability", loop_fields),
          result::listed("stability.worst, stability.over_speed[]", margin_fields),
          result::listed("criteria[]", filed_criterion_fields),
          result::listed("runs.csv", run_fields),
          result::listed("band.csv", band_fields),
          listed_airframe_fields()};
}

result::Document answer(const P& p, const Decision& decision, const result::Made& made) {
  using enum result::Readers;
  using result::Sentences;
  const std::string changes = p.request.changes.empty() ? "" : ". " + changes_sentence(p);
  const std::vector<std::string> not_counted = not_in_verdict(p, decision);
  const result::Table over_time = band(p);
  return {.kind = "launch prediction",
          .title = p.scenario,
          .subtitle = fmt::format("{}plan {}; {}, seed {}{}", p.vehicle == p.scenario ? "" : p.vehicle + ", ",
                                  p.plan_name, runs(p.runs.size()), p.seed, changes),
          .verdict = {.answer = answer_of(decision),
                      .heading = std::string{decision.heading()},
                      .sentence = decision.text,
                      .beside = decision.advice,
                      .not_in_it = not_counted,
                      .with_caution = decision.go && !decision.cautions.empty(),
                      .not_in_it_heading = "Beside the requirements:"},
          .facts = {{"scenario", "", p.scenario},
                    {"vehicle", "", p.vehicle},
                    {"plan", "", p.plan_name},
                    {"seed", "", p.seed},
                    {"changes", "", p.request.changes},
                    {"repeat_run", "any run again, with its flight report", repeat_command(p, "RUN")},
                    {"go", "", decision.go},
                    {"verdict", "", decision.text},
                    {"cautions", "", decision.cautions},
                    {"not_in_verdict", "", not_counted},
                    {"version", "", made.version}},
          .sections = {{"Median of the runs, and 5 to 95 % of them", medians(p)},
                       {"Requirements", {result::table({}, decision.criteria, criterion_fields)}},
                       {"Predicted roll", roll(p, over_time), files},
                       {"Fin offset and airframe", offset_and_airframe(p), files},
                       {"Roll and pitch", roll_and_pitch(p)},
                       {"Stability over speed", stability(p, decision), files},
                       {"How this was found", {Sentences{"basis", basis(p)}}, all, "Show the sources and assumptions"},
                       {"For programs",
                        {result::figures("", p, count_fields), result::figures("stability", p, loop_fields),
                         result::table("stability.over_speed", p.over_speed, margin_fields),
                         result::table("criteria", decision.criteria, filed_criterion_fields),
                         Sentences{"advice", decision.advice}, Sentences{"flight_notes", p.flight_notes},
                         result::Data{"tunnel", tunnel(p)}, result::Data{"roll_resonance", resonance(p)}},
                        programs}},
          .spreadsheets = {numbered(result::table("runs", p.runs, run_fields), "run"), over_time},
          .made = made};
}

}  // namespace fantail::predict
