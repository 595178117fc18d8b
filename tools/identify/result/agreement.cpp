// SPDX-License-Identifier: MIT
#include "identify/result/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/LU>

#include "distributions/quantiles.hpp"
#include "identify/result/uncertainty.hpp"

namespace fantail::identify::result {
namespace {

double limit(std::size_t numbers, double fewest_degrees_of_freedom) {
  const double widening = distributions::student_975(fewest_degrees_of_freedom) / distributions::normal_975;
  return widening * widening * distributions::chi_square_quantile(0.95, static_cast<double>(numbers));
}

}  // namespace

Constants constants_of(const Identification& result) {
  const Uncertainty& u = *result.uncertainty;
  const Eigen::Vector2d deviation{u.standard_deviation[0], u.standard_deviation[1]};
  return {.value = {result.model.alpha_m2, result.model.beta_m},
          .covariance = deviation.asDiagonal() * u.correlation.topLeftCorner<2, 2>() * deviation.asDiagonal(),
          .degrees_of_freedom = u.degrees_of_freedom};
}

Interval interval_of(const Constants& constants, Eigen::Index which) {
  const double reach =
      distributions::student_975(constants.degrees_of_freedom) * std::sqrt(constants.covariance(which, which));
  return {.low = constants.value(which) - reach, .high = constants.value(which) + reach};
}

Agreement agreement(const std::vector<Constants>& estimates) {
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  Eigen::Vector2d weighted = Eigen::Vector2d::Zero();
  double fewest = std::numeric_limits<double>::infinity();
  for (const Constants& one : estimates) {
    const Eigen::Matrix2d inverse = one.covariance.inverse();
    information += inverse;
    weighted += inverse * one.value;
    fewest = std::min(fewest, one.degrees_of_freedom);
  }
  const Eigen::Vector2d mean = information.inverse() * weighted;
  Agreement result;
  for (const Constants& one : estimates) {
    const Eigen::Vector2d away = one.value - mean;
    result.chi_square += away.dot(one.covariance.inverse() * away);
  }
  result.limit = limit(2 * (estimates.size() - 1), fewest);
  return result;
}

Agreement difference(const Constants& a, const Constants& b) {
  const Eigen::Vector2d away = a.value - b.value;
  const Eigen::Matrix2d covariance = a.covariance + b.covariance;
  return {.chi_square = away.dot(covariance.inverse() * away),
          .limit = limit(2, std::min(a.degrees_of_freedom, b.degrees_of_freedom))};
}

bool JointFindings::determines_both() const {
  return is_identifiable(interval_of(together, 0)) && is_identifiable(interval_of(together, 1));
}

double JointFindings::largest_difference() const {
  double largest = 0.0;
  for (const JointWindow& window : windows) {
    const Uncertainty& own = *window.own.uncertainty;
    if (own.alpha_identifiable && own.beta_identifiable) {
      const Eigen::Vector2d away = constants_of(window.own).value - together.value;
      largest = std::max(largest, away.cwiseQuotient(together.value).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

bool JointFindings::are_of_one_rocket() const {
  const bool all_known = std::ranges::all_of(windows, [](const JointWindow& window) {
    return window.own.uncertainty->alpha_identifiable && window.own.uncertainty->beta_identifiable;
  });
  return agreement.agree() || (all_known && largest_difference() < no_matter);
}

bool ValidatedWindow::can_tell() const {
  return own.uncertainty->alpha_identifiable && own.uncertainty->beta_identifiable;
}

double ValidatedWindow::largest_difference() const {
  const model::RollModel& known = window.results.front().model;
  return std::max(std::abs(known.alpha_m2 / own.model.alpha_m2 - 1.0), std::abs(known.beta_m / own.model.beta_m - 1.0));
}

bool ValidatedWindow::holds() const { return agreement.agree() || largest_difference() < no_matter; }

}  // namespace fantail::identify::result
