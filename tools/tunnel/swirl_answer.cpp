// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "json/value.hpp"
#include "page/chart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using page::Series;
using result::Cell;
using text::degrees;
using text::fixed;
using text::in_degrees;
namespace u = result::units;

constexpr result::Unit set_point{"_rpm", "rpm"};

constexpr auto offset_fields = result::fields<OffsetPoint>({
    {"fan", "fan", set_point, 0,
     [](const OffsetPoint& p) { return p.segment.fan_rpm ? Cell{*p.segment.fan_rpm} : Cell{}; }, "the fan's set point"},
    {"begin", "from", u::s, 1, [](const OffsetPoint& p) { return Cell{p.segment.begin_s}; },
     "beginning of the steady time"},
    {"end", "to", u::s, 1, [](const OffsetPoint& p) { return Cell{p.segment.end_s}; }, "end of the steady time"},
    {"speed", "speed", u::m_s, 2, [](const OffsetPoint& p) { return Cell{p.speed_m_s.mean}; }, "mean wind speed"},
    {"speed_standard_error", "its error", u::m_s, 3,
     [](const OffsetPoint& p) { return Cell{p.speed_m_s.standard_error}; }, "standard error of that mean"},
    {"roll_rate", "roll rate", u::deg_s, 2, [](const OffsetPoint& p) { return Cell{p.rate_rad_s.mean}; },
     "mean roll rate"},
    {"roll_rate_standard_error", "error", u::deg_s, 2,
     [](const OffsetPoint& p) { return Cell{p.rate_rad_s.standard_error}; }, "standard error of that mean"},
    {"independent_samples", "independent samples", u::none, 0,
     [](const OffsetPoint& p) { return Cell{p.rate_rad_s.independent_samples}; },
     "number of independent samples that the rate samples are equal to"},
    {"canard", "canards", u::deg, 3, &OffsetPoint::canard_rad, "mean canard angle; 0 if the log does not have it"},
    {"offset", "offset", u::deg, 3, &OffsetPoint::offset_rad, "equivalent fin offset, corrected for the canards"},
    {"offset_standard_error", "error", u::deg, 3, &OffsetPoint::standard_error_rad, "standard error of the offset"},
});

constexpr auto difference_fields = result::fields<OffsetDifference>({
    {"speed", "speed", u::m_s, 2, &OffsetDifference::speed_m_s, "mean wind speed of both"},
    {"without", "without", u::deg, 3, &OffsetDifference::without_rad, "offset without flow straightener"},
    {"with", "with", u::deg, 3, &OffsetDifference::with_rad, "offset with it"},
    {"difference", "difference", u::deg, 3, &OffsetDifference::difference_rad,
     "without minus with: the offset due to swirl"},
    {"standard_error", "error", u::deg, 3, &OffsetDifference::standard_error_rad, "standard error of the difference"},
    {"counted", "counted", u::none, 0, &OffsetDifference::counted, "whether it is fast enough for the mean"},
});

constexpr auto swirl_fields = result::fields<Swirl>({
    {"swirl", "swirl", u::deg, 3, [](const Swirl& s) { return s.swirl ? Cell{s.swirl->offset_rad} : Cell{}; },
     "the mean difference, as --swirl takes it; null: unknown"},
    {"swirl_standard_error", "error", u::deg, 3,
     [](const Swirl& s) { return s.swirl ? Cell{s.swirl->standard_error_rad} : Cell{}; }, "its standard error"},
    {"swirl_deviation", "deviation", u::deg, 3,
     [](const Swirl& s) { return s.swirl && s.swirl->deviation_rad ? Cell{*s.swirl->deviation_rad} : Cell{}; },
     "standard deviation over the speeds; null for a single one"},
    {"from_speed", "from", u::m_s, 1, [](const Swirl& s) { return Cell{s.options.from_speed_m_s}; },
     "lowest speed at which differences count"},
    {"alpha", "alpha", u::m2, 3, [](const Swirl& s) { return Cell{s.options.roll.alpha_m2}; }, "damping that was used"},
    {"beta", "beta", u::m, 3, [](const Swirl& s) { return Cell{s.options.roll.beta_m}; },
     "torque constant that was used"},
});

