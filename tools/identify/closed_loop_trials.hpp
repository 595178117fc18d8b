// SPDX-License-Identifier: MIT
#pragma once

#include "identify/closed_loop_sums.hpp"

namespace fantail::identify {

/// The controller counts in single precision: a tenth of a microradian. Errors below it are as good as none.
inline constexpr double single_precision_rad2 = 1e-14;

/// Nodes and, with Start::fitted, angle and rate at the begin of each segment.
[[nodiscard]] Eigen::VectorXd unknown_of(const Model& model, Start start);

/// The model with these; without Start::fitted its segments begin as measured.
[[nodiscard]] Model model_of(const Record& record, const NodeTimes& node_time_s, Start start, double alpha_m2,
                             double beta_m, const Eigen::VectorXd& unknown);

/// Flies a few trials of one alpha at a time and says how far off each is; allocates nothing once it stands.
template <std::size_t lanes>
class LaneTrials {
 public:
  LaneTrials(const Course& course, const Unknowns& unknowns)
      : course_{course}, tangents_{unknowns, course.node_count}, normal_{course, tangents_}, errors_{*course.record} {
    points_.node_rad.resize(course.node_count);
    for (std::size_t segment = 0; segment < course.segments(); ++segment) {
      const std::size_t begin = course.segment_begin(segment);
      points_.angle_rad.emplace_back().fill(course.record->roll_angle_rad[begin]);
      points_.rate_rad_s.emplace_back().fill(course.record->roll_rate_rad_s[begin]);
    }
  }

  [[nodiscard]] const Course& course() const { return course_; }

  /// `unknown`: the nodes and what comes behind them.
  template <class Vector>
  void set(std::size_t lane, double beta_m, const Vector& unknown) {
    points_.beta_m[lane] = beta_m;
    Eigen::Index i = 0;
    for (Lane<lanes>& node : points_.node_rad) {
      node[lane] = unknown(i++);
    }
    if (tangents_.unknowns.initial) {
      for (std::size_t segment = 0; segment < course_.segments(); ++segment) {
        points_.angle_rad[segment][lane] = unknown(i++);
        points_.rate_rad_s[segment][lane] = unknown(i++);
      }
    }
  }

  void fly_with_derivatives(const Transitions& transitions) {
    normal_.clear();
    fly_lanes<lanes, true>(course_, transitions, points_, &tangents_, normal_);
  }
  [[nodiscard]] NormalEquations& equations(std::size_t lane) { return normal_.equations(lane); }

  void fly(const Transitions& transitions) {
    errors_.clear();
    fly_lanes<lanes, false>(course_, transitions, points_, nullptr, errors_);
  }
  [[nodiscard]] const ErrorSums<lanes>& errors() const { return errors_; }

 private:
  const Course& course_;
  LanePoints<lanes> points_{};
  Tangents<lanes> tangents_;
  NormalSums<lanes> normal_;
  ErrorSums<lanes> errors_;
};

}  // namespace fantail::identify
