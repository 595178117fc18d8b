// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "predict/answer.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using page::Mark;
using page::Role;
using text::degrees;

page::Series points(std::string name, Role role) {
  return {.name = std::move(name), .role = role, .mark = Mark::points};
}

void add(page::Series& to, const TunnelStep& step) {
  to.x.push_back(step.damping_m2);
  to.y.push_back(step.torque_m);
}

}  // namespace

page::Series reference(const Prediction& p) {
  page::Series line{.name = "reference", .role = Role::reference, .mark = Mark::step, .x = p.band.time_s};
  const auto flown = std::ranges::max_element(p.runs, {}, [](const Run& run) { return run.reference_rad.size(); });
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const std::optional<double>& value = flown->reference_rad[i];
    line.y.push_back(value ? degrees(*value) : std::numeric_limits<double>::quiet_NaN());
  }
  return line;
}

page::Chart offset_chart(const Prediction& p) {
  page::Series share{.name = "share of the runs", .role = Role::model, .mark = Mark::step};
  for (const Run& run : p.runs) {
    share.x.push_back(degrees(std::abs(run.offset_rad)));
  }
  std::ranges::sort(share.x);
  const auto [first, last] = std::ranges::unique(share.x);
  share.x.erase(first, last);
  for (const double size_deg : share.x) {
    const auto within = std::ranges::count_if(
        p.runs, [size_deg](const Run& run) { return degrees(std::abs(run.offset_rad)) <= size_deg; });
    share.y.push_back(100.0 * static_cast<double>(within) / static_cast<double>(p.runs.size()));
  }
  const double limit_deg = degrees(p.reach.angle_rad);
  std::vector<page::Level> levels;
  if (limit_deg >= 0.0) {  // below, they reach no offset of any size
    levels.push_back({.value = limit_deg,
                      .label = p.reach.set_by.empty() ? "canard limit" : p.reach.set_by,
                      .upright = true,
                      .role = Role::limit});
  }
  return {.label = "Share of the runs whose fin offset is not larger than a size, and the canard limit",
          .x_label = "size of the fin offset / deg",
          .y_label = "runs with at most that / %",
          .width = page::half_page,
          .series = {share},
          .levels = std::move(levels),
          .x_range = page::Range{0.0, 1.1 * std::max(limit_deg, share.x.back())},
          .y_range = page::Range{0.0, 100.0}};
}

page::Chart airframe_chart(const Prediction& p) {
  page::Series drawn = points("flown", Role::model);
  page::Series tunnel = points("identified", Role::measured);
  for (const Run& run : p.runs) {
    add(drawn, run.airframe);
  }
  for (const TunnelStep& step : p.tunnel.steps) {
    add(tunnel, step);
  }
  return {.label = "Damping and torque of the airframes flown and of the tunnel's steps",
          .x_label = "damping alpha / m2",
          .y_label = "torque beta / m",
          .width = page::half_page,
          .series = {drawn, tunnel}};
}

}  // namespace fantail::predict
