// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include <fmt/core.h>

#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/json.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using page::Series;
using text::degrees;
using text::fixed;
using text::in_degrees;

Json session(const RollSession& session, const std::vector<OffsetPoint>& points) {
  Json all = Json::array();
  for (const OffsetPoint& p : points) {
    all.push_back({{"fan_rpm", rounded(p.segment.fan_rpm)},
                   {"begin_s", rounded(p.segment.begin_s)},
                   {"end_s", rounded(p.segment.end_s)},
                   {"speed_m_s", rounded(p.speed_m_s.mean)},
                   {"speed_standard_error_m_s", rounded(p.speed_m_s.standard_error)},
                   {"roll_rate_deg_s", angle(p.rate_rad_s.mean)},
                   {"roll_rate_standard_error_deg_s", angle(p.rate_rad_s.standard_error)},
                   {"independent_samples", rounded(p.rate_rad_s.independent_samples)},
                   {"canard_deg", angle(p.canard_rad)},
                   {"offset_deg", angle(p.offset_rad)},
                   {"offset_standard_error_deg", angle(p.standard_error_rad)}});
  }
  return {{"log", session.roll.name}, {"wind", session.wind.name}, {"set_points", all}};
}

std::string curve(const char* title, const RollSession& session, const std::vector<OffsetPoint>& points) {
  std::string text =
      fmt::format("{}: {}\n      speed          roll rate               offset\n", title, session.roll.name);
  for (const OffsetPoint& p : points) {
    text += fmt::format("  {:6.2f} m/s  {:8.2f} +- {:.2f} deg/s   {:7.3f} +- {:.3f} deg\n", p.speed_m_s.mean,
                        degrees(p.rate_rad_s.mean), degrees(p.rate_rad_s.standard_error), degrees(p.offset_rad),
                        degrees(p.standard_error_rad));
  }
  return text + "\n";
}

constexpr const char* sign_sentence =
    "Above zero it rolls the rocket as positive canard angles do: clockwise, seen from the tail. fantail predict takes "
    "it "
    "with this sign, as --swirl.";
constexpr const char* without_name = "without straightener";
constexpr const char* with_name = "with straightener";

std::string for_print(std::string sentence) {
  for (std::size_t place = sentence.find("+-"); place != std::string::npos; place = sentence.find("+-")) {
    sentence.replace(place, 2, "\u00b1");
  }
  return sentence;
}

std::string rates_over_time(const SwirlSessions& sessions) {
  const auto& a = sessions.without.roll;
  const auto& b = sessions.with.roll;
  const Chart chart{
      .label = "Roll rate over time, with and without flow straightener",
      .x_label = "time / s",
      .y_label = "roll rate / deg/s",
      .series = {{.name = without_name, .x = a.time_s, .y = in_degrees(a.roll_rate_rad_s)},
                 {.name = with_name, .role = Role::second_model, .x = b.time_s, .y = in_degrees(b.roll_rate_rad_s)}}};
  return page::figure(chart, "Roll rate over time, the canards at zero.");
}

Series wind_series(const TunnelLog& wind, const char* name, Role role) {
  return {.name = name, .role = role, .x = wind.time_s, .y = wind.wind_speed_m_s};
}

