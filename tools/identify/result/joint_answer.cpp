// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include "identify/result/answer.hpp"
#include "identify/result/parts.hpp"
#include "identify/result/residual.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using text::brief;
using text::fixed;
using J = JointFindings;
using W = JointWindow;

std::string name(const W& window) { return window.data + ", " + window.window.record.window; }

std::ptrdiff_t doubtful_windows(const J& f) {
  return std::ranges::count_if(f.windows, [](const W& w) { return misfit(w.window.record, w.own).has_value(); });
}

std::string heading_of(const J& f) {
  if (!f.determines_both()) {
    return "Together these windows do not determine both damping and torque";
  }
  if (!f.are_of_one_rocket()) {
    return "These windows disagree about damping and torque";
  }
  return doubtful_windows(f) > 0 ? "These windows agree, but the model does not fit them well"
                                 : "These windows agree on one damping and one torque";
}

template <Eigen::Index which>
double deviation(const J& f) {
  return std::sqrt(f.together.covariance(which, which));
}
template <Eigen::Index which>
Cell together(const J& f) {
  return output::Uncertain{f.together.value(which), deviation<which>(f)};
}
double correlation(const J& f) { return f.together.covariance(0, 1) / (deviation<0>(f) * deviation<1>(f)); }

constexpr auto joint_fields = output::fields<J>({
    {"alpha", "damping alpha", u::m2, 4, together<0>, "damping of all windows"},
    {"beta", "torque constant beta", u::m, 4, together<1>, "canard torque of all windows"},
    {"alpha_sd", "its standard deviation", u::m2, 4, [](const J& f) { return Cell{deviation<0>(f)}; },
     "standard deviation of alpha"},
    {"beta_sd", "its standard deviation", u::m, 4, [](const J& f) { return Cell{deviation<1>(f)}; },
     "standard deviation of beta"},
    {"alpha_beta_correlation", "their correlation", u::none, 2, [](const J& f) { return Cell{correlation(f)}; },
     "correlation of the two"},
    {"degrees_of_freedom", "degrees of freedom", u::none, 0,
     [](const J& f) { return Cell{f.together.degrees_of_freedom}; },
     "of the Student distribution used for the intervals"},
    {"alpha_interval", "95 % of alpha", u::m2, 4, [](const J& f) { return Cell{interval_of(f.together, 0)}; },
     "95 % interval of alpha"},
    {"beta_interval", "95 % of beta", u::m, 4, [](const J& f) { return Cell{interval_of(f.together, 1)}; },
     "95 % interval of beta"},
    {"chi_square", "chi-square", u::none, 1, [](const J& f) { return Cell{f.agreement.chi_square}; },
     "distance of the windows, each fitted alone, from their common mean"},
    {"chi_square_limit", "95 % below", u::none, 1, [](const J& f) { return Cell{f.agreement.limit}; },
     "sets of windows of one rocket are below it in 95 of 100 cases"},
    {"agree", "agree", u::none, 0, [](const J& f) { return Cell{f.agreement.agree()}; }, "whether they agree"},
    {"verdict", "verdict", u::none, 0, [](const J& f) { return Cell{heading_of(f)}; }, "the heading of the answer"},
    {"inertia", "roll inertia", kg_m2, 5, [](const J& f) { return Cell{f.airframe.inertia_kg_m2}; },
     "roll inertia of the first window"},
    {"reference_area", "reference area", u::m2, 7, [](const J& f) { return Cell{f.airframe.reference_area_m2}; },
     "reference area of all"},
});

template <std::size_t which>
Cell own(const W& w) {
  return uncertain(w.own, which);
}
template <std::size_t which>
Cell own_interval(const W& w) {
  return interval_of(w.own, which);
}
constexpr auto window_fields = output::fields<W>({
    {"data", "log", u::none, 0, &W::data, "the log"},
    {"window", "window", u::none, 0, [](const W& w) { return Cell{w.window.record.window}; },
     "the window as requested"},
    {"samples", "samples", u::none, 0, [](const W& w) { return Cell{std::uint64_t{w.own.samples}}; },
     "samples in the window"},
    {"information", "share of the information", u::share, 0, &W::information_share,
     "share of the information on alpha and beta that this window gives"},
    {"mean_abs_angle_error", "mean angle error in common", u::deg, 3,
     [](const W& w) { return Cell{w.window.results.front().simulation.mean_abs_angle_error_rad}; },
     "mean absolute difference of modelled and measured roll angle, with the common alpha and beta"},
    {"own_alpha", "alpha by itself", u::m2, 4, own<0>, "damping of the window by itself"},
    {"own_alpha_interval", "95 % of alpha", u::m2, 4, own_interval<0>, "its 95 % interval; null: an open end"},
    {"own_beta", "beta by itself", u::m, 4, own<1>, "canard torque of the window by itself"},
    {"own_beta_interval", "95 % of beta", u::m, 4, own_interval<1>, "its 95 % interval"},
    {"own_mean_abs_angle_error", "mean angle error by itself", u::deg, 3,
     [](const W& w) { return Cell{w.own.simulation.mean_abs_angle_error_rad}; },
     "mean angle error of the window by itself"},
});

