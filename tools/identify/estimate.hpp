// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "identify/record.hpp"

namespace fantail::identify {

enum class Method : std::uint8_t { grid, continuous };
enum class Loop : std::uint8_t { open, closed };

/// Times of the disturbance's nodes in a record, strictly increasing, at least one (then the disturbance is constant).
/// Straight between nodes, constant before the first and after the last.
using NodeTimes = std::vector<double>;

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

/// Roll state at the begin of a segment.
struct InitialState {
  double angle_rad;
  double rate_rad_s;
};

/// Where a damping constant is looked for. At 0.01 a roll rate outlasts every flight; at 1000 it is gone within a
/// sample.
inline constexpr double lowest_alpha_m2 = 0.01;
inline constexpr double highest_alpha_m2 = 1000.0;

/// One identified roll model (Eq 2-8): damping, torque constant, disturbance.
struct Model {
  double alpha_m2 = 0.0;
  double beta_m = 0.0;
  NodeTimes node_time_s{};
  std::vector<double> node_rad{};       ///< equivalent fin offset at each node
  std::vector<InitialState> initial{};  ///< one for each segment of the record
};

/// What a model says about a record, and how far off it is.
struct Simulation {
  std::vector<double> roll_angle_rad{};
  std::vector<double> roll_rate_rad_s{};
  std::vector<double> canard_rad{};  ///< closed loop: the command; open loop: as measured
  double mean_abs_angle_error_rad = 0.0;
  double mean_abs_rate_error_rad_s = 0.0;
  double rms_angle_error_rad = 0.0;
};

/// The mean absolute angle error of every cell of a grid.
struct ErrorMap {
  std::vector<double> alpha_m2{};
  std::vector<double> beta_m{};
  std::vector<double> mean_abs_angle_error_rad{};  ///< [j * alpha.size() + i] for alpha[i], beta[j]
};

}  // namespace fantail::identify
