// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "fantail/compare_results.hpp"
#include "fantail/gap_curves.hpp"
#include "plot/chart.hpp"
#include "plot/page.hpp"
#include "report/numbers.hpp"

namespace fantail::tool {
namespace {

using plot::Role;
using report::degrees;

std::string figure_of(std::string_view what, std::string_view unit, std::vector<plot::Series> series, double height) {
  const plot::Chart chart{.label = fmt::format("{} over time", what),
                          .x_label = "time on A's clock / s",
                          .y_label = fmt::format("{} / {}", what, unit),
                          .height = height,
                          .series = std::move(series),
                          .least_left = 48.0};
  return plot::figure(plot::svg(chart), "");
}

std::string verdict_of(const CompareResults& results) {
  std::string text;
  for (const std::string& objection : results.objections()) {
    text += (text.empty() ? "The " : "; the ") + objection;
  }
  return text.empty() ? "The mean differences are no larger than required." : text + ".";
}

std::string sentence_on_alignment(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  std::string text = c.shift_s == 0.0 ? std::string{"Both logs are compared by their own clocks"}
                                      : fmt::format("B's clock shows {:.4f} s at A's zero", c.shift_s);
  text += results.shift_found ? ", which makes the roll rates agree best. " : c.shift_s != 0.0 ? ", as stated. " : ". ";
  if (c.offset_rad != 0.0) {
    text += fmt::format("B's angles are moved by {:.3g} deg, so that both begin alike. ", degrees(c.offset_rad));
  }
  return text + "B is read at A's times, in a straight line between two samples.";
}

}  // namespace

std::string compare_html(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  plot::Page page{.kind = "Fantail comparison of two logs", .title = "A against B"};
  page.subtitle =
      fmt::format("A: {}. B: {}. {}{:.3f} s to {:.3f} s", results.a, results.b,
                  results.window.empty() ? "" : "Window " + results.window + ", ", c.time_s.front(), c.time_s.back());
  if (results.required()) {
    const bool met = results.objections().empty();
    page.tone = met ? plot::Tone::good : plot::Tone::bad;
    page.verdict_heading = met ? "Close enough" : "Too far apart";
    page.verdict = verdict_of(results);
  }
  const auto decimals = [](double value_rad) { return fmt::format("{:.3g}", degrees(value_rad)); };
  const auto largest = [](const logs::Difference& d) { return fmt::format("at {:.3f} s", d.max_at_s); };
  const std::vector<plot::Figure> figures{
      {"Angle, mean difference", decimals(c.angle.mean_abs), "deg", "rms " + decimals(c.angle.rms) + " deg"},
      {"Angle, largest", decimals(c.angle.max_abs), "deg", largest(c.angle)},
      {"Rate, mean difference", decimals(c.rate.mean_abs), "deg/s", "rms " + decimals(c.rate.rms) + " deg/s"},
      {"Rate, largest", decimals(c.rate.max_abs), "deg/s", largest(c.rate)},
      {"Samples", std::to_string(c.time_s.size()), "",
       fmt::format("over {:.3f} s", c.time_s.back() - c.time_s.front())}};
  page.body_html = plot::section("Absolute differences", plot::figure_row(figures));

  const GapCurves curves{c.time_s};
  constexpr double tall = 280.0;
  constexpr double flat = 190.0;
  page.body_html += plot::section(
      "Roll angle",
      figure_of(
          "roll angle", "deg",
          {curves.in_degrees("A", Role::measured, c.a_angle_rad), curves.in_degrees("B", Role::model, c.b_angle_rad)},
          tall) +
          figure_of("A minus B", "deg", {curves.in_degrees("", Role::measured, c.angle_difference_rad)}, flat));
  page.body_html += plot::section(
      "Roll rate",
      figure_of(
          "roll rate", "deg/s",
          {curves.in_degrees("A", Role::measured, c.a_rate_rad_s), curves.in_degrees("B", Role::model, c.b_rate_rad_s)},
          tall) +
          figure_of("A minus B", "deg/s", {curves.in_degrees("", Role::measured, c.rate_difference_rad_s)}, flat));
  std::string how = plot::paragraph(sentence_on_alignment(results));
  if (!results.warnings.empty()) {
    how += plot::list(results.warnings);
  }
  how += plot::paragraph("Every sample is in differences.csv, every figure in compare.json, beside this page.");
  page.body_html += plot::section("How they were compared", how);
  return plot::html(page);
}

}  // namespace fantail::tool
