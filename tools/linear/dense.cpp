// SPDX-License-Identifier: MIT
#include "linear/dense.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace fantail::linear {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Factors::Ldlt {
  Eigen::LDLT<MatrixXd> of;
};

Factors::Factors(const Columns& symmetric) : ldlt_{new Ldlt{Eigen::LDLT<MatrixXd>{symmetric}}} {}

Factors::~Factors() = default;

MatrixXd Factors::solve(const Columns& right) const { return ldlt_->of.solve(right); }

MatrixXd Factors::inverse() const { return solve(MatrixXd::Identity(ldlt_->of.rows(), ldlt_->of.cols())); }

VectorXd Factors::pivots() const { return ldlt_->of.vectorD(); }

MatrixXd product(const Columns& left, const Columns& right) { return left * right; }

MatrixXd gram(const Columns& columns) { return columns.transpose() * columns; }

Eigensystem eigensystem(const Columns& symmetric) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver{symmetric};
  return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors()};
}

VectorXd least_squares(const Columns& columns, const VectorXd& values) {
  return columns.colPivHouseholderQr().solve(values);
}

MatrixXd pseudo_inverse(const Columns& symmetric) {
  const Eigensystem system = eigensystem(symmetric);
  const double size = static_cast<double>(symmetric.rows()) * system.values.cwiseAbs().maxCoeff();
  const double nothing = std::numeric_limits<double>::epsilon() * size;
  MatrixXd inverse = MatrixXd::Zero(symmetric.rows(), symmetric.cols());
  for (Eigen::Index k = 0; k < system.values.size(); ++k) {
    if (std::abs(system.values(k)) > nothing) {
      inverse += system.vectors.col(k) / system.values(k) * system.vectors.col(k).transpose();
    }
  }
  return inverse;
}

}  // namespace fantail::linear
