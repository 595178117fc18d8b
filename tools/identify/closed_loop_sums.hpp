// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "identify/closed_loop_lanes.hpp"
#include "identify/levenberg_marquardt.hpp"

namespace fantail::identify {

/// Sink of fly_lanes: how far off the angle is.
template <std::size_t lanes>
class ErrorSums {
 public:
  explicit ErrorSums(const Record& record) : angle_rad_{record.roll_angle_rad} {}

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
    for (NormalEquations& equations : equations_) {
      equations.normal = Eigen::MatrixXd::Zero(size, size);
      equations.gradient = Eigen::VectorXd::Zero(size);
    }
  }

  void clear() {
    for (NormalEquations& equations : equations_) {
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

  [[nodiscard]] NormalEquations& equations(std::size_t lane) { return equations_[lane]; }

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
  std::array<NormalEquations, lanes> equations_{};
};

}  // namespace fantail::identify
