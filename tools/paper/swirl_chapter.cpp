// SPDX-License-Identifier: MIT
// Section 4.1.2: how much the tunnel itself turns the rocket.
#include <fmt/core.h>

#include "paper/chapters.hpp"
#include "paper/drawing.hpp"
#include "paper/runs.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::paper {
namespace {

page::Series points(const std::vector<tunnel::OffsetPoint>& list, std::string name, page::Role role,
                    double (*value)(const tunnel::OffsetPoint&)) {
  page::Series series{.name = std::move(name), .role = role, .mark = page::Mark::line_and_points};
  for (const tunnel::OffsetPoint& point : list) {
    series.x.push_back(point.speed_m_s.mean);
    series.y.push_back(value(point));
  }
  return series;
}

}  // namespace

Chapter swirl_chapter(const Tell& tell) {
  const tunnel::RollSession without = roll_session(fly("tunnel_swirl_without", {}, tell));
  const tunnel::RollSession with = roll_session(fly("tunnel_swirl_with", {}, tell));
  tell("comparing the swirl sessions");
  const tunnel::Swirl swirl = tunnel::examine_swirl(without, with, {.roll = tunnel::published_roll()});
  Chapter chapter{.title = "Swirl",
                  .introduction =
                      "The rocket rolls freely with its canards at zero, once without and once with a flow "
                      "straightener; Eq 27 turns the steady roll rates into an equivalent fin offset. The rates "
                      "are not published: a simulated tunnel with 2 degrees of swirl stands in for theirs."};
  chapter.claims.push_back(unpublished(
      "Section 4.1.2", "Swirl above 20 m/s, as equivalent canard angle", "about 2 deg",
      "The roll rates are not published; ours is a simulated tunnel with 2.0 degrees of it.",
      swirl.swirl
          ? fmt::format("{} \u00b1 {} deg", text::with_minus(text::fixed(text::degrees(swirl.swirl->offset_rad), 2)),
                        text::fixed(2.0 * text::degrees(swirl.swirl->standard_error_rad), 2))
          : "no common speed"));
  chapter.claims.push_back(
      unpublished("Section 4.1.2", "Roll rate of the bare fins at 30 m/s, without and with straightener",
                  "87.0 and 25.7 deg/s", "Counted from a video; neither fins nor swirl are described."));
  const auto rate = [](const tunnel::OffsetPoint& point) { return text::degrees(point.rate_rad_s.mean); };
  const auto offset = [](const tunnel::OffsetPoint& point) { return text::degrees(point.offset_rad); };
  const auto session = [](const tunnel::RollSession& from, std::string name, page::Role role) {
    return curve(from.roll.time_s, text::in_degrees(from.roll.roll_rate_rad_s), std::move(name), role);
  };
  const auto figure = [&](const page::Chart& chart, const std::string& caption) {
    chapter.figures_html.push_back(half_width_figure(chart, caption));
  };
  figure({.label = "Roll rate over time",
          .x_label = "time / s",
          .y_label = "roll rate / deg/s",
          .series = {session(without, "without straightener", page::Role::measured),
                     session(with, "with straightener", page::Role::model)}},
         "As figure 14a.");
  figure({.label = "Steady roll rate over speed",
          .x_label = "wind speed / m/s",
          .y_label = "mean roll rate / deg/s",
          .series = {points(swirl.without, "without straightener", page::Role::measured, rate),
                     points(swirl.with, "with straightener", page::Role::model, rate)}},
         "As figure 15.");
  figure({.label = "Equivalent fin offset over speed",
          .x_label = "wind speed / m/s",
          .y_label = "equivalent fin offset / deg",
          .series = {points(swirl.without, "without straightener", page::Role::measured, offset),
                     points(swirl.with, "with straightener", page::Role::model, offset)}},
         "As figure 16: the distance of the curves is the swirl. The published swirl grows at low speeds; the "
         "simulated one "
         "does not depend on speed.");
  return chapter;
}

}  // namespace fantail::paper
