// SPDX-License-Identifier: MIT
#include "identify/orthogonal_fit.hpp"

namespace fantail::identify {

OrthogonalFit::OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining)
    : explaining_{explaining},
      r_{Eigen::MatrixXd::Zero(explaining, columns.cols())},
      length_{columns.colwise().norm().transpose()},
      left_out_(static_cast<std::size_t>(explaining), false) {
  constexpr double explained_already = 1e-10;
  for (Eigen::Index k = 0; k < explaining; ++k) {
    const double length = columns.col(k).norm();
    if (length <= explained_already * length_(k)) {
      left_out_[static_cast<std::size_t>(k)] = true;
      columns.col(k).setZero();
      continue;
    }
    r_(k, k) = length;
    columns.col(k) /= length;
    for (Eigen::Index j = k + 1; j < columns.cols(); ++j) {
      r_(k, j) = columns.col(k).dot(columns.col(j));
      columns.col(j) -= r_(k, j) * columns.col(k);
    }
  }
}

Eigen::VectorXd OrthogonalFit::coefficients(Eigen::Index side) const {
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(explaining_);
  for (Eigen::Index k = explaining_ - 1; k >= 0; --k) {
    if (!left_out_[static_cast<std::size_t>(k)]) {
      double rest = r_(k, explaining_ + side);
      for (Eigen::Index j = k + 1; j < explaining_; ++j) {
        rest -= r_(k, j) * solution(j);
      }
      solution(k) = rest / r_(k, k);
    }
  }
  return solution;
}

}  // namespace fantail::identify
