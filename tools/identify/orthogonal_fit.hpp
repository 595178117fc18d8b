// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

namespace fantail::identify {

/// Least squares by modified Gram-Schmidt, for many right-hand sides of one matrix. On the sides themselves it leaves
/// what the matrix cannot explain, which here is worth more than the solution: it tells every beta's error without a
/// further solve.
class OrthogonalFit {
 public:
  /// Works in `columns` itself: the first `explaining` columns become orthonormal, the others lose all that those
  /// explain. A column that the ones before it explain already (to 1e-10 of its length) is left out: its coefficient is
  /// zero.
  OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining);

  /// Coefficients of the explaining columns for the explained column `side`, counted from 0.
  [[nodiscard]] Eigen::VectorXd coefficients(Eigen::Index side) const;

  /// Length of an explained column before.
  [[nodiscard]] double length_before(Eigen::Index side) const { return length_(explaining_ + side); }

 private:
  Eigen::Index explaining_;
  Eigen::MatrixXd r_;  // upper triangle, then the sides' parts along each direction
  Eigen::VectorXd length_;
  std::vector<bool> left_out_;
};

}  // namespace fantail::identify