constexpr const char* sign_sentence =
    "A positive swirl rolls the rocket as positive canard angles do: clockwise, seen from the tail. fantail predict "
    "takes it with this sign, as --swirl.";
constexpr const char* without_name = "without straightener";
constexpr const char* with_name = "with straightener";

result::Picture rates_over_time(const SwirlSessions& sessions) {
  const auto& a = sessions.without.roll;
  const auto& b = sessions.with.roll;
  const Chart chart{
      .label = "Roll rate over time, with and without flow straightener",
      .x_label = "time / s",
      .y_label = "roll rate / deg/s",
      .series = {{.name = without_name, .x = a.time_s, .y = in_degrees(a.roll_rate_rad_s)},
                 {.name = with_name, .role = Role::second_model, .x = b.time_s, .y = in_degrees(b.roll_rate_rad_s)}}};
  return {chart, "Roll rate over time, the canards at zero."};
}

Series wind_series(const TunnelLog& wind, const char* name, Role role) {
  return {.name = name, .role = role, .x = wind.time_s, .y = wind.wind_speed_m_s};
}

result::Picture wind_over_time(const SwirlSessions& sessions) {
  Chart chart{.label = "Wind speed over time in both sessions",
              .x_label = "time / s",
              .y_label = "wind speed / m/s",
              .series = {wind_series(sessions.without.wind, without_name, Role::measured),
                         wind_series(sessions.with.wind, with_name, Role::second_model)}};
  for (const SteadySegment& segment : sessions.without.steady.found) {
    chart.shaded_ranges.push_back({segment.begin_s, segment.end_s, segment.fan_rpm ? fixed(*segment.fan_rpm, 0) : ""});
  }
  return {chart,
          "Wind speed over time. Shaded: where it was steady without the straightener, with the fan's set "
          "point in rpm."};
}

Series over_speed(const std::vector<OffsetPoint>& points, const char* name, Role role,
                  double (*value)(const OffsetPoint&)) {
  Series series{.name = name, .role = role, .mark = Mark::line_and_points};
  for (const OffsetPoint& p : points) {
    series.x.push_back(p.speed_m_s.mean);
    series.y.push_back(degrees(value(p)));
  }
  return series;
}

result::Picture against_speed(const Swirl& swirl, const char* label, const char* y_label, const char* caption,
                              double (*value)(const OffsetPoint&)) {
  return {page::Chart{.label = label,
                      .x_label = "mean wind speed / m/s",
                      .y_label = y_label,
                      .width = page::half_page,
                      .series = {over_speed(swirl.without, without_name, Role::measured, value),
                                 over_speed(swirl.with, with_name, Role::second_model, value)}},
          caption};
}

result::Picture difference(const Swirl& swirl) {
  Series series{.name = "difference", .mark = Mark::line_and_points};
  page::Area area{.name = "two standard errors", .role = Role::measured};
  for (const OffsetDifference& d : swirl.differences) {
    series.x.push_back(d.speed_m_s);
    series.y.push_back(degrees(d.difference_rad));
    area.x.push_back(d.speed_m_s);
    area.low.push_back(degrees(d.difference_rad - 2.0 * d.standard_error_rad));
    area.high.push_back(degrees(d.difference_rad + 2.0 * d.standard_error_rad));
  }
  Chart chart{.label = "Difference of the two offsets against wind speed",
              .x_label = "mean wind speed / m/s",
              .y_label = "offset of the swirl / deg",
              .series = {series},
              .areas = {area},
              .levels = {{.value = swirl.options.from_speed_m_s, .label = "counted from here", .upright = true}}};
  if (swirl.swirl) {
    chart.levels.push_back({.value = degrees(swirl.swirl->offset_rad), .label = "mean"});
  }
  return {chart, "Offset due to swirl: without minus with straightener."};
}

