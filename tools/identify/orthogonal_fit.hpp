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
  /// Works in `columns` itself: the first `explaining` columns become orthogonal, from the last of them to the first,
  /// and the others lose all that those explain. A column that the ones behind it explain already (to 1e-10 of its
  /// length) is left out: its coefficient is zero. Zeros that the later columns begin with are not computed with:
  /// responses to late nodes begin so.
  OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining);

  /// Coefficients of the explaining columns for the explained column `side`, counted from 0.
  [[nodiscard]] Eigen::VectorXd coefficients(Eigen::Index side) const;

  /// Length that an explained column had before, from what was left of it.
  [[nodiscard]] double length_before(const Eigen::Ref<const Eigen::VectorXd>& rest, Eigen::Index side) const;

 private:
  Eigen::Index explaining_;
  Eigen::MatrixXd parts_;    // how much of the row's direction is in each column
  Eigen::VectorXd squared_;  // length of each direction, squared
  std::vector<bool> left_out_;
};

}  // namespace fantail::identify
