// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"
#include "tunnel/json.hpp"
#include "tunnel/stability.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using text::fixed;

result::Answer answer(StabilityVerdict verdict) {
  return verdict == StabilityVerdict::stable     ? result::Answer::yes
         : verdict == StabilityVerdict::unstable ? result::Answer::no
                                                 : result::Answer::undecided;
}

std::string name(StabilityVerdict verdict) {
  switch (verdict) {
    case StabilityVerdict::stable: return "stable";
    case StabilityVerdict::unstable: return "unstable";
    case StabilityVerdict::unsure: break;
  }
  return "not_judged";
}

std::string basis(const StabilityHeading& h) {
  return fmt::format(
      "{} over time; density {} kg/m3; {}: transverse inertia {} kg m2, normal force slope {} per rad on {} m2, mass "
      "{} "
      "kg",
      h.signal, text::brief(h.density_kg_m3, 4), h.airframe_source, text::brief(h.airframe.transverse_inertia_kg_m2, 4),
      text::brief(h.airframe.normal_force_slope_per_rad, 4), text::brief(h.airframe.cross_section_m2, 6),
      text::brief(h.airframe.mass_kg, 4));
}

Json estimate(const std::optional<Estimate>& e) {
  return e ? Json{{"value", rounded(e->value)},
                  {"low_95", rounded(e->value - reach_95 * e->deviation)},
                  {"high_95", rounded(e->value + reach_95 * e->deviation)}}
           : Json{};
}

std::string with_reach(const Estimate& e, int decimals) {
  return fmt::format("{} ± {}", fixed(e.value, decimals), fixed(reach_95 * e.deviation, decimals));
}

std::string swing_figure(const StabilitySwing& swing, const std::string& unit) {
  const Swing& s = *swing.result.swing;
  const auto in_degrees = [](std::vector<double> values) {
    std::ranges::transform(values, values.begin(), [](double value) { return text::degrees(value); });
    return values;
  };
  const Chart chart{.label = fmt::format("Swing at {} m/s", fixed(swing.speed_m_s, 1)),
                    .x_label = "time / s",
                    .y_label = unit,
                    .height = 200.0,
                    .series = {{.name = "measured", .role = Role::measured, .x = s.time_s, .y = in_degrees(s.measured)},
                               {.name = "fitted", .role = Role::model, .x = s.time_s, .y = in_degrees(s.fitted)}},
                    .sampled = true};
  return page::figure(chart, fmt::format("{} m/s: {} rad/s, damping ratio {}.", fixed(swing.speed_m_s, 1),
                                         with_reach(s.frequency_rad_s, 3), with_reach(s.damping_ratio, 3)));
}

std::string line_figure(const Stability& stability) {
  Chart chart{.label = "Stiffness over inertia against the square of the speed",
              .x_label = "speed squared / m2/s2",
              .y_label = "stiffness over inertia / 1/s2",
              .series = {{.name = "swings", .mark = Mark::points}}};
  double fastest = 0.0;
  for (const StabilitySwing& swing : stability.swings) {
    if (swing.result.swing) {
      const double square = swing.speed_m_s * swing.speed_m_s;
      fastest = std::max(fastest, square);
      chart.series[0].x.push_back(square);
      chart.series[0].y.push_back(swing.result.swing->stiffness_per_s2.value);
    }
  }
  if (stability.line) {
    const double at_rest = stability.line->intercept_per_s2.value;
    chart.series.push_back({.name = "line",
                            .role = Role::model,
                            .x = {0.0, fastest},
                            .y = {at_rest, at_rest + fastest * stability.line->slope_per_m2.value}});
  }
  return page::figure(chart,
                      "The slope is the air's; where the line meets zero speed is what holds the rocket without wind.");
}

std::vector<std::vector<std::string>> cells(const Stability& stability) {
  std::vector<std::vector<std::string>> rows;
  for (const StabilitySwing& swing : stability.swings) {
    const SwingStretch& stretch = swing.result.stretch;
    std::vector<std::string> row{fixed(swing.speed_m_s, 2),
                                 fmt::format("{} to {}", fixed(stretch.begin_s, 1), fixed(stretch.end_s, 1))};
    if (const auto& s = swing.result.swing) {
      row.insert(row.end(), {fixed(text::degrees(s->largest_rad), 1), with_reach(s->frequency_rad_s, 3),
                             with_reach(s->damping_ratio, 3), fixed(s->logarithmic_decrement, 3),
                             with_reach(s->stiffness_per_s2, 3)});
    } else {
      row.insert(row.end(), {"", swing.result.grows ? "grows" : "left out", "", "", ""});
    }
    rows.push_back(row);
  }
  return rows;
}

}  // namespace

