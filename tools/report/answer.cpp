// SPDX-License-Identifier: MIT
#include "report/answer.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "json/value.hpp"
#include "report/fields.hpp"
#include "report/sections.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/sha256.hpp"

namespace fantail::report {
namespace {

using result::Block;
using text::degrees;
using Json = json::Value;

template <typename Row>
Block object(std::string key, const std::optional<Row>& row, const result::Fields<Row> auto& fields) {
  return row ? Block{result::figures(std::move(key), *row, fields)} : Block{result::Data{std::move(key), {}}};
}

Block at_apogee(const flight::Flight& flight) {
  return flight.path_frame == flight::PathFrame::plane ? object("at_apogee", apogee_of(flight), fields::apogee_in_plane)
                                                       : object("at_apogee", apogee_of(flight), fields::apogee);
}

/// About each body axis, the long one first.
Json gyro_bias(const flight::Flight& flight) {
  if (!flight.gyro_bias_rad_s) {
    return {};
  }
  Json all = Json::array();
  for (const float rad_s : {flight.gyro_bias_rad_s->x, flight.gyro_bias_rad_s->y, flight.gyro_bias_rad_s->z}) {
    all.push_back(json::rounded(degrees(static_cast<double>(rad_s))));
  }
  return all;
}

Json inertia_course(const flight::FlownAirframe& airframe) {
  Json course = Json::array();
  for (const auto& [time_s, inertia_kg_m2] : airframe.roll_inertia_course) {
    course.push_back({{"time_s", json::rounded(time_s)}, {"kg_m2", inertia_kg_m2}});
  }
  return course;
}

std::vector<result::Fact> facts(const flight::Flight& flight, const Figures& figures, const Verdict& verdict) {
  using json::text_or_null;
  const auto& airframe = flight.airframe;
  std::vector<result::Fact> all{
      {"scenario", "", flight.scenario},
      {"vehicle", "", text_or_null(flight.vehicle)},
      {"vehicle_file", "", airframe ? Json(airframe->vehicle_file) : Json{}},
      {"roll_inertia_kg_m2", "", airframe ? Json(airframe->roll_inertia_kg_m2) : Json{}},
      {"reference_area_m2", "", airframe ? Json(airframe->reference_area_m2) : Json{}},
      {"plan", "", text_or_null(flight.plan_name)},
      {"seed", "", flight.seed},
      {"changes", "", flight.changes},
      {"verdict", "", verdict.text},
      {"outcome", "", name(verdict.outcome)},
      {"canard_side_moment_m3", "", flight.side_moment_m3},
      {"pitch_frequency_per_speed_rad_m", "",
       flight.resonance_1_m ? Json::array({(*flight.resonance_1_m)[0], (*flight.resonance_1_m)[1]}) : Json{}},
      {"rest_limit_deg", "", json::rounded(degrees(flight.rest_limit_rad))},
      {"tilt_end_before_apogee_s", "", flight.tilt_end_before_apogee_s},
      {"why_uncontrollable", "", flight.why_uncontrollable},
      {"left_by_fins", "", json::rounded(flight.left_by_fins)},
      {"final_phase", "", flight.known.phase ? Json(core::name(figures.final_phase)) : Json{}},
      {"gyro_bias_deg_s", "", gyro_bias(flight)},
      {"why_not_armed", "", text_or_null(flight.why_not_armed)},
      {"notes", "", flight.notes},
      {"log_sha256", "", flight.log.empty() ? Json{} : Json(text::sha256(flight.log))},
      {"version", "", text_or_null(flight.version)}};
  if (airframe && airframe->grows_with_mach) {
    all.push_back({"compressibility", "", "prandtl_glauert"});
  }
  if (airframe && !airframe->roll_inertia_course.empty()) {
    all.push_back({"roll_inertia_course", "", inertia_course(*airframe)});
  }
  if (flight.trajectory_end_s) {
    all.push_back({"trajectory_end_s", "", json::rounded(*flight.trajectory_end_s)});
  }
  return all;
}

std::vector<Block> for_programs(const flight::Flight& flight, const Figures& figures) {
  std::vector<Block> all{result::figures("", figures, fields::figures),
                         result::figures("", flight.extremes, fields::extremes),
                         result::figures("events", flight.events, fields::events),
                         result::figures("neutral", figures.neutral, fields::neutral),
                         result::figures("opening", figures.opening, fields::opening),
                         result::figures("capture", figures.capture, fields::capture),
                         result::table("reopenings", figures.reopenings, fields::reopening),
                         object("oscillation", figures.oscillation, fields::oscillation),
                         object("canard_side_deflection", figures.side_deflection, fields::side_deflection),
                         result::table("loop_margins", flight.loop_margins, fields::margins),
                         object("canard_reach_deg", flight.canard_reach, fields::canard_reach),
                         result::figures("unmeasured", flight.unmeasured, fields::unmeasured),
                         result::table("barometer", flight.barometer_spells, fields::barometer),
                         object("wind", flight.wind, fields::wind),
                         at_apogee(flight),
                         result::table("phase_changes", flight.phase_changes, fields::phases),
                         result::table("canard_verdicts", flight.canard_verdict_changes, fields::canard_verdicts),
                         object("imposed_roll", flight.imposed_roll, fields::imposed_roll)};
  if (figures.camera_roll) {
    all.emplace_back(result::figures("camera_roll", *figures.camera_roll, fields::camera_roll));
  }
  if (flight.before_burnout) {
    all.emplace_back(result::Data{"before_burnout", before_burnout_json(flight)});
  }
  if (!flight.outages.empty()) {
    all.emplace_back(result::table("outages", flight.outages, fields::outages));
  }
  return all;
}

}  // namespace

std::optional<flight::PathPoint> apogee_of(const flight::Flight& flight) {
  const flight::PathPoint* top = flight::point_at(flight.path, flight.events.apogee_s.value_or(-1.0));
  return top != nullptr ? std::optional{*top} : std::nullopt;
}

result::Document summary(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                         const result::Made& made) {
  std::vector<std::string> about{flight.vehicle == flight.scenario ? "" : flight.vehicle};
  about.push_back(flight.plan_name.empty() ? "" : "plan " + flight.plan_name);
  about.push_back(flight.seed              ? fmt::format("seed {}", *flight.seed)
                  : flight.version.empty() ? ""
                                           : "flown by Fantail " + flight.version);
  std::erase(about, "");
  return {.kind = "flight report",
          .title = flight.scenario,
          .subtitle = fmt::format("{}", fmt::join(about, "; ")),
          .verdict = {.answer = report::answer(verdict),
                      .heading = std::string{display_name(verdict.outcome)},
                      .sentence = verdict.text,
                      .beside = beside_the_verdict(flight, figures, verdict),
                      // Steady, though not where it was commanded to be, or not off the guide yet.
                      .with_caution = verdict.outcome == Outcome::off_command || verdict.begun_on_guide_s},
          .facts = facts(flight, figures, verdict),
          .sections = {figures_section(flight, figures, verdict),
                       events_section(flight, verdict),
                       phases_section(flight),
                       notes_section(flight),
                       {"For programs", for_programs(flight, figures), result::Readers::programs}},
          .made = made};
}

std::vector<result::Listed> listed_fields() {
  using result::listed;
  return {listed("", fields::figures),
          listed("", fields::extremes),
          listed("events", fields::events),
          listed("neutral", fields::neutral),
          listed("opening", fields::opening),
          listed("capture", fields::capture),
          listed("reopenings[]", fields::reopening),
          listed("loop_margins[]", fields::margins),
          listed("canard_side_deflection", fields::side_deflection),
          listed("oscillation", fields::oscillation),
          listed("canard_reach_deg", fields::canard_reach),
          listed("unmeasured", fields::unmeasured),
          listed("barometer[]", fields::barometer),
          listed("wind", fields::wind),
          listed("at_apogee", fields::apogee),
          listed("phase_changes[]", fields::phases),
          listed("canard_verdicts[]", fields::canard_verdicts),
          listed("imposed_roll", fields::imposed_roll),
          listed("camera_roll", fields::camera_roll),
          listed("outages[]", fields::outages)};
}

}  // namespace fantail::report
