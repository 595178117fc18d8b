// SPDX-License-Identifier: MIT
#include "paper/tunnel_step.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/core.h>

#include "identify/closed_loop/closed_loop.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::paper {
namespace {

constexpr double step_s = 5.0;
constexpr double speed_m_s = 22.0;

// The print lost the minus sign of this one.
double end_as_printed_deg(const PublishedStep& row) {
  constexpr int step_without_minus = 7;
  return row.step == step_without_minus ? -row.disturbance_end_deg : row.disturbance_end_deg;
}

}  // namespace

identify::model::Record fly_step(const TunnelStep& step, const sim::Scenario& tunnel) {
  identify::model::Record record;
  for (int i = 0; i <= static_cast<int>(step_s * 100.0); ++i) {
    record.time_s.push_back(0.01 * i);
  }
  const std::size_t samples = record.size();
  record.roll_angle_rad.assign(samples, 0.0);
  record.roll_rate_rad_s.assign(samples, 0.0);
  record.canard_rad.assign(samples, 0.0);
  record.speed_m_s.assign(samples, speed_m_s);
  record.density_kg_m3.assign(samples, tunnel.tunnel.density_kg_m3);
  record.reference_rad.assign(samples, text::radians(step.to_deg));
  record.excitation_rad.assign(samples, 0.0);
  record.in_control.assign(samples, true);
  const identify::model::RollModel truth{
      .alpha_m2 = step.alpha_m2,
      .beta_m = step.beta_m,
      .node_time_s = {0.0, step_s},
      .node_rad = {text::radians(step.offset_begin_deg), text::radians(step.offset_end_deg)},
      .initial = {{.angle_rad = text::radians(step.from_deg), .rate_rad_s = 0.0}}};
  const identify::model::Simulation flown =
      identify::closed_loop::simulate(record, airframe(tunnel), {.controller = tunnel.plan.controller}, truth);
  record.roll_angle_rad = flown.roll_angle_rad;
  record.roll_rate_rad_s = flown.roll_rate_rad_s;
  record.canard_rad = flown.canard_rad;
  return record;
}

StepShape shape_of(const identify::model::Record& record) {
  const double begin_rad = record.roll_angle_rad.front();
  const double way_rad = record.roll_angle_rad.back() - begin_rad;
  double furthest = 0.0;  // shares of the way
  std::optional<double> tenth_s;
  std::optional<double> nine_tenths_s;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double share = (record.roll_angle_rad[i] - begin_rad) / way_rad;
    furthest = std::max(furthest, share);
    if (!tenth_s && share >= 0.1) {
      tenth_s = record.time_s[i];
    }
    if (!nine_tenths_s && share >= 0.9) {
      nine_tenths_s = record.time_s[i];
    }
  }
  return {.overshoot_deg = text::degrees(std::abs(way_rad)) * (furthest - 1.0),
          .rise_s = nine_tenths_s.value_or(0.0) - tenth_s.value_or(0.0)};
}

ReadBack read_back(const PublishedStep& row, const sim::Scenario& tunnel) {
  identify::model::Record record = fly_step({.alpha_m2 = row.alpha_m2,
                                             .beta_m = row.beta_m,
                                             .offset_begin_deg = row.disturbance_begin_deg,
                                             .offset_end_deg = row.disturbance_end_deg},
                                            tunnel);
  record.window = "step " + std::to_string(row.step);
  identify::result::Identification found =
      identify::identify(record, airframe(tunnel),
                         {.nodes = identify::model::NodeTimes{0.0, step_s}, .method = identify::result::Method::grid});
  return {.record = std::move(record), .found = std::move(found)};
}

Claim compare(const PublishedStep& row, const ReadBack& ours) {
  const identify::model::RollModel& model = ours.found.model;
  const double begin_deg = text::degrees(model.node_rad.front());
  const double end_deg = text::degrees(model.node_rad.back());
  const bool agrees = model.alpha_m2 == row.alpha_m2 && model.beta_m == row.beta_m &&
                      std::abs(begin_deg - row.disturbance_begin_deg) <= 0.03 &&
                      std::abs(end_deg - row.disturbance_end_deg) <= 0.03;
  const auto numbers = [](double alpha_m2, double beta_m, double from_deg, double to_deg) {
    return text::with_minus(fmt::format("{:g}, {:g}, {:.2f} to {:.2f} deg", alpha_m2, beta_m, from_deg, to_deg));
  };
  return {.place = "Table 2, step " + std::to_string(row.step),
          .what = "Damping, torque constant, offset at the begin and end",
          .theirs = numbers(row.alpha_m2, row.beta_m, row.disturbance_begin_deg, end_as_printed_deg(row)),
          .ours = numbers(model.alpha_m2, model.beta_m, begin_deg, end_deg),
          .difference = text::with_minus(fmt::format("{:g}, {:g}, {:.3f} and {:.3f} deg", model.alpha_m2 - row.alpha_m2,
                                                     model.beta_m - row.beta_m, begin_deg - row.disturbance_begin_deg,
                                                     end_deg - row.disturbance_end_deg)),
          .kind = Kind::read_back,
          .agrees = agrees,
          .why = agrees ? "" : "The reason is not known."};
}

}  // namespace fantail::paper