std::string stability_text(const StabilityHeading& heading, const Stability& stability, std::size_t columns) {
  std::string text = fmt::format("{}\n{}\n\n{}\n\n", fmt::join(heading.logs, ", "), stability.sentence, basis(heading));
  text::Table table{{{"speed"},
                     {"swing"},
                     {"from", 2},
                     {"frequency"},
                     {"damping"},
                     {"logarithmic decrement", 1},
                     {"stiffness/inertia", 3}}};
  const auto add = [&table](const std::vector<std::string>& row) {
    constexpr std::array<std::size_t, 7> widths{9, 16, 7, 18, 16, 10, 20};
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const std::string blanks(widths[i] - std::min(widths[i], text::display_width(row[i])), ' ');
      cells.push_back(fmt::format("{}{}{}", i == 0 ? "" : " ", blanks, row[i]));
    }
    table.row(cells);
  };
  add({"speed", "swing", "from", "frequency", "damping", "log.", "stiffness/inertia"});
  add({"m/s", "s", "deg", "rad/s", "ratio", "decrement", "1/s2"});
  for (const auto& row : cells(stability)) {
    add(row);
  }
  text += table.text(columns);
  text += "\nA figure behind ± is the reach of its 95 % interval.\n";
  for (const std::string& remark : stability.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string stability_json(const StabilityHeading& heading, const Stability& stability, const result::Made& made) {
  Json swings = Json::array();
  for (const StabilitySwing& swing : stability.swings) {
    const auto& s = swing.result.swing;
    swings.push_back({{"speed_m_s", rounded(swing.speed_m_s)},
                      {"air_unsteadiness", swing.air ? Json(rounded(swing.air->share)) : Json{}},
                      {"begin_s", rounded(swing.result.stretch.begin_s)},
                      {"end_s", rounded(swing.result.stretch.end_s)},
                      {"grows", swing.result.grows},
                      {"left_out", swing.result.reason.empty() ? Json{} : Json(swing.result.reason)},
                      {"largest_deg", s ? Json(rounded(text::degrees(s->largest_rad))) : Json{}},
                      {"frequency_rad_s", s ? estimate(s->frequency_rad_s) : Json{}},
                      {"damping_ratio", s ? estimate(s->damping_ratio) : Json{}},
                      {"logarithmic_decrement", s ? Json(rounded(s->logarithmic_decrement)) : Json{}},
                      {"stiffness_per_inertia_per_s2", s ? estimate(s->stiffness_per_s2) : Json{}}});
  }
  Json all = {{"logs", heading.logs},
              {"verdict", name(stability.verdict)},
              {"sentence", stability.sentence},
              {"density_kg_m3", rounded(heading.density_kg_m3)},
              {"transverse_inertia_kg_m2", rounded(heading.airframe.transverse_inertia_kg_m2)},
              {"normal_force_slope_per_rad", rounded(heading.airframe.normal_force_slope_per_rad)},
              {"cross_section_m2", rounded(heading.airframe.cross_section_m2)},
              {"mass_kg", rounded(heading.airframe.mass_kg)},
              {"margin_m", estimate(stability.margin_m)},
              {"taken_by_body_lift_m", rounded(stability.taken_by_body_lift_m)},
              {"without_wind_n_m_per_rad", estimate(stability.without_wind_n_m_per_rad)},
              {"chi_square", stability.line ? Json(rounded(stability.line->chi_square)) : Json{}},
              {"swings", swings},
              {"remarks", stability.remarks}};
  result::put_answer(all, answer(stability.verdict), stability.sentence, made);
  return all.pretty();
}

std::string stability_csv(const Stability& stability) {
  std::string csv =
      "speed_m_s,begin_s,end_s,largest_deg,frequency_rad_s,damping_ratio,logarithmic_decrement,stiffness_per_inertia_"
      "per_s2,"
      "stiffness_deviation_per_s2\n";
  for (const StabilitySwing& swing : stability.swings) {
    const auto& s = swing.result.swing;
    csv +=
        fmt::format("{:.4f},{:.3f},{:.3f},", swing.speed_m_s, swing.result.stretch.begin_s, swing.result.stretch.end_s);
    csv += s ? fmt::format("{:.4f},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", text::degrees(s->largest_rad),
                           s->frequency_rad_s.value, s->damping_ratio.value, s->logarithmic_decrement,
                           s->stiffness_per_s2.value, s->stiffness_per_s2.deviation)
             : std::string{",,,,,\n"};
  }
  return csv;
}

std::string stability_html(const StabilityHeading& heading, const Stability& stability) {
  static const std::array<page::Column, 7> columns{{{"speed, m/s", true},
                                                    {"swing, s", true},
                                                    {"from, deg", true},
                                                    {"frequency, rad/s", true},
                                                    {"damping ratio", true},
                                                    {"decrement", true},
                                                    {"stiffness / I, 1/s\u00b2", true}}};
  std::vector<std::vector<page::Cell>> rows;
  for (const auto& row : cells(stability)) {
    std::vector<page::Cell>& out = rows.emplace_back();
    // The interval goes below its figure, or the table is wider than the page.
    std::ranges::transform(row, std::back_inserter(out), [](const std::string& cell) {
      const std::size_t sign = cell.find(" ±");
      return sign == std::string::npos ? page::Cell{cell}
                                       : page::Cell{.text = cell.substr(0, sign), .below = cell.substr(sign + 1)};
    });
  }
  std::string body = page::section(
      "Speeds", line_figure(stability) + page::table(columns, rows) +
                    page::note("A figure behind ± is the reach of its 95 % interval. " + basis(heading) + "."));
  std::string swings;
  for (const StabilitySwing& swing : stability.swings) {
    if (swing.result.swing) {
      swings += swing_figure(swing, heading.signal == "pitch rate" ? "pitch rate / deg/s" : "pitch / deg");
    }
  }
  if (!swings.empty()) {
    body += page::section("Swings", swings);
  }
  if (!stability.remarks.empty()) {
    body += page::section("Remarks", page::list(stability.remarks));
  }
  const page::Page page{.kind = "Fantail tunnel report: stability",
                        .title = fmt::format("{}", fmt::join(heading.logs, ", ")),
                        .tone = result::tone(answer(stability.verdict)),
                        .verdict_heading = stability.verdict == StabilityVerdict::stable     ? "Stable"
                                           : stability.verdict == StabilityVerdict::unstable ? "Unstable"
                                                                                             : "Not judged",
                        .verdict = stability.sentence,
                        .body_html = body};
  return page::html(page);
}

}  // namespace fantail::tunnel
