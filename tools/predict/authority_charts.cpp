// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "airframe/model/build_up.hpp"
#include "predict/answer.hpp"
#include "text/degrees.hpp"

namespace fantail::predict {
namespace {

using page::Mark;
using page::Role;
using text::degrees;

// Of the highest curve: room for the names of the levels.
constexpr double headroom = 1.15;

/// The fins are those of the shape, with its error; the canards have the torque that the runs have in the median, in
/// which their fin offset is expressed.
std::optional<airframe::model::Estimate> canard_per_cant(const Prediction& p) {
  const airframe::model::BuildUp shape = airframe::model::build_up(p.flown.vehicle);
  std::vector<double> torques_m;
  std::ranges::transform(p.runs, std::back_inserter(torques_m), [](const Run& run) { return run.airframe.torque_m; });
  const double torque_m3 = p.flown.vehicle.roll_plant.reference_area_m2 * campaign::quantiles(std::move(torques_m)).p50;
  if (!shape.cant_as_canards || !shape.roll_torque_m3 || torque_m3 <= 0.0) {
    return std::nullopt;
  }
  const double error = shape.cant_as_canards->value / shape.cant_as_canards->low;
  const double value = shape.cant_as_canards->value * shape.roll_torque_m3->value / torque_m3;
  return airframe::model::Estimate{.value = value, .low = value / error, .high = value * error};
}

}  // namespace

std::optional<page::Chart> authority_chart(const Prediction& p) {
  page::Series needed{.name = "needed, median", .role = Role::model};
  page::Series given{.name = "canards can give", .role = Role::limit};
  page::Area band{.name = "needed, 5 to 95 %", .role = Role::model};
  double most_deg = 0.0;
  for (const AuthorityAtSpeed& at : p.authority_over_speed) {
    needed.x.push_back(at.speed_m_s);
    needed.y.push_back(degrees(at.needed_rad.p50));
    band.low.push_back(degrees(at.needed_rad.p5));
    band.high.push_back(degrees(at.needed_rad.p95));
    given.y.push_back(degrees(at.given_rad));
    most_deg = std::max({most_deg, band.high.back(), given.y.back()});
  }
  if (needed.x.size() < 2 || most_deg <= 0.0) {
    return std::nullopt;
  }
  given.x = needed.x;
  band.x = needed.x;
  std::vector<page::Level> levels;
  if (!p.speeds_m_s.empty()) {
    levels.push_back({.value = p.speeds_m_s.front(), .label = "control begins", .upright = true});
  }
  const double least_deg = std::min(0.0, *std::ranges::min_element(given.y));
  return page::Chart{
      .label = "Canard angle that the fin offset needs and that the canards can give, over the air speed",
      .x_label = "air speed in the climb / m/s",
      .y_label = "canard angle / deg",
      .width = page::half_page,
      .series = {needed, given},
      .areas = {band},
      .levels = std::move(levels),
      .y_range = page::Range{least_deg, headroom * most_deg}};
}

std::optional<page::Chart> cant_chart(const Prediction& p) {
  if (!p.flown.vehicle.geometry) {
    return std::nullopt;
  }
  const auto per_cant = canard_per_cant(p);
  if (!per_cant || per_cant->value <= 0.0) {
    return std::nullopt;
  }
  page::Series offset{
      .name = "fin offset of the runs: 5, 50, 95 %", .role = Role::measured, .mark = Mark::line_and_points};
  for (const double offset_rad : {p.offset_size_rad.p5, p.offset_size_rad.p50, p.offset_size_rad.p95}) {
    offset.x.push_back(degrees(offset_rad) / per_cant->value);
    offset.y.push_back(degrees(offset_rad));
  }
  const double limit_deg = std::max(0.0, degrees(p.reach.angle_rad));
  const double most_deg = headroom * std::max(limit_deg, offset.y.back());
  if (most_deg <= 0.0) {
    return std::nullopt;
  }
  std::vector<page::Level> levels;
  if (limit_deg > 0.0) {  // below, they balance no cant
    levels.push_back(
        {.value = limit_deg, .label = p.reach.set_by.empty() ? "canard limit" : p.reach.set_by, .role = Role::limit});
  }
  const double end_deg = most_deg / per_cant->value;
  const auto angle_deg = [&](double slope) { return std::min(most_deg, slope * end_deg); };
  // A band above the plot's upper edge ends at that edge, where its slope meets it.
  const double meets_deg = std::min(end_deg, most_deg / per_cant->high);
  return page::Chart{.label = "Canard angle that balances a fin cant, over the cant, and the canard limit",
                     .x_label = "cant of all fins / deg",
                     .y_label = "canard angle / deg",
                     .width = page::half_page,
                     .series = {{.name = "fins from the shape",
                                 .role = Role::model,
                                 .x = {0.0, end_deg},
                                 .y = {0.0, angle_deg(per_cant->value)}},
                                offset},
                     .areas = {{.name = "range of the method",
                                .role = Role::model,
                                .x = {0.0, meets_deg, end_deg},
                                .low = {0.0, per_cant->low * meets_deg, angle_deg(per_cant->low)},
                                .high = {0.0, per_cant->high * meets_deg, most_deg}}},
                     .levels = std::move(levels),
                     .x_range = page::Range{0.0, end_deg},
                     .y_range = page::Range{0.0, most_deg}};
}

}  // namespace fantail::predict
