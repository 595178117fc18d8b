// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "fantail/compare_results.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"

namespace fantail::tool {
namespace {

using page::Role;
using text::degrees;
using text::in_degrees;

page::Series curve(std::string name, Role role, const std::vector<double>& time_s, std::vector<double> values) {
  return {.name = std::move(name), .role = role, .x = time_s, .y = std::move(values)};
}

std::string figure_of(std::string_view what, std::string_view unit, double height, std::vector<page::Series> series,
                      const page::Range& stretch) {
  return page::figure({.label = fmt::format("{} over time", what),
                       .x_label = "time on A's clock / s",
                       .y_label = fmt::format("{} / {}", what, unit),
                       .height = height,
                       .series = std::move(series),
                       .x_range = stretch,
                       .sampled = true,
                       .least_left = 48.0});
}

constexpr double tall = 280.0;
constexpr double flat = 190.0;

page::Range stretch_of(const logs::Comparison& c) { return {c.time_s.front(), c.time_s.back()}; }

std::string motion(std::string_view heading, std::string_view what, std::string_view unit, const logs::Comparison& c,
                   const std::vector<double>& of_a, const std::vector<double>& of_b,
                   const std::vector<double>& difference) {
  return page::section(
      heading, figure_of(what, unit, tall,
                         {curve("A", Role::measured, c.time_s, in_degrees(of_a)),
                          curve("B", Role::model, c.time_s, in_degrees(of_b))},
                         stretch_of(c)) +
                   figure_of("A minus B", unit, flat, {curve("", Role::measured, c.time_s, in_degrees(difference))},
                             stretch_of(c)));
}

std::string both_motions(const logs::Comparison& c) {
  return motion("Roll angle", "roll angle", "deg", c, c.a_angle_rad, c.b_angle_rad, c.angle_difference_rad) +
         motion("Roll rate", "roll rate", "deg/s", c, c.a_rate_rad_s, c.b_rate_rad_s, c.rate_difference_rad_s);
}

std::vector<page::Figure> differences(const logs::Comparison& c) {
  const auto angle_text = [](double value_rad) { return fmt::format("{:.3g}", degrees(value_rad)); };
  const auto at = [](const logs::Difference& d) { return fmt::format("at {:.3f} s", d.max_at_s); };
  return {{"Angle, mean difference", angle_text(c.angle.mean_abs), "deg", "rms " + angle_text(c.angle.rms) + " deg"},
          {"Angle, largest", angle_text(c.angle.max_abs), "deg", at(c.angle)},
          {"Rate, mean difference", angle_text(c.rate.mean_abs), "deg/s", "rms " + angle_text(c.rate.rms) + " deg/s"},
          {"Rate, largest", angle_text(c.rate.max_abs), "deg/s", at(c.rate)}};
}

std::string how(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  std::string text = c.shift_s == 0.0 ? "Both logs are compared by their own clocks"
                                      : fmt::format("B's clock shows {:.4f} s at A's zero", c.shift_s);
  text += results.shift_found ? ", which makes the roll rates agree best. " : c.shift_s != 0.0 ? ", as stated. " : ". ";
  if (c.offset_rad != 0.0) {
    text += fmt::format("B's roll angles are moved by {:.3g} deg, so that both begin alike. ", degrees(c.offset_rad));
  }
  text += "For the differences B is read at A's times, in a straight line between two samples.";
  return page::section(
      "How they were compared",
      page::paragraph(text) + (results.warnings.empty() ? "" : page::list(results.warnings)) +
          page::paragraph("Every sample that was compared is in differences.csv, every figure in compare.json, beside "
                          "this page."));
}

std::string verdict_of(const CompareResults& results) {
  std::string text;
  for (const std::string& objection : results.objections()) {
    text += (text.empty() ? "The " : "; the ") + objection;
  }
  return text.empty() ? "The mean differences are no larger than required." : text + ".";
}

struct Quantity {
  std::string_view heading;
  std::string_view what;
  std::string_view unit;
  std::vector<double> logs::RollLog::* values;
  double scale;
};

// A log that does not have the quantity is left out; so is the plot when none has it.
std::string section_of(const Quantity& quantity, const CompareResults& results, const logs::RollLog& a,
                       const logs::RollLog& b) {
  const page::Range stretch = stretch_of(results.comparison);
  std::vector<page::Series> series;
  const auto add = [&](const char* name, Role role, const logs::RollLog& log, double shift_s) {
    page::Series one = curve(name, role, log.time_s, log.*quantity.values);
    bool known = false;
    for (std::size_t i = 0; i < one.y.size(); ++i) {
      one.x[i] -= shift_s;
      one.y[i] *= quantity.scale;
      known = known || (std::isfinite(one.y[i]) && one.x[i] >= stretch.low && one.x[i] <= stretch.high);
    }
    if (known) {
      series.push_back(std::move(one));
    }
  };
  add("A", Role::measured, a, 0.0);
  add("B", Role::model, b, results.comparison.shift_s);
  if (series.empty()) {
    return {};
  }
  const std::string missing =
      series.size() == 2
          ? ""
          : page::paragraph(fmt::format("Log {} does not have it.", series.front().name == "A" ? "B" : "A"));
  return page::section(quantity.heading,
                       figure_of(quantity.what, quantity.unit, tall, std::move(series), stretch) + missing);
}

}  // namespace

std::string compare_html(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  page::Page page{.kind = "Fantail comparison of two logs", .title = "A against B"};
  page.subtitle =
      fmt::format("A: {}. B: {}. {}{:.3f} s to {:.3f} s", results.a, results.b,
                  results.window.empty() ? "" : "Window " + results.window + ", ", c.time_s.front(), c.time_s.back());
  if (results.required()) {
    const bool met = results.objections().empty();
    page.tone = met ? page::Tone::good : page::Tone::bad;
    page.verdict_heading = met ? "Close enough" : results.is_known() ? "Too far apart" : "Too little to compare";
    page.verdict = verdict_of(results);
  }
  std::vector<page::Figure> figures = differences(c);
  figures.push_back({"Samples", std::to_string(c.time_s.size()), "",
                     fmt::format("over {:.3f} s", c.time_s.back() - c.time_s.front())});
  page.body_html = page::section("Absolute differences", page::figure_row(figures)) + both_motions(c) + how(results);
  return page::html(page);
}

std::string overlay_html(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b) {
  const logs::Comparison& c = results.comparison;
  page::Page page{.kind = "Fantail report of two flights", .title = "A and B"};
  page.subtitle = fmt::format("A, the broad lines: {}. B, the fine lines: {}. {:.3f} s to {:.3f} s", results.a,
                              results.b, c.time_s.front(), c.time_s.back());
  page.body_html = page::section("Absolute differences", page::figure_row(differences(c))) + both_motions(c);
  const double per_radian = degrees(1.0);
  for (const Quantity& quantity :
       {Quantity{"Roll command", "roll command", "deg", &logs::RollLog::command_rad, per_radian},
        Quantity{"Canards", "mean of the encoders", "deg", &logs::RollLog::canard_rad, per_radian},
        Quantity{"Speed, as the avionics estimated it", "speed", "m/s", &logs::RollLog::speed_m_s, 1.0},
        Quantity{"Height", "height", "m", &logs::RollLog::height_m, 1.0}}) {
    page.body_html += section_of(quantity, results, a, b);
  }
  page.body_html += how(results);
  return page::html(page);
}

}  // namespace fantail::tool