std::string difference_sentence(const J& f) {
  const std::string figures = fmt::format("chi-square {}; 95 in 100 such sets of one rocket stay below {}",
                                          fixed(f.agreement.chi_square, 1), fixed(f.agreement.limit, 1));
  if (f.agreement.agree()) {
    return fmt::format("Fitted separately, the windows differ no more than their noise explains ({}).", figures);
  }
  const std::string more =
      fmt::format("Fitted separately, the windows differ by more than their noise explains ({})", figures);
  return f.are_of_one_rocket()
             ? fmt::format(
                   "{}, but no alpha or beta by more than {} % from the common one. The common intervals do not "
                   "cover that difference.",
                   more, brief(100.0 * f.largest_difference(), 2))
             : more +
                   ": the rocket, the air or a sensor was not the same, or the model is incomplete. The common "
                   "intervals do not cover that.";
}

std::vector<std::string> conclusions(const J& f) {
  constexpr double nearly_all = 0.9;
  std::vector<std::string> all{difference_sentence(f)};
  if (!f.determines_both()) {
    all.emplace_back("Alpha or beta is not known within a factor of four.");
  }
  if (const auto doubtful = doubtful_windows(f); doubtful > 0) {
    all.push_back(
        fmt::format("In {} of {} windows the model does not fit the log well, and the intervals do not "
                    "include that error; see the remarks.",
                    doubtful, f.windows.size()));
  }
  for (const W& window : f.windows) {
    if (window.information_share >= nearly_all) {
      all.push_back(fmt::format("{} % of the information on alpha and beta comes from {}; the others hardly count.",
                                fixed(100.0 * window.information_share, 0), name(window)));
    }
  }
  return all;
}

output::Verdict verdict_of(const J& f) {
  using enum output::Answer;
  std::string sentence = heading_of(f) + ":";
  for (const std::string& one : conclusions(f)) {
    sentence += " " + one;
  }
  char& first = sentence[heading_of(f).size() + 2];
  first = static_cast<char>(std::tolower(static_cast<unsigned char>(first)));
  return {.answer = f.determines_both() && f.are_of_one_rocket() && doubtful_windows(f) == 0 ? yes : undecided,
          .heading = heading_of(f),
          .sentence = sentence};
}

/// What each window says by itself, and the common interval behind it.
output::Picture beside_each_other(const JointFindings& f, std::size_t number) {
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
  return {chart};
}

std::vector<std::string> remark_list(const J& f) {
  std::vector<std::string> all = f.warnings;
  for (const W& window : f.windows) {
    for (const std::string& remark : remarks(window.window, window.own)) {
      all.push_back(fmt::format("{}: {}", name(window), remark));
    }
  }
  return all;
}

/// With what a table cannot have: lists.
Blocks for_programs(const J& f, const output::Table& windows) {
  std::vector<std::string> said = f.warnings;
  std::ranges::copy(conclusions(f), std::back_inserter(said));
  Blocks all{output::Data{"shared", json::Value::array({"alpha", "beta"})}, output::figures("", f, joint_fields),
             output::Sentences{"remarks", said}, windows};
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const W& window = f.windows[i];
    const std::string place = fmt::format("windows.{}", i);
    all.emplace_back(
        output::Data{place + ".disturbance_deg", list(window.window.results.front().model.node_rad, u::deg)});
    all.emplace_back(output::Sentences{place + ".remarks", remarks(window.window, window.own)});
  }
  return all;
}

}  // namespace

std::vector<output::Listed> listed_joint() {
  return {output::listed("with --shared", joint_fields), output::listed("windows[] with --shared", window_fields)};
}

output::Document answer(const J& f, const output::Made& made) {
  using enum output::Readers;
  const output::Table windows = output::table("windows", f.windows, window_fields);
  output::Document document{
      .kind = "identification report",
      .title = fmt::format("{} windows, one roll model", f.windows.size()),
      .subtitle = f.vehicle,
      .verdict = verdict_of(f),
      .facts = {{"density", "density", f.density}, {"speed", "speed", f.speed}},
      .sections = {{"The roll model",
                    {output::only(
                         output::figures("", f, joint_fields),
                         {"alpha", "alpha_interval", "beta", "beta_interval", "chi_square", "chi_square_limit"}),
                     output::only(windows,
                                  {"data", "window", "own_alpha", "own_alpha_interval", "own_beta", "own_beta_interval",
                                   "information", "own_mean_abs_angle_error", "mean_abs_angle_error"}),
                     "\u00b1: standard deviation. Each window has a disturbance, a first angle and a first rate of its "
                     "own."}},
                   {"Each window by itself", {beside_each_other(f, 0), beside_each_other(f, 1)}, files}},
      .made = made,
      .json_decimals = json_digits};
  for (std::size_t i = 0; i < f.windows.size(); ++i) {
    const WindowFindings& window = f.windows[i].window;
    output::Section& section =
        document.sections.emplace_back(output::Section{fmt::format("{}: {}", i + 1, name(f.windows[i])), {}, files});
    section.blocks.emplace_back(extent(window.record) + ".");
    add_motion(section.blocks, window);
    add_residuals(section.blocks, window);
    document.spreadsheets.push_back(model_table(fmt::format("model_{}", i + 1), window.record, window.results.front()));
  }
  document.sections.push_back({"Remarks", {output::Sentences{.all = remark_list(f)}}});
  document.sections.push_back({"For programs", for_programs(f, windows), programs});
  return document;
}

}  // namespace fantail::identify::result
