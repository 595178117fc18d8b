// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "identify/result/charts.hpp"
#include "identify/result/formatting.hpp"
#include "identify/result/joint_outputs.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using text::degrees;

std::string figures(const JointFindings& f) {
  return page::figure_row(std::vector<page::Figure>{{"damping alpha", text::brief(f.together.value(0), 2), "m\u00b2",
                                                     "95 %: " + interval_text(interval_of(f.together, 0))},
                                                    {"torque constant beta", text::brief(f.together.value(1), 2), "m",
                                                     "95 %: " + interval_text(interval_of(f.together, 1))},
                                                    {"chi-square", text::fixed(f.agreement.chi_square, 1), "",
                                                     fmt::format("95 % below {}", text::fixed(f.agreement.limit, 1))}});
}

std::string table(const JointFindings& f) {
  const std::vector<page::Column> columns{{"window (\u00b1: standard deviation)", false},
                                          {"alpha / m\u00b2", true},
                                          {"beta / m", true},
                                          {"share", true},
                                          {"angle error / deg", true}};
  const auto error = [](const Identification& result) {
    return text::fixed(degrees(result.simulation.mean_abs_angle_error_rad), 3);
  };
  const auto below = [](const Interval& interval) { return "95 %: " + interval_text(interval); };
  std::vector<std::vector<page::Cell>> rows;
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const JointWindow& window = f.windows[i];
    const auto own = [&](std::size_t number) {
      return page::Cell{.text = printable(with_deviation(window.own, number)),
                        .below = below(interval_of(window.own, number))};
    };
    rows.push_back({{fmt::format("{}: {}", i + 1, name(window))},
                    own(0),
                    own(1),
                    {text::fixed(100.0 * window.information_share, 0) + " %"},
                    {.text = error(window.own), .below = "in common: " + error(window.window.results.front())}});
  }
  const auto common = [&](Eigen::Index k) {
    const Constants& c = f.together;
    return page::Cell{.text = printable(value_with_deviation(c.value(k), std::sqrt(c.covariance(k, k)))),
                      .below = below(interval_of(c, k))};
  };
  rows.push_back({{"in common"}, common(0), common(1), {"100 %"}, {""}});
  return page::table(columns, rows);
}

/// What each window says by itself, and the common interval behind it.
page::Chart beside_each_other(const JointFindings& f, std::size_t number) {
  page::Chart chart;
  chart.label = number == 0 ? "alpha of each window and in common" : "beta of each window and in common";
  chart.x_label = "window";
  chart.y_label = number == 0 ? "alpha / m\u00b2" : "beta / m";
  chart.width = page::half_page;
  chart.equal_x_ticks_at_points = true;
  const double last = static_cast<double>(f.windows.size()) + 0.5;
  const Interval common = interval_of(f.together, static_cast<Eigen::Index>(number));
  page::Series points{.name = "by itself", .role = page::Role::measured, .mark = page::Mark::points};
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const auto x = static_cast<double>(i + 1);
    const Identification& own = f.windows[i].own;
    points.x.push_back(x);
    points.y.push_back(own.model.numbers()[number]);
    const Interval& interval = own.uncertainty->interval[number];
    chart.areas.push_back({.name = i == 0 ? "its 95 %" : "",
                           .role = page::Role::measured,
                           .x = {x - 0.06, x + 0.06},
                           .low = {*interval.low, *interval.low},
                           .high = {*interval.high, *interval.high}});
  }
  chart.areas.push_back({.name = "in common, 95 %",
                         .role = page::Role::model,
                         .x = {0.5, last},
                         .low = {*common.low, *common.low},
                         .high = {*common.high, *common.high}});
  chart.series.push_back(std::move(points));
  chart.x_range = page::Range{0.5, last};
  return chart;
}

std::string remark_list(const JointFindings& f) {
  std::vector<std::string> all = f.warnings;
  for (const JointWindow& window : f.windows) {
    for (const std::string& remark : remarks(window.window, window.own)) {
      all.push_back(fmt::format("{}: {}", name(window), remark));
    }
  }
  return all.empty() ? "" : page::section("Remarks", page::list(all));
}

}  // namespace

std::string as_html(const JointFindings& f) {
  page::Page page;
  page.kind = "Fantail identification report";
  page.title = fmt::format("{} windows, one roll model", f.windows.size());
  page.subtitle = printable(fmt::format("{}; density {}; speed {}", f.vehicle, f.density, f.speed));
  page.tone = fantail::result::tone(answer(f));
  page.verdict_heading = heading_of(f);
  for (const std::string& sentence : conclusions(f)) {
    page.verdict += (page.verdict.empty() ? "" : " ") + sentence;
  }
  page.body_html = page::section("The roll model", figures(f) + table(f) +
                                                       page::note("Each window has a disturbance, a first angle and a "
                                                                  "first rate of its own. Share: of what is known of "
                                                                  "alpha and beta."));
  page.body_html += page::section(
      "Each window by itself",
      page::side_by_side(std::vector{page::figure(beside_each_other(f, 0)), page::figure(beside_each_other(f, 1))}));
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const WindowFindings& window = f.windows[i].window;
    page.body_html +=
        page::section(fmt::format("{}: {}", i + 1, name(f.windows[i])),
                      page::paragraph(extent(window.record)) + page::figure(motion_chart(window, Motion::angle)) +
                          page::side_by_side(std::vector{page::figure(residual_chart(window, Motion::angle)),
                                                         page::figure(residual_chart(window, Motion::rate))}));
  }
  page.body_html += remark_list(f);
  return page::html(page);
}

}  // namespace fantail::identify::result
