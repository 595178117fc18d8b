// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include <Eigen/Core>

/// What Eigen computes from whole matrices, compiled once: each of these takes the compiler many seconds wherever it is
/// written out.
namespace fantail::linear {

using Columns = Eigen::Ref<const Eigen::MatrixXd>;

[[nodiscard]] Eigen::MatrixXd product(const Columns& left, const Columns& right);

/// The product of the transposed matrix with itself.
[[nodiscard]] Eigen::MatrixXd gram(const Columns& columns);

/// L D L' of a symmetric matrix that is not negative.
class Factors {
 public:
  explicit Factors(const Columns& symmetric);
  ~Factors();
  Factors(const Factors&) = delete;
  Factors& operator=(const Factors&) = delete;

  [[nodiscard]] Eigen::MatrixXd solve(const Columns& right) const;
  [[nodiscard]] Eigen::MatrixXd inverse() const;
  [[nodiscard]] Eigen::VectorXd pivots() const;  ///< D

 private:
  struct Ldlt;
  std::unique_ptr<Ldlt> ldlt_;
};

struct Eigensystem {
  Eigen::VectorXd values;  ///< ascending
  Eigen::MatrixXd vectors;
};
[[nodiscard]] Eigensystem eigensystem(const Columns& symmetric);

/// What of these columns comes closest to the values; columns that others explain get nothing.
[[nodiscard]] Eigen::VectorXd least_squares(const Columns& columns, const Eigen::VectorXd& values);

/// The inverse of a symmetric matrix where there is one; what has no effect gets nothing.
[[nodiscard]] Eigen::MatrixXd pseudo_inverse(const Columns& symmetric);

}  // namespace fantail::linear