/// What people read of a session.
result::Table read_points(const std::vector<OffsetPoint>& points) {
  return result::only(result::table({}, points, offset_fields),
                      {"fan", "speed", "roll_rate", "roll_rate_standard_error", "offset", "offset_standard_error"});
}

std::vector<result::Block> offsets(const SwirlSessions& sessions, const Swirl& swirl) {
  return {against_speed(swirl, "Mean steady roll rate against wind speed", "roll rate / deg/s",
                        "Mean steady roll rate against wind speed.",
                        [](const OffsetPoint& p) { return p.rate_rad_s.mean; }),
          against_speed(swirl, "Equivalent fin offset against wind speed", "offset / deg",
                        "Equivalent fin offset against wind speed.", [](const OffsetPoint& p) { return p.offset_rad; }),
          "Without flow straightener: " + sessions.without.roll.name,
          read_points(swirl.without),
          "With flow straightener: " + sessions.with.roll.name,
          read_points(swirl.with)};
}

std::vector<result::Block> what_the_swirl_adds(const Swirl& swirl) {
  std::vector<result::Block> all{difference(swirl), result::table("differences", swirl.differences, difference_fields)};
  if (swirl.swirl) {
    all.emplace_back(sign_sentence);
  }
  all.emplace_back(fmt::format(
      "Offsets are alpha p / (beta v) with alpha {:g} m2 and beta {:g} m, minus the mean canard angle. An error of "
      "these two scales both curves and the difference. The standard errors come from the scatter of the samples and "
      "do not include it.",
      swirl.options.roll.alpha_m2, swirl.options.roll.beta_m));
  return all;
}

std::vector<result::Block> session(const std::string& key, const RollSession& session,
                                   const std::vector<OffsetPoint>& points) {
  return {result::Data{key + ".log", session.roll.name}, result::Data{key + ".wind", session.wind.name},
          result::table(key + ".set_points", points, offset_fields)};
}

std::string sentence(const Swirl& swirl) {
  if (!swirl.swirl) {
    return fmt::format("Swirl: unknown, because the sessions have no common speed of {:g} m/s or more.",
                       swirl.options.from_speed_m_s);
  }
  return fmt::format(
      "Swirl: {:.3f} \u00b1 {:.3f} deg of canard angle (mean over {} speeds from {:g} m/s on; \u00b1 is its standard "
      "error), with alpha {:g} m2 and beta {:g} m, {}.",
      degrees(swirl.swirl->offset_rad), degrees(swirl.swirl->standard_error_rad), swirl.swirl->speeds,
      swirl.options.from_speed_m_s, swirl.options.roll.alpha_m2, swirl.options.roll.beta_m, swirl.options.roll.source);
}

}  // namespace

std::vector<result::Listed> listed_swirl_fields() {
  return {result::listed("", swirl_fields), result::listed("without.set_points[], with.set_points[]", offset_fields),
          result::listed("differences[]", difference_fields)};
}

result::Document swirl_answer(const SwirlSessions& sessions, const Swirl& swirl, const result::Made& made) {
  using enum result::Readers;
  return {.kind = "tunnel report: swirl",
          .title = "Roll with and without flow straightener",
          .subtitle = sessions.without.roll.name + " and " + sessions.with.roll.name,
          .verdict = {.answer = swirl.swirl ? result::Answer::none : result::Answer::undecided,
                      .heading = "Swirl",
                      .sentence = sentence(swirl)},
          .facts = {{"alpha_and_beta", "", swirl.options.roll.source}},
          .sections = {{"Both sessions", {rates_over_time(sessions), wind_over_time(sessions)}, files},
                       {"Offset", offsets(sessions, swirl)},
                       {"Swirl", what_the_swirl_adds(swirl)},
                       {"Remarks", {result::Sentences{"remarks", swirl.remarks}}},
                       {"For programs", {result::figures("", swirl, swirl_fields)}, programs},
                       {"For programs", session("without", sessions.without, swirl.without), programs},
                       {"For programs", session("with", sessions.with, swirl.with), programs}},
          .made = made,
          .json_decimals = 8};
}

}  // namespace fantail::tunnel
