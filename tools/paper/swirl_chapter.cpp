// SPDX-License-Identifier: MIT
// Section 4.1.2: how much the tunnel itself turns the rocket.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "paper/paper_page.hpp"
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

// At the speed of the tunnel steps.
const tunnel::OffsetPoint& at_22_m_s(const std::vector<tunnel::OffsetPoint>& list) {
  return *std::ranges::min_element(
      list, {}, [](const tunnel::OffsetPoint& point) { return std::abs(point.speed_m_s.mean - 22.0); });
}

double spread_deg(const std::vector<tunnel::OffsetPoint>& list) {
  const auto [least, most] = std::ranges::minmax(list, {}, &tunnel::OffsetPoint::offset_rad);
  return text::degrees(most.offset_rad - least.offset_rad);
}

void add_rows(std::vector<Claim>& claims, const tunnel::Swirl& swirl) {
  const double found_deg = swirl.swirl ? std::abs(text::degrees(swirl.swirl->offset_rad)) : std::nan("");
  claims.push_back(compare(Numbers{.place = "Section 4.1.2, figure 16",
                                   .what = "Swirl above 20 m/s, as equivalent canard angle, about",
                                   .theirs = 2.0,
                                   .ours = found_deg,
                                   .unit = "deg",
                                   .decimals = 1,
                                   .tolerance = 0.05,
                                   .kind = Kind::read_back,
                                   .why_otherwise = "The simulated tunnel has 2 degrees of swirl.",
                                   .remark = "The simulated tunnel has 2 degrees of swirl."}));
  const double without_deg_s = text::degrees(at_22_m_s(swirl.without).rate_rad_s.mean);
  const double with_deg_s = text::degrees(at_22_m_s(swirl.with).rate_rad_s.mean);
  claims.push_back(compare(InWords{
      .place = "Section 4.1.2, figures 14 and 15",
      .what = "The straightener reduces the roll rate",
      .theirs = "significantly",
      .ours = text::with_minus(fmt::format("from {:.1f} to {:.1f} deg/s at 22 m/s", without_deg_s, with_deg_s)),
      .holds = std::abs(with_deg_s) < 0.9 * std::abs(without_deg_s),
      .kind = Kind::read_back,
      .why = "From the offsets of section 4.3.1, \u22126.1 and \u22124.1 degrees, which are inputs of the runs."}));
  claims.push_back(compare(InWords{.place = "Section 4.1.2, figure 16",
                                   .what = "With straightener the offset hardly depends on the speed",
                                   .theirs = "very little difference",
                                   .ours = fmt::format("within {:.2f} deg from 10 to 30 m/s", spread_deg(swirl.with)),
                                   .holds = spread_deg(swirl.with) < 0.5,
                                   .kind = Kind::read_back,
                                   .why = "The simulated offset does not depend on it."}));
  claims.push_back(unpublished("Section 4.1.2, figure 16", "Without straightener the swirl counts more at low speeds",
                               "a greater effect",
                               "How much more is in the figure only; the simulated swirl is the same at every speed.",
                               fmt::format("within {:.2f} deg", spread_deg(swirl.without))));
  claims.push_back(unpublished("Section 4.1.2", "Roll rate of the bare fins at 30 m/s, without and with straightener",
                               "87.0 and 25.7 deg/s", "Counted from a video; neither fins nor swirl are described."));
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
                      "straightener. Eq 27 turns the steady roll rates into an equivalent fin offset. The rates are "
                      "not published: a simulated tunnel with 2 degrees of swirl stands in for theirs."};
  add_rows(chapter.claims, swirl);
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
         "As the roll rates of figure 14.");
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
         "simulated one does not depend on speed.");
  return chapter;
}

}  // namespace fantail::paper
