// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "json/value.hpp"
#include "page/chart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/stability.hpp"

namespace fantail::tunnel {
namespace {

using page::Chart;
using page::Mark;
using page::Role;
using result::Cell;
using text::fixed;
namespace u = result::units;

constexpr result::Unit per_s2{"_per_s2", "1/s2"};
constexpr result::Unit n_m_per_rad{"_n_m_per_rad", "N m/rad"};

Cell known(const Estimate& estimate) { return result::Estimate{estimate.value, reach_95 * estimate.deviation}; }
Cell known(const std::optional<Estimate>& estimate) { return estimate ? known(*estimate) : Cell{}; }

template <typename Of>
Cell of_swing(const StabilitySwing& swing, Of of) {
  return swing.result.swing ? of(*swing.result.swing) : Cell{};
}
constexpr auto swing_fields = result::fields<StabilitySwing>({
    {"speed", "speed", u::m_s, 2, &StabilitySwing::speed_m_s, "air speed"},
    {"air_unsteadiness", "unsteadiness of the air", u::percent, 2,
     [](const StabilitySwing& s) { return s.air ? Cell{s.air->share} : Cell{}; },
     "standard deviation of the air's speed over its mean; null: unknown"},
    {"begin", "from", u::s, 1, [](const StabilitySwing& s) { return Cell{s.result.stretch.begin_s}; },
     "end of the push"},
    {"end", "to", u::s, 1, [](const StabilitySwing& s) { return Cell{s.result.stretch.end_s}; },
     "end of the free swing"},
    {"grows", "grows", u::none, 0, [](const StabilitySwing& s) { return Cell{s.result.grows}; },
     "whether the swing grows: the rocket is unstable"},
    {"left_out", "left out", u::none, 0,
     [](const StabilitySwing& s) { return s.result.reason.empty() ? Cell{} : Cell{s.result.reason}; },
     "why the swing is not used; null: it is used"},
    {"largest", "largest", u::deg, 1,
     [](const StabilitySwing& s) { return of_swing(s, [](const Swing& of) { return Cell{of.largest_rad}; }); },
     "fitted angle at the beginning"},
    {"frequency", "frequency", u::rad_s, 3,
     [](const StabilitySwing& s) { return of_swing(s, [](const Swing& of) { return known(of.frequency_rad_s); }); },
     "angular frequency of the damped swing"},
    {"damping_ratio", "damping ratio", u::none, 3,
     [](const StabilitySwing& s) { return of_swing(s, [](const Swing& of) { return known(of.damping_ratio); }); },
     "share of critical damping"},
    {"logarithmic_decrement", "decrement", u::none, 3,
     [](const StabilitySwing& s) {
       return of_swing(s, [](const Swing& of) { return Cell{of.logarithmic_decrement}; });
     },
     "logarithmic decrement of two maxima on the same side"},
    {"stiffness_per_inertia", "stiffness/inertia", per_s2, 3,
     [](const StabilitySwing& s) { return of_swing(s, [](const Swing& of) { return known(of.stiffness_per_s2); }); },
     "restoring moment over angle and inertia"},
});

constexpr auto margin_fields = result::fields<Stability>({
    {"margin", "margin", u::m, 3, [](const Stability& s) { return known(s.margin_m); },
     "from the pins back to the centre of pressure; null: there is no line"},
    {"taken_by_body_lift", "taken by body lift", u::m, 3, &Stability::taken_by_body_lift_m,
     "largest part of the margin that body lift takes at the angles of these swings"},
    {"without_wind", "without wind", n_m_per_rad, 3,
     [](const Stability& s) { return known(s.without_wind_n_m_per_rad); },
     "stiffness that holds the rocket without wind"},
    {"chi_square", "chi square", u::none, 2,
     [](const Stability& s) { return s.line && s.line->chi_square ? Cell{*s.line->chi_square} : Cell{}; },
     "chi-square of the distances from the line; null for two speeds"},
});

result::Answer answer_of(StabilityVerdict verdict) {
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

std::string with_reach(const Estimate& e) {
  return fmt::format("{} ± {}", fixed(e.value, 3), fixed(reach_95 * e.deviation, 3));
}

result::Picture swing_picture(const StabilitySwing& swing, const std::string& unit) {
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
  return {chart, fmt::format("{} m/s: {} rad/s, damping ratio {}.", fixed(swing.speed_m_s, 1),
                             with_reach(s.frequency_rad_s), with_reach(s.damping_ratio))};
}

result::Picture line_picture(const Stability& stability) {
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
  return {chart, "The slope is due to the air. The value at zero speed is the stiffness without wind."};
}

std::vector<result::Block> swing_pictures(const StabilityHeading& heading, const Stability& stability) {
  std::vector<result::Block> all;
  for (const StabilitySwing& swing : stability.swings) {
    if (swing.result.swing) {
      all.emplace_back(swing_picture(swing, heading.signal == "pitch rate" ? "pitch rate / deg/s" : "pitch / deg"));
    }
  }
  return all;
}

/// swings.csv: with the standard deviation of the stiffness.
result::Table sheet(const result::Table& swings, const Stability& stability) {
  result::Table sheet = result::only(swings, {"speed", "begin", "end", "largest", "frequency", "damping_ratio",
                                              "logarithmic_decrement", "stiffness_per_inertia"});
  sheet.key = "swings";
  sheet.columns.push_back({.key = "stiffness_deviation", .unit = per_s2});
  for (std::size_t i = 0; i < sheet.rows.size(); ++i) {
    sheet.rows[i].push_back(
        of_swing(stability.swings[i], [](const Swing& of) { return Cell{of.stiffness_per_s2.deviation}; }));
  }
  return sheet;
}

}  // namespace

std::vector<result::Listed> listed_stability_fields() {
  return {result::listed("", margin_fields), result::listed("swings[]", swing_fields)};
}

result::Document stability_answer(const StabilityHeading& heading, const Stability& stability,
                                  const result::Made& made) {
  using enum result::Readers;
  constexpr int decimals = 8;
  const auto rounded = [](double value) { return json::rounded(value, decimals); };
  const result::Table swings = result::table("swings", stability.swings, swing_fields);
  const PitchAirframe& airframe = heading.airframe;
  return {.kind = "tunnel report: stability",
          .title = fmt::format("{}", fmt::join(heading.logs, ", ")),
          .subtitle = basis(heading),
          .verdict = {.answer = answer_of(stability.verdict),
                      .heading = stability.sentence.substr(0, stability.sentence.find(':')),
                      .sentence = stability.sentence},
          .facts = {{"logs", "", heading.logs},
                    {"verdict", "", name(stability.verdict)},
                    {"density_kg_m3", "", rounded(heading.density_kg_m3)},
                    {"transverse_inertia_kg_m2", "", rounded(airframe.transverse_inertia_kg_m2)},
                    {"normal_force_slope_per_rad", "", rounded(airframe.normal_force_slope_per_rad)},
                    {"cross_section_m2", "", rounded(airframe.cross_section_m2)},
                    {"mass_kg", "", rounded(airframe.mass_kg)}},
          .sections = {{"Speeds",
                        {line_picture(stability),
                         result::only(swings, {"speed", "begin", "end", "grows", "largest", "frequency",
                                               "damping_ratio", "logarithmic_decrement", "stiffness_per_inertia"}),
                         "± gives the 95 % interval."}},
                       {"Swings", swing_pictures(heading, stability), files},
                       {"Remarks", {result::Sentences{"remarks", stability.remarks}}},
                       {"For programs", {result::figures("", stability, margin_fields), swings}, programs}},
          .spreadsheets = {sheet(swings, stability)},
          .made = made,
          .json_decimals = decimals};
}

}  // namespace fantail::tunnel