std::string wind_over_time(const SwirlSessions& sessions) {
  Chart chart{.label = "Wind speed over time in both sessions",
              .x_label = "time / s",
              .y_label = "wind speed / m/s",
              .series = {wind_series(sessions.without.wind, without_name, Role::measured),
                         wind_series(sessions.with.wind, with_name, Role::second_model)}};
  for (const SteadySegment& segment : sessions.without.steady.found) {
    chart.shaded_ranges.push_back({segment.begin_s, segment.end_s, segment.fan_rpm ? fixed(*segment.fan_rpm, 0) : ""});
  }
  return page::figure(chart,
                      "Wind speed over time. Shaded: where it was steady without the straightener, with the fan's set "
                      "point in rpm.");
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

std::string against_speed(const Swirl& swirl, const char* label, const char* y_label, const char* caption,
                          double (*value)(const OffsetPoint&)) {
  return page::figure({.label = label,
                       .x_label = "mean wind speed / m/s",
                       .y_label = y_label,
                       .width = page::half_page,
                       .series = {over_speed(swirl.without, without_name, Role::measured, value),
                                  over_speed(swirl.with, with_name, Role::second_model, value)}},
                      caption);
}

std::string difference(const Swirl& swirl) {
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
  return page::figure(chart, "Offset due to swirl: without minus with straightener.");
}

std::string points_table(const Swirl& swirl) {
  static const std::array<page::Column, 5> columns{{{"straightener"},
                                                    {"fan / rpm", true},
                                                    {"speed / m/s", true},
                                                    {"roll rate \u00b1 standard error / deg/s", true},
                                                    {"offset \u00b1 standard error / deg", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const auto& [points, word] : {std::pair{&swirl.without, "without"}, std::pair{&swirl.with, "with"}}) {
    for (const OffsetPoint& p : *points) {
      rows.push_back(
          {{word},
           {p.segment.fan_rpm ? fixed(*p.segment.fan_rpm, 0) : "-"},
           {fixed(p.speed_m_s.mean, 2)},
           {fmt::format("{} \u00b1 {}", fixed(degrees(p.rate_rad_s.mean), 2),
                        fixed(degrees(p.rate_rad_s.standard_error), 2))},
           {fmt::format("{} \u00b1 {}", fixed(degrees(p.offset_rad), 3), fixed(degrees(p.standard_error_rad), 3))}});
    }
  }
  return page::table(columns, rows);
}

}  // namespace

std::string swirl_sentence(const Swirl& swirl) {
  if (!swirl.swirl) {
    return fmt::format("The sessions share no speed of {:g} m/s or more: the swirl is unknown.",
                       swirl.options.from_speed_m_s);
  }
  return fmt::format(
      "The swirl equals {:.3f} +- {:.3f} deg of canard angle (mean over {} speeds from {:g} m/s on; +- is its standard "
      "error), with alpha {:g} m2 and beta {:g} m, {}.",
      degrees(swirl.swirl->offset_rad), degrees(swirl.swirl->standard_error_rad), swirl.swirl->speeds,
      swirl.options.from_speed_m_s, swirl.options.roll.alpha_m2, swirl.options.roll.beta_m, swirl.options.roll.source);
}

std::string swirl_text(const SwirlSessions& sessions, const Swirl& swirl) {
  std::string text = swirl_sentence(swirl) + "\n";
  text += swirl.swirl ? fmt::format("{}\n\n", sign_sentence) : "\n";
  text += curve("without flow straightener", sessions.without, swirl.without);
  text += curve("with flow straightener", sessions.with, swirl.with);
  text += "difference: offset due to the swirl\n";
  for (const OffsetDifference& d : swirl.differences) {
    text += fmt::format("  {:6.2f} m/s  {:7.3f} +- {:.3f} deg{}\n", d.speed_m_s, degrees(d.difference_rad),
                        degrees(d.standard_error_rad), d.counted ? "" : "   not counted");
  }
  text += fmt::format(
      "\nOffsets are alpha p / (beta v) with alpha {:g} m2 and beta {:g} m, minus the mean canard angle. An error of\n"
      "these two scales both curves and the difference; the +- are standard errors and do not include it.\n",
      swirl.options.roll.alpha_m2, swirl.options.roll.beta_m);
  for (const std::string& remark : swirl.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string swirl_json(const SwirlSessions& sessions, const Swirl& swirl, const result::Made& made) {
  Json differences = Json::array();
  for (const OffsetDifference& d : swirl.differences) {
    differences.push_back({{"speed_m_s", rounded(d.speed_m_s)},
                           {"without_deg", angle(d.without_rad)},
                           {"with_deg", angle(d.with_rad)},
                           {"difference_deg", angle(d.difference_rad)},
                           {"standard_error_deg", angle(d.standard_error_rad)},
                           {"counted", d.counted}});
  }
  const auto of_mean = [&swirl](double SwirlOffset::* value) {
    return swirl.swirl ? angle(*swirl.swirl.*value) : Json{};
  };
  const bool has_deviation = swirl.swirl && swirl.swirl->deviation_rad;
  Json all = {{"swirl_deg", of_mean(&SwirlOffset::offset_rad)},
              {"swirl_standard_error_deg", of_mean(&SwirlOffset::standard_error_rad)},
              {"swirl_deviation_deg", has_deviation ? angle(*swirl.swirl->deviation_rad) : Json{}},
              {"from_speed_m_s", rounded(swirl.options.from_speed_m_s)},
              {"alpha_m2", rounded(swirl.options.roll.alpha_m2)},
              {"beta_m", rounded(swirl.options.roll.beta_m)},
              {"alpha_and_beta", swirl.options.roll.source},
              {"without", session(sessions.without, swirl.without)},
              {"with", session(sessions.with, swirl.with)},
              {"differences", differences},
              {"remarks", swirl.remarks}};
  result::put_answer(all, swirl.swirl ? result::Answer::none : result::Answer::undecided, swirl_sentence(swirl), made);
  return all.pretty();
}

std::string swirl_html(const SwirlSessions& sessions, const Swirl& swirl) {
  const std::array<std::string, 2> curves{
      against_speed(swirl, "Mean steady roll rate against wind speed", "roll rate / deg/s",
                    "Mean steady roll rate against wind speed.",
                    [](const OffsetPoint& p) { return p.rate_rad_s.mean; }),
      against_speed(swirl, "Equivalent fin offset against wind speed", "offset / deg",
                    "Equivalent fin offset against wind speed.", [](const OffsetPoint& p) { return p.offset_rad; })};
  std::string body = page::section("Both sessions", rates_over_time(sessions) + wind_over_time(sessions));
  body += page::section("Offset", page::side_by_side(curves) + points_table(swirl));
  body += page::section(
      "Swirl",
      difference(swirl) + (swirl.swirl ? page::paragraph(sign_sentence) : "") +
          page::paragraph(fmt::format(
              "Offsets are alpha p / (beta v) with alpha {:g} m2 and beta {:g} m, minus the mean canard angle. An "
              "error of these two scales both curves and the difference; standard errors come from the scatter of the "
              "samples and do not include it.",
              swirl.options.roll.alpha_m2, swirl.options.roll.beta_m)));
  if (!swirl.remarks.empty()) {
    body += page::section("Remarks", page::list(swirl.remarks));
  }
  return page::html({.kind = "Fantail tunnel report: swirl",
                     .title = "Roll with and without flow straightener",
                     .subtitle = sessions.without.roll.name + " and " + sessions.with.roll.name,
                     .tone = swirl.swirl ? page::Tone::plain : page::Tone::unsure,
                     .verdict_heading = "Swirl",
                     .verdict = for_print(swirl_sentence(swirl)),
                     .body_html = body});
}

}  // namespace fantail::tunnel
