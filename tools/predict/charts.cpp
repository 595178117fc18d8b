// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "campaign/analysis.hpp"
#include "predict/answer.hpp"
#include "stability/pitch_frequency.hpp"
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

page::Chart resonance_chart(const Prediction& p) {
  const RollResonance& resonance = *p.resonance;
  const double top_m_s = p.top_speed_m_s.p95;
  std::vector<double> free_1_m;
  std::vector<double> driven_1_m;
  for (const Run& run : p.runs) {
    const double rate_1_m_rad = run.airframe.torque_m / run.airframe.damping_m2;
    const double offset_rad = std::abs(run.airframe.offset_end_rad);
    free_1_m.push_back(rate_1_m_rad * offset_rad);
    driven_1_m.push_back(rate_1_m_rad * (offset_rad + p.reach.angle_rad));
  }
  const auto band = [&](const char* name, Role role, double low_1_m, double high_1_m) {
    return page::Area{.name = name,
                      .role = role,
                      .x = {0.0, top_m_s},
                      .low = {0.0, degrees(low_1_m * top_m_s)},
                      .high = {0.0, degrees(high_1_m * top_m_s)}};
  };
  const auto middle = [&](const char* name, Role role, double rate_1_m) {
    return page::Series{.name = name, .role = role, .x = {0.0, top_m_s}, .y = {0.0, degrees(rate_1_m * top_m_s)}};
  };
  const campaign::Quantiles free = campaign::quantiles(free_1_m);
  const campaign::Quantiles driven = campaign::quantiles(driven_1_m);
  return {
      .label = "Steady roll rates over the air speed, and the pitch frequency",
      .x_label = "air speed / m/s",
      .y_label = "roll rate, without its sign / deg/s",
      .series = {middle("without control", Role::model, free.p50),
                 middle("canards at their limit, with the fin offset", Role::second_model, driven.p50)},
      .areas = {band("roll resonance", Role::limit, (1.0 - stability::near_resonance) * resonance.least_frequency_1_m,
                     (1.0 + stability::near_resonance) * resonance.most_frequency_1_m),
                band("", Role::model, free.p5, free.p95), band("", Role::second_model, driven.p5, driven.p95)}};
}

}  // namespace fantail::predict
