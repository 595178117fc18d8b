// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "identify/closed_loop/lanes.hpp"
#include "identify/model/least_squares.hpp"

namespace fantail::identify::closed_loop {

/// Sink of fly_lanes: how far off the angle is.
template <std::size_t lanes>
class ErrorSums {
 public:
  explicit ErrorSums(const model::Record& record) : angle_rad_{record.roll_angle_rad} {}

  void clear() {
    squares_.fill(0.0);
    absolutes_.fill(0.0);
  }

  void at_sample(std::size_t sample, const Lane<lanes>& angle_rad, const Lane<lanes>& /*rate_rad_s*/) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double error = angle_rad[l] - angle_rad_[sample];
      squares_[l] += error * error;
      absolutes_[l] += std::abs(error);
    }
  }
  void at_command(std::size_t /*sample*/, const Lane<lanes>& /*command_rad*/) {}
  void end_segment(std::size_t /*segment*/) {}

  [[nodiscard]] double squares(std::size_t lane) const { return squares_[lane]; }
  [[nodiscard]] double mean_absolute(std::size_t lane) const {
    return absolutes_[lane] / static_cast<double>(angle_rad_.size());
  }

 private:
  const std::vector<double>& angle_rad_;
  Lane<lanes> squares_{};
  Lane<lanes> absolutes_{};
};

/// Sink of fly_lanes: the normal equations of the squared angle error.
template <std::size_t lanes>
class NormalSums {
 public:
  NormalSums(const Course& course, const Tangents<lanes>& tangents)
      : angle_rad_{course.record->roll_angle_rad}, tangents_{tangents}, node_count_{course.node_count} {
    const std::size_t columns = tangents.angle.size();
    products_.resize(columns * (columns + 1) / 2);
    gradient_.resize(columns);
    const auto size = static_cast<Eigen::Index>(tangents.unknowns.count(node_count_, course.segments()));
    for (model::NormalEquations& equations : equations_) {
      equations.normal = Eigen::MatrixXd::Zero(size, size);
      equations.gradient = Eigen::VectorXd::Zero(size);
    }
  }

  void clear() {
    for (model::NormalEquations& equations : equations_) {
      equations.squares = 0.0;
      equations.normal.setZero();
      equations.gradient.setZero();
    }
    clear_segment();
  }

  void at_sample(std::size_t sample, const Lane<lanes>& angle_rad, const Lane<lanes>& /*rate_rad_s*/) {
    Lane<lanes> error;
    for (std::size_t l = 0; l < lanes; ++l) {
      error[l] = angle_rad[l] - angle_rad_[sample];
      equations_[l].squares += error[l] * error[l];
    }
    Lane<lanes>* product = products_.data();
    for (std::size_t column = 0; column < tangents_.active; ++column) {
      const Lane<lanes> by_column = tangents_.angle[column];
      for (std::size_t l = 0; l < lanes; ++l) {
        gradient_[column][l] += by_column[l] * error[l];
      }
      for (std::size_t other = 0; other <= column; ++other, ++product) {
        const Lane<lanes>& by_other = tangents_.angle[other];
        for (std::size_t l = 0; l < lanes; ++l) {
          (*product)[l] += by_column[l] * by_other[l];
        }
      }
    }
  }
  void at_command(std::size_t /*sample*/, const Lane<lanes>& /*command_rad*/) {}

  void end_segment(std::size_t segment) {
    std::size_t product = 0;
    for (std::size_t column = 0; column < tangents_.active; ++column) {
      const Eigen::Index row = place(column, segment);
      for (std::size_t other = 0; other <= column; ++other, ++product) {
        const Eigen::Index beside = place(other, segment);
        for (std::size_t l = 0; l < lanes; ++l) {
          equations_[l].normal(row, beside) += products_[product][l];
          if (row != beside) {
            equations_[l].normal(beside, row) += products_[product][l];
          }
        }
      }
      for (std::size_t l = 0; l < lanes; ++l) {
        equations_[l].gradient(row) += gradient_[column][l];
      }
    }
    clear_segment();
  }

  [[nodiscard]] model::NormalEquations& equations(std::size_t lane) { return equations_[lane]; }

 private:
  void clear_segment() {
    std::ranges::fill(products_, Lane<lanes>{});
    std::ranges::fill(gradient_, Lane<lanes>{});
  }

  [[nodiscard]] Eigen::Index place(std::size_t column, std::size_t segment) const {
    return static_cast<Eigen::Index>(tangents_.unknowns.place(column, tangents_.first_node, node_count_, segment));
  }

  const std::vector<double>& angle_rad_;
  const Tangents<lanes>& tangents_;
  std::size_t node_count_;
  std::vector<Lane<lanes>> products_{};  ///< lower triangle, row by row
  std::vector<Lane<lanes>> gradient_{};
  std::array<model::NormalEquations, lanes> equations_{};
};

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

  void fly_with_derivatives(const Plant& plant) {
    normal_.clear();
    fly_lanes<lanes, true>(course_, plant, points_, &tangents_, normal_);
  }
  [[nodiscard]] model::NormalEquations& equations(std::size_t lane) { return normal_.equations(lane); }

  void fly(const Plant& plant) {
    errors_.clear();
    fly_lanes<lanes, false>(course_, plant, points_, nullptr, errors_);
  }
  [[nodiscard]] const ErrorSums<lanes>& errors() const { return errors_; }

 private:
  const Course& course_;
  LanePoints<lanes> points_{};
  Tangents<lanes> tangents_;
  NormalSums<lanes> normal_;
  ErrorSums<lanes> errors_;
};

}  // namespace fantail::identify::closed_loop
