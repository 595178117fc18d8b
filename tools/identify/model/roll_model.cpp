// SPDX-License-Identifier: MIT
#include "identify/model/roll_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/core.h>

#include "text/error.hpp"

namespace fantail::identify::model {

double mean_inertia_kg_m2(const Record& record, const Airframe& airframe) {
  const std::vector<double>& all = record.roll_inertia_kg_m2;
  return all.empty() ? airframe.inertia_kg_m2
                     : std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}

std::vector<RollEquation> roll_equations(const Record& record, const Airframe& airframe) {
  std::vector<RollEquation> all;
  all.reserve(record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    Airframe now = airframe;
    now.inertia_kg_m2 = record.roll_inertia_kg_m2.empty() ? airframe.inertia_kg_m2 : record.roll_inertia_kg_m2[i];
    all.push_back(roll_equation(now, record.density_kg_m3[i], record.speed_m_s[i]));
  }
  return all;
}

NodeTimes even_nodes(const Record& record, std::size_t intervals) {
  const double length_s = record.time_s.back();
  NodeTimes times{0.0};
  for (std::size_t k = 1; k <= intervals; ++k) {
    times.push_back(length_s * static_cast<double>(k) / static_cast<double>(intervals));
  }
  return times;
}

void check_nodes(const Record& record, const NodeTimes& nodes) {
  using text::Error;
  using text::ErrorKind;
  if (nodes.empty()) {
    throw Error{ErrorKind::bad_configuration, "nodes: none given; at least one is needed"};
  }
  std::vector<double> weight(nodes.size(), 0.0);
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    if (!(nodes[k] > nodes[k - 1])) {
      throw Error{ErrorKind::bad_configuration,
                  fmt::format("nodes: {:g} s after {:g} s; the times must increase", record.window_begin_s + nodes[k],
                              record.window_begin_s + nodes[k - 1])};
    }
  }
  for (const double time_s : record.time_s) {
    const NodeShare share = node_share(nodes, time_s);
    weight[share.left] += 1.0 - share.right_share;
    weight[share.right] += share.right_share;
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (weight[k] <= 0.0) {
      throw Error{
          ErrorKind::bad_configuration,
          fmt::format(
              "nodes: no sample of window {} determines the node at {:g} s; allowed on the log's clock: {:g} to "
              "{:g} s",
              record.window, record.window_begin_s + nodes[k], record.window_begin_s,
              record.window_begin_s + record.time_s.back())};
    }
  }
}

NodeShare node_share(const NodeTimes& nodes, double time_s) {
  if (time_s <= nodes.front()) {
    return {.left = 0, .right = 0, .right_share = 0.0};
  }
  const std::size_t last = nodes.size() - 1;
  if (time_s >= nodes.back()) {
    return {.left = last, .right = last, .right_share = 0.0};
  }
  const auto behind = std::ranges::upper_bound(nodes, time_s);
  const auto right = static_cast<std::size_t>(behind - nodes.begin());
  const double begin_s = nodes[right - 1];
  return {.left = right - 1, .right = right, .right_share = (time_s - begin_s) / (nodes[right] - begin_s)};
}

std::vector<InitialState> measured_starts(const Record& record) {
  std::vector<InitialState> starts;
  starts.reserve(record.segment_begin.size());
  for (const std::size_t at : record.segment_begin) {
    starts.push_back({.angle_rad = record.roll_angle_rad[at], .rate_rad_s = record.roll_rate_rad_s[at]});
  }
  return starts;
}

double RollModel::disturbance_rad(double time_s) const {
  const NodeShare share = node_share(node_time_s, time_s);
  return node_rad[share.left] + share.right_share * (node_rad[share.right] - node_rad[share.left]);
}

std::vector<double> RollModel::numbers() const {
  std::vector<double> all{alpha_m2, beta_m};
  all.insert(all.end(), node_rad.begin(), node_rad.end());
  return all;
}

AlphaRange alpha_range(const Airframe& airframe) {
  const double scale = published_area_m2 / airframe.reference_area_m2;
  return {.lowest_m2 = 0.01 * scale, .highest_m2 = 1000.0 * scale};
}

Grid published_grid(const Airframe& airframe) {
  const double exact = published_area_m2 / airframe.reference_area_m2;
  const double digit = std::pow(10.0, std::floor(std::log10(exact)) - 1.0);
  const double scale = digit * std::round(exact / digit);
  const auto scaled = [scale](const Axis& axis) {
    return Axis{.first = scale * axis.first, .last = scale * axis.last, .step = scale * axis.step};
  };
  return {.alpha_m2 = scaled(Grid{}.alpha_m2), .beta_m = scaled(Grid{}.beta_m)};
}

std::vector<double> Axis::values() const {
  // Counted, not summed up: 5 + 10 * 0.1 is 6, ten sums of 0.1 are not.
  const auto steps = static_cast<int>(std::floor((last - first) / step + 1e-9));
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) {
    all.push_back(first + static_cast<double>(i) * step);
  }
  return all;
}

void Simulation::compare_with(const Record& record) {
  const auto samples = static_cast<double>(record.size());
  double angle_sum = 0.0;
  double rate_sum = 0.0;
  double square_sum = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double angle_error = record.roll_angle_rad[i] - roll_angle_rad[i];
    angle_sum += std::abs(angle_error);
    square_sum += angle_error * angle_error;
    rate_sum += std::abs(record.roll_rate_rad_s[i] - roll_rate_rad_s[i]);
  }
  mean_abs_angle_error_rad = angle_sum / samples;
  mean_abs_rate_error_rad_s = rate_sum / samples;
  rms_angle_error_rad = std::sqrt(square_sum / samples);
}

}  // namespace fantail::identify::model
