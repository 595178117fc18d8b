// SPDX-License-Identifier: MIT
#include "identify/orthogonal_fit.hpp"

#include <algorithm>
#include <cmath>

namespace fantail::identify {
namespace {

constexpr Eigen::Index together = 8;  // rows, so that a compiler keeps them in registers

// Rows that are zero from the top on, or a few less.
Eigen::Index leading_zeros(const Eigen::Ref<const Eigen::VectorXd>& column) {
  Eigen::Index zeros = 0;
  while (zeros + together <= column.size() && (column.segment<together>(zeros).array() == 0.0).all()) {
    zeros += together;
  }
  return zeros;
}

// column -= factor * direction
void subtract(Eigen::Ref<Eigen::VectorXd> column, double factor, const Eigen::Ref<const Eigen::VectorXd>& direction) {
  Eigen::Index i = 0;
  for (; i + together <= column.size(); i += together) {
    column.segment<together>(i) -= factor * direction.segment<together>(i);
  }
  const Eigen::Index rest = column.size() - i;
  column.tail(rest) -= factor * direction.tail(rest);
}

}  // namespace

OrthogonalFit::OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining)
    : explaining_{explaining},
      parts_{Eigen::MatrixXd::Zero(explaining, columns.cols())},
      squared_(explaining),
      left_out_(static_cast<std::size_t>(explaining), false) {
  constexpr double explained_already = 1e-10;
  const Eigen::Index sides = columns.cols() - explaining;
  for (Eigen::Index k = explaining - 1; k >= 0; --k) {
    auto lower = columns.bottomRows(columns.rows() - leading_zeros(columns.col(k)));
    const Eigen::VectorXd in_those_before = lower.leftCols(k + 1).transpose() * lower.col(k);
    squared_(k) = in_those_before(k);
    double before = squared_(k);
    for (Eigen::Index i = k + 1; i < explaining; ++i) {
      before += parts_(i, k) * parts_(i, k) * squared_(i);
    }
    if (squared_(k) <= explained_already * explained_already * before) {
      left_out_[static_cast<std::size_t>(k)] = true;
      columns.col(k).setZero();
      continue;
    }
    parts_.row(k).head(k) = in_those_before.head(k).transpose() / squared_(k);
    parts_.row(k).tail(sides) = lower.col(k).transpose() * lower.rightCols(sides) / squared_(k);
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      if (j < k || j >= explaining) {
        subtract(lower.col(j), parts_(k, j), lower.col(k));
      }
    }
  }
}

double OrthogonalFit::length_before(const Eigen::Ref<const Eigen::VectorXd>& rest, Eigen::Index side) const {
  return std::sqrt(rest.squaredNorm() + parts_.col(explaining_ + side).cwiseAbs2().dot(squared_));
}

Eigen::VectorXd OrthogonalFit::coefficients(Eigen::Index side) const {
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(explaining_);
  for (Eigen::Index k = 0; k < explaining_; ++k) {
    if (!left_out_[static_cast<std::size_t>(k)]) {
      solution(k) = parts_(k, explaining_ + side) - parts_.row(k).head(k).dot(solution.head(k));
    }
  }
  return solution;
}

}  // namespace fantail::identify
