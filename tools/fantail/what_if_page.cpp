// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "fantail/what_if.hpp"
#include "page/page.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

using page::Role;

page::Series curve(const WhatIf& result, std::string name, Role role, const std::vector<double>& values_rad) {
  return {.name = std::move(name), .role = role, .x = result.time_s, .y = text::in_degrees(values_rad)};
}

// Where ticks could not be replayed the curves have a gap.
std::string chart(std::string_view what, std::vector<page::Series> series, double height) {
  return page::figure({.label = fmt::format("{} over time", what),
                       .x_label = "time / s",
                       .y_label = fmt::format("{} / deg", what),
                       .height = height,
                       .series = std::move(series),
                       .sampled = true,
                       .least_left = 48.0});
}

std::vector<page::Figure> figures(const WhatIf& result) {
  const auto share = [](double value) { return fmt::format("{:.1f}", 100.0 * value); };
  const std::string first = result.first_difference_s ? text::fixed(*result.first_difference_s, 3) : "none";
  return {{"First difference", first, result.first_difference_s ? "s" : "", "from " + result.clock},
          {"Largest difference", fmt::format("{:.2f}", text::degrees(result.largest_difference_rad)), "deg",
           fmt::format("at {:.3f} s", result.largest_difference_s)},
          {"Different commands", std::to_string(result.differing), "ticks",
           fmt::format("of {} replayed", result.time_s.size())},
          {"Saturated, flown", share(result.flown_saturated), "%", "of the time under control"},
          {"Saturated, what if", share(result.what_if_saturated), "%", "of the time under control"}};
}

}  // namespace

std::string what_if_html(const WhatIf& result) {
  page::Page page{.kind = "Fantail replay: what if", .title = fmt::format("{}", fmt::join(result.changes, ", "))};
  page.subtitle = result.log;
  page.tone = page::Tone::unsure;
  page.verdict_heading = "Not a prediction";
  page.verdict = open_loop_sentence;
  if (result.rejects_offset) {
    page.verdict += std::string{" "} + winding_sentence;
  }
  std::vector<double> difference_rad(result.time_s.size());
  std::ranges::transform(result.what_if_rad, result.flown_rad, difference_rad.begin(), std::minus{});
  page.body_html = page::section(
      "Roll command", page::figure_row(figures(result)) +
                          chart("roll command",
                                {curve(result, "what if", Role::model, result.what_if_rad),
                                 curve(result, "flown", Role::measured, result.flown_rad)},
                                300.0) +
                          chart("what if minus flown", {curve(result, "", Role::model, difference_rad)}, 190.0));
  page.body_html += page::section(
      "The roll that was flown",
      chart("roll angle", {curve(result, "", Role::measured, result.roll_angle_rad)}, 190.0) +
          page::paragraph(
              "As the changed plan's flight law would have estimated it from the same sensors. Every tick is "
              "in what_if.csv beside this page."));
  if (result.unreachable > 0) {
    page.body_html +=
        page::paragraph(fmt::format("{} left out: behind a gap in the log, with no checkpoint in between.",
                                    text::counted(result.unreachable, "tick is", "ticks are")));
  }
  return page::html(page);
}

}  // namespace fantail::tool
