// SPDX-License-Identifier: MIT
#include "fantail/overlay_page.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/core.h>

#include "fantail/gap_curves.hpp"
#include "plot/chart.hpp"
#include "plot/page.hpp"
#include "report/numbers.hpp"

namespace fantail::tool {
namespace {

using plot::Role;
using report::degrees;

constexpr double tall = 280.0;
constexpr double flat = 190.0;

// What one plot shows of a log: on A's clock, and only the stretch that is compared.
struct Part {
  std::vector<double> time_s;
  std::vector<double> values;
};

Part part_of(const logs::RollLog& log, const std::vector<double>& values, double shift_s, const plot::Range& stretch) {
  Part part;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double time_s = log.time_s[i] - shift_s;
    if (time_s >= stretch.low && time_s <= stretch.high) {
      part.time_s.push_back(time_s);
      part.values.push_back(values[i]);
    }
  }
  return part;
}

bool known(const Part& part) {
  return std::ranges::any_of(part.values, [](double value) { return std::isfinite(value); });
}

std::string figure_of(std::string_view what, std::string_view unit, std::vector<plot::Series> series, double height,
                      const plot::Range& stretch) {
  const plot::Chart chart{.label = fmt::format("{} over time", what),
                          .x_label = "time on A's clock / s",
                          .y_label = fmt::format("{} / {}", what, unit),
                          .height = height,
                          .series = std::move(series),
                          .x_range = stretch,
                          .least_left = 48.0};
  return plot::figure(plot::svg(chart), "");
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
                       const logs::RollLog& b, const plot::Range& stretch) {
  const Part of_a = part_of(a, a.*quantity.values, 0.0, stretch);
  const Part of_b = part_of(b, b.*quantity.values, results.comparison.shift_s, stretch);
  std::vector<plot::Series> series;
  if (known(of_a)) {
    series.push_back(GapCurves{of_a.time_s}.curve("A", Role::measured, of_a.values, quantity.scale));
  }
  if (known(of_b)) {
    series.push_back(GapCurves{of_b.time_s}.curve("B", Role::model, of_b.values, quantity.scale));
  }
  if (series.empty()) {
    return {};
  }
  const std::string missing =
      series.size() == 2 ? "" : plot::paragraph(fmt::format("Log {} does not have it.", known(of_a) ? "B" : "A"));
  return plot::section(quantity.heading,
                       figure_of(quantity.what, quantity.unit, std::move(series), tall, stretch) + missing);
}

std::string sentence_on_alignment(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  std::string text = c.shift_s == 0.0 ? std::string{"Both flights are shown by their own clocks"}
                                      : fmt::format("B's clock shows {:.4f} s at A's zero", c.shift_s);
  text += results.shift_found ? ", which makes the roll rates agree best. " : c.shift_s != 0.0 ? ", as stated. " : ". ";
  if (c.offset_rad != 0.0) {
    text += fmt::format("B's roll angles are moved by {:.3g} deg, so that both begin alike. ", degrees(c.offset_rad));
  }
  return text + "For the differences B is read at A's times, in a straight line between two samples.";
}

}  // namespace

std::string overlay_html(const CompareResults& results, const logs::RollLog& a, const logs::RollLog& b) {
  const logs::Comparison& c = results.comparison;
  const plot::Range stretch{c.time_s.front(), c.time_s.back()};
  plot::Page page{.kind = "Fantail report of two flights", .title = "A and B"};
  page.subtitle = fmt::format("A, the broad lines: {}. B, the fine lines: {}. {:.3f} s to {:.3f} s", results.a,
                              results.b, stretch.low, stretch.high);
  const auto shown = [](double value_rad) { return fmt::format("{:.3g}", degrees(value_rad)); };
  const auto at = [](const logs::Difference& d) { return fmt::format("at {:.3f} s", d.max_at_s); };
  page.body_html = plot::section(
      "Absolute differences",
      plot::figure_row(std::vector<plot::Figure>{
          {"Angle, mean difference", shown(c.angle.mean_abs), "deg", "rms " + shown(c.angle.rms) + " deg"},
          {"Angle, largest", shown(c.angle.max_abs), "deg", at(c.angle)},
          {"Rate, mean difference", shown(c.rate.mean_abs), "deg/s", "rms " + shown(c.rate.rms) + " deg/s"},
          {"Rate, largest", shown(c.rate.max_abs), "deg/s", at(c.rate)}}));
  const GapCurves curves{c.time_s};
  const auto motion = [&](std::string_view what, std::string_view unit, const std::vector<double>& of_a,
                          const std::vector<double>& of_b, const std::vector<double>& difference) {
    return figure_of(what, unit,
                     {curves.in_degrees("A", Role::measured, of_a), curves.in_degrees("B", Role::model, of_b)}, tall,
                     stretch) +
           figure_of("A minus B", unit, {curves.in_degrees("", Role::measured, difference)}, flat, stretch);
  };
  page.body_html +=
      plot::section("Roll angle", motion("roll angle", "deg", c.a_angle_rad, c.b_angle_rad, c.angle_difference_rad));
  page.body_html +=
      plot::section("Roll rate", motion("roll rate", "deg/s", c.a_rate_rad_s, c.b_rate_rad_s, c.rate_difference_rad_s));
  const double per_radian = degrees(1.0);
  for (const Quantity& quantity :
       {Quantity{"Roll command", "roll command", "deg", &logs::RollLog::command_rad, per_radian},
        Quantity{"Canards", "mean of the encoders", "deg", &logs::RollLog::canard_rad, per_radian},
        Quantity{"Speed", "speed", "m/s", &logs::RollLog::speed_m_s, 1.0},
        Quantity{"Height", "height", "m", &logs::RollLog::height_m, 1.0}}) {
    page.body_html += section_of(quantity, results, a, b, stretch);
  }
  std::string how = plot::paragraph(sentence_on_alignment(results));
  if (!results.warnings.empty()) {
    how += plot::list(results.warnings);
  }
  how += plot::paragraph(
      "Every sample that was compared is in differences.csv, every figure in compare.json, beside "
      "this page.");
  page.body_html += plot::section("How they were laid over each other", how);
  return plot::html(page);
}

}  // namespace fantail::tool
