// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <fmt/core.h>

#include "report/chart_drawer.hpp"
#include "report/figures.hpp"
#include "report/sections.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {
namespace {

using flight::Flight;
using flight::Row;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double finest_step_s = 0.02;
constexpr double most_samples = 3000.0;

double in_degrees(const std::optional<double>& angle_rad) { return text::in_degrees(angle_rad).value_or(unknown); }

/// What the air sees of a canard: its encoder, or where that is silent its command, from its trim and in the sense of
/// roll.
double canard_deg(const Flight& flight, const Row& row, std::size_t canard) {
  const std::optional<double>& angle_rad =
      row.encoders_rad[canard] ? row.encoders_rad[canard] : row.commands_rad[canard];
  if (!angle_rad) {
    return unknown;
  }
  return text::degrees(flight.known.plan ? deflection_rad(flight.plan.canards.each[canard], *angle_rad) : *angle_rad);
}

/// At apogee or at the end of control, whichever came first: what control has come to.
std::optional<double> most_telling_s(const Flight& flight) {
  const flight::Events& e = flight.events;
  return e.control_end_s && e.apogee_s ? std::min(e.control_end_s, e.apogee_s) : e.control_end_s;
}

/// Of a path by the compass; where the plane of another program's points nobody knows.
std::optional<page::ScenePath> path_of(const Flight& flight, const page::RollScene& scene) {
  if (flight.path.empty() || flight.path_frame == flight::PathFrame::plane) {
    return std::nullopt;
  }
  page::ScenePath path;
  for (std::size_t i = 0; i < scene.roll_deg.size(); ++i) {
    const double time_s = scene.begin_s + scene.step_s * static_cast<double>(i);
    const flight::PathPoint* at = flight::point_at(flight.path, time_s);
    path.north_m.push_back(at != nullptr ? at->north_m : unknown);
    path.east_m.push_back(at != nullptr ? at->east_m : unknown);
    path.height_m.push_back(at != nullptr ? at->height_m : unknown);
  }
  if (flight.wind && flight.wind->speed_m_s > 0.0) {
    const double from_rad = flight.wind->from_rad;
    const std::string from = compass({.north_m = std::cos(from_rad), .east_m = std::sin(from_rad)});
    path.wind = {.to_rad = from_rad + std::numbers::pi,
                 .words = fmt::format("wind {} m/s from the {}", text::brief(flight.wind->speed_m_s, 1), from)};
  }
  return path;
}

}  // namespace

std::optional<page::RollScene> roll_scene(const Flight& flight, double begin_s) {
  const auto first = std::ranges::lower_bound(flight.rows, begin_s, {}, &Row::time_s);
  const std::span<const Row> rows{first, flight.rows.end()};
  const auto knows_roll = [](const Row& row) { return row.truth || std::isfinite(row.roll_angle_rad); };
  if (rows.size() < 2 || std::ranges::none_of(rows, knows_roll)) {
    return std::nullopt;
  }
  const bool is_true = knows_true_roll(rows);
  const double length_s = rows.back().time_s - rows.front().time_s;
  page::RollScene scene{.name = "As flown",
                        .begin_s = rows.front().time_s,
                        .step_s = std::max(finest_step_s, std::ceil(1e3 * length_s / most_samples) / 1e3),
                        .shown_s = most_telling_s(flight).value_or(rows.front().time_s),
                        .from_s = rows.front().time_s};
  scene.note = fmt::format(
      "Seen from behind and the right; positive roll is clockwise. Only roll is drawn, without pitch and yaw, as {}.",
      is_true ? "it truly was" : "the flight computer estimated it");
  if (!flight.without_control.empty()) {
    scene.note += " Without control: the same rocket, seed and faults, with its canards at trim.";
  }
  const auto samples = static_cast<std::size_t>(length_s / scene.step_s) + 1;
  for (std::size_t i = 0; i < samples; ++i) {
    const double time_s = scene.begin_s + scene.step_s * static_cast<double>(i);
    const auto row = std::ranges::lower_bound(rows, time_s - 1e-6, {}, &Row::time_s);
    // In a gap of the log nobody knows how it stood.
    const bool is_known = row != rows.end() && row->time_s - time_s < scene.step_s;
    scene.roll_deg.push_back(is_known ? roll_deg(*row, is_true) : unknown);
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      scene.canards_deg[canard].push_back(is_known ? canard_deg(flight, *row, canard) : unknown);
    }
    if (!flight.without_control.empty()) {
      scene.without_control_deg.push_back(in_degrees(flight::free_roll_angle_rad(flight.without_control, time_s)));
    }
  }
  scene.path = path_of(flight, scene);
  if (scene.path) {
    scene.note += " The path has one scale for all directions, and is seen from the south.";
  }
  return scene;
}

}  // namespace fantail::report
