// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "identify/model/roll_equation.hpp"

namespace fantail::identify::model {

/// One window of a log: what drove the rocket, and how it rolled. All lists that are not empty are as long as time_s.
/// Between two samples canard angle, speed and density run straight.
struct Record {
  std::vector<double> time_s;  ///< 0 at the begin of the window, strictly increasing
  std::vector<double> roll_angle_rad;
  std::vector<double> roll_rate_rad_s;
  std::vector<double> canard_rad;
  std::vector<double> canard_rate_rad_s;  ///< d canard_rad / d lag; empty unless the canard column's lag is fitted, too
  std::vector<double> speed_m_s;
  std::vector<double> density_kg_m3;         ///< where alpha and beta grow with the Mach number, times that growth
  std::vector<double> mach{};                ///< empty: unknown
  bool grows_with_mach = false;              ///< of alpha and beta; then those found are the values at low speed
  std::vector<double> roll_inertia_kg_m2{};  ///< empty: the airframe's throughout
  std::vector<double> reference_rad;         ///< empty where nobody needs it: closed loop only
  std::vector<double> excitation_rad;        ///< likewise
  std::vector<double> offset_estimate_rad;   ///< likewise: what the law took off its command
  std::vector<double> law_speed_m_s;  ///< likewise: what the law knew of the speed, and from when on only a lower bound
  double law_speed_is_bound_s = std::numeric_limits<double>::infinity();
  std::vector<bool> in_control;  ///< likewise: the command is zero where false
  /// First sample of each stretch without a gap; the first is 0. Behind a gap the model starts anew from what was
  /// measured there, because the canard angles in the gap are unknown.
  std::vector<std::size_t> segment_begin{0};
  double window_begin_s = 0.0;  ///< on the log's clock
  std::string window;           ///< what the person called it: "control", "0.4:2"

  [[nodiscard]] std::size_t size() const { return time_s.size(); }
};

/// Over the samples.
[[nodiscard]] double mean_inertia_kg_m2(const Record& record, const Airframe& airframe);

/// The equation at each sample.
[[nodiscard]] std::vector<RollEquation> roll_equations(const Record& record, const Airframe& airframe);

/// Times of the disturbance's nodes in a record, strictly increasing, at least one (then the disturbance is constant).
/// Straight between nodes, constant before the first and after the last.
using NodeTimes = std::vector<double>;

/// `intervals` + 1 nodes at an even distance over the record; one node for none.
[[nodiscard]] NodeTimes even_nodes(const Record& record, std::size_t intervals);

/// Throws text::Error (bad_configuration) unless the times increase and every node has a sample on one of its
/// sides, this node's side included: another could have any value.
void check_nodes(const Record& record, const NodeTimes& nodes);

/// Share of each node in the disturbance at a time; they add up to one.
struct NodeShare {
  std::size_t left;   ///< the node before; its share is 1 - right_share
  std::size_t right;  ///< the node behind; the same as `left` outside the nodes
  double right_share;
};
[[nodiscard]] NodeShare node_share(const NodeTimes& nodes, double time_s);

/// Roll state at the begin of a segment.
struct InitialState {
  double angle_rad;
  double rate_rad_s;
};

/// Measured angle and rate at the begin of each segment.
[[nodiscard]] std::vector<InitialState> measured_starts(const Record& record);

/// What a model begins each segment with.
enum class Start : std::uint8_t {
  measured,  ///< the first measured angle and rate, as published
  fitted,    ///< two more unknowns
};

/// One identified roll model: the constants of the roll equation, with the disturbance u_d as a line over time.
struct RollModel {
  double alpha_m2 = 0.0;
  double beta_m = 0.0;
  NodeTimes node_time_s{};
  std::vector<double> node_rad{};       ///< u_d at each node
  std::vector<InitialState> initial{};  ///< one for each segment of the record

  [[nodiscard]] double disturbance_rad(double time_s) const;
  /// All that is looked for, in one order: alpha, beta, nodes.
  [[nodiscard]] std::vector<double> numbers() const;
};

/// The area that the published constants count with. Only area times alpha and area times beta show in a motion, so
/// ranges of search are stated for this area and divided by a rocket's own.
inline constexpr double published_area_m2 = 5.0265e-5;

/// Where a damping constant is looked for. At the published area a roll rate outlasts every flight with 0.01 m2; with
/// 1000 m2 it is gone within a sample.
struct AlphaRange {
  double lowest_m2;
  double highest_m2;
  [[nodiscard]] bool contains(double alpha_m2) const { return alpha_m2 >= lowest_m2 && alpha_m2 <= highest_m2; }
};
[[nodiscard]] AlphaRange alpha_range(const Airframe& airframe);

/// Values that a grid search tries.
struct Axis {
  double first;
  double last;
  double step;
  [[nodiscard]] std::vector<double> values() const;
};
struct Grid {
  Axis alpha_m2{1.0, 60.0, 1.0};
  Axis beta_m{5.0, 15.0, 0.5};
};

/// The published grid for a rocket's own area; the factor is rounded to two digits, so that the values stay readable.
[[nodiscard]] Grid published_grid(const Airframe& airframe);

/// The mean absolute angle error of every cell of a grid.
struct ErrorMap {
  std::vector<double> alpha_m2{};
  std::vector<double> beta_m{};
  std::vector<double> mean_abs_angle_error_rad{};  ///< [j * alpha.size() + i] for alpha[i], beta[j]
};

/// What a model says about a record, and how far off it is.
struct Simulation {
  std::vector<double> roll_angle_rad{};
  std::vector<double> roll_rate_rad_s{};
  std::vector<double> canard_rad{};  ///< closed loop: the command; open loop: as measured
  double mean_abs_angle_error_rad = 0.0;
  double mean_abs_rate_error_rad_s = 0.0;
  double rms_angle_error_rad = 0.0;

  /// Fills in the errors.
  void compare_with(const Record& record);
};

/// How much the modelled angle (or rate) of every sample moves when one number of the model does. A row a sample.
struct Sensitivities {
  Eigen::MatrixXd numbers;      ///< columns: alpha, beta, nodes
  Eigen::MatrixXd start_angle;  ///< a column a segment
  Eigen::MatrixXd start_rate;   ///< likewise
  Eigen::MatrixXd lag{};  ///< of the canard column, where it is fitted; of the servo: its lag, and half of its play
};

}  // namespace fantail::identify::model
