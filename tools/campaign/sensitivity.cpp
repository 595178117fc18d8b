// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "campaign/analysis.hpp"
#include "distributions/quantiles.hpp"
#include "linear/dense.hpp"

namespace fantail::campaign {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd standardised(const std::vector<double>& values) {
  const auto count = static_cast<Index>(values.size());
  const Eigen::Map<const VectorXd> all{values.data(), count};
  const VectorXd centred = all.array() - all.mean();
  return centred / std::sqrt(centred.squaredNorm() / static_cast<double>(count - 1));
}

/// How far the slope lies from either end of its interval, by what it is without each of the runs (Efron and Stein
/// 1981). Few runs far out decide about the variance of the heavy-tailed: the fewer, the less it is known, and so
/// Student's degrees of freedom come from the kurtosis. 1.5: a sample shows too little of a kurtosis.
double jackknife_reach(const VectorXd& without_each, double most_freedom) {
  const auto count = static_cast<double>(without_each.size());
  const VectorXd squares = (without_each.array() - without_each.mean()).square();
  const double sum = squares.sum();
  if (!(sum > 0.0)) {
    return 0.0;
  }
  const double kurtosis = count * squares.squaredNorm() / (sum * sum);
  constexpr double fewest_freedom = 3.0;
  const double freedom = 2.0 * count / (1.5 * std::max(kurtosis - 1.0, 1e-3));
  return distributions::student_975(std::clamp(freedom, fewest_freedom, std::max(fewest_freedom, most_freedom))) *
         std::sqrt((count - 1.0) / count * sum);
}

}  // namespace

Sensitivity sensitivity(const std::vector<std::vector<double>>& quantities, const std::vector<double>& result) {
  const auto runs = static_cast<Index>(result.size());
  const auto count = static_cast<Index>(quantities.size());
  MatrixXd x{runs, count};
  for (Index i = 0; i < count; ++i) {
    x.col(i) = standardised(quantities[static_cast<std::size_t>(i)]);
  }
  const VectorXd y = standardised(result);
  const linear::Factors normal_equations{linear::gram(x)};
  const VectorXd slopes = linear::least_squares(x, y);
  const VectorXd rest = y - x * slopes;
  const auto freedom = static_cast<double>(runs - count - 1);
  Sensitivity all{.slopes = std::vector<std::optional<Estimate>>(quantities.size()),
                  .explained = 1.0 - rest.squaredNorm() / freedom};
  // Of a quantity that the others explain, or of a run that the others say nothing of.
  constexpr double as_good_as_nothing = 1e-9;
  const double all_squares = static_cast<double>(runs - 1);  // of each standardised column
  if (!(normal_equations.pivots().minCoeff() > as_good_as_nothing * all_squares)) {
    return all;
  }
  // All without run i, by updates of rank one; its mean is no longer in what is left, hence the factor.
  const double factor = static_cast<double>(runs) / static_cast<double>(runs - 1);
  const MatrixXd pull = linear::product(x, normal_equations.inverse());
  const VectorXd left = 1.0 - factor * (pull.array() * x.array()).rowwise().sum();
  if (left.minCoeff() < as_good_as_nothing) {
    return all;
  }
  const Eigen::ArrayXd y_squares = all_squares - factor * y.array().square();
  for (Index i = 0; i < count; ++i) {
    const Eigen::ArrayXd slope = slopes[i] - factor * pull.col(i).array() * rest.array() / left.array();
    const VectorXd without_each = slope * ((all_squares - factor * x.col(i).array().square()) / y_squares).sqrt();
    const double reach = jackknife_reach(without_each, freedom);
    all.slopes[static_cast<std::size_t>(i)] =
        Estimate{.value = slopes[i], .low = slopes[i] - reach, .high = slopes[i] + reach};
  }
  return all;
}

}  // namespace fantail::campaign
