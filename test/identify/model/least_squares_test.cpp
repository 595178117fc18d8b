// SPDX-License-Identifier: MIT
#include "identify/model/least_squares.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fantail::identify::model {
namespace {

NormalEquations equations(const Eigen::VectorXd& residual, const Eigen::MatrixXd& derivatives) {
  return {.squares = residual.squaredNorm(),
          .normal = derivatives.transpose() * derivatives,
          .gradient = derivatives.transpose() * residual};
}

// Rosenbrock's valley: residuals 10 (y - x^2) and 1 - x, both zero at (1, 1).
NormalEquations valley(const Eigen::VectorXd& at) {
  const Eigen::Vector2d residual{10.0 * (at(1) - at(0) * at(0)), 1.0 - at(0)};
  const Eigen::Matrix2d derivatives{{-20.0 * at(0), 10.0}, {-1.0, 0.0}};
  return equations(residual, derivatives);
}

TEST(LevenbergMarquardt, FollowsACurvedValleyToItsEnd) {
  LevenbergMarquardt search{Eigen::Vector2d{-1.2, 1.0}, {.absolute_gain = 1e-20}};
  while (!search.finished()) {
    search.tell(valley(search.trial()));
  }
  EXPECT_NEAR(search.best()(0), 1.0, 1e-8);
  EXPECT_NEAR(search.best()(1), 1.0, 1e-8);
  EXPECT_LT(search.squares(), 1e-16);
}

TEST(LevenbergMarquardt, TheSumNeverRises) {
  LevenbergMarquardt search{Eigen::Vector2d{-1.2, 1.0}, {}};
  double before = std::numeric_limits<double>::infinity();
  while (!search.finished()) {
    search.tell(valley(search.trial()));
    EXPECT_LE(search.squares(), before);
    before = search.squares();
  }
}

// A straight line through (0, 1), (1, 3), (2, 5), (3, 7.4): by hand, slope 2.12 and intercept 0.92.
TEST(LevenbergMarquardt, WithoutDampingALinearProblemTakesOneStep) {
  const Eigen::Matrix<double, 4, 2> derivatives{{1.0, 0.0}, {1.0, 1.0}, {1.0, 2.0}, {1.0, 3.0}};
  const Eigen::Vector4d data{1.0, 3.0, 5.0, 7.4};
  LevenbergMarquardt search{Eigen::Vector2d{0.0, 0.0}, {.first_damping = 0.0}};
  search.tell(equations(derivatives * search.trial() - data, derivatives));
  EXPECT_NEAR(search.trial()(0), 0.92, 1e-12);
  EXPECT_NEAR(search.trial()(1), 2.12, 1e-12);
  const double sum = (derivatives * search.trial() - data).squaredNorm();
  EXPECT_NEAR(search.promised_gain(), search.squares() - sum, 1e-12);
  search.tell(equations(derivatives * search.trial() - data, derivatives));
  EXPECT_TRUE(search.finished());
  EXPECT_NEAR(search.squares(), sum, 1e-12);
}

TEST(LevenbergMarquardt, AnUnknownThatNothingDependsOnStaysWhereItIs) {
  LevenbergMarquardt search{Eigen::Vector2d{3.0, 7.0}, {}};
  while (!search.finished()) {
    const Eigen::Vector2d residual{search.trial()(0) - 1.0, 0.5};
    search.tell(equations(residual, Eigen::Matrix2d{{1.0, 0.0}, {0.0, 0.0}}));
  }
  EXPECT_NEAR(search.best()(0), 1.0, 1e-6);
  EXPECT_EQ(search.best()(1), 7.0);
}

// The residual is ln x: a step below zero cannot be computed, and the search must come back from it.
TEST(LevenbergMarquardt, ComesBackFromATrialThatMayNotBe) {
  LevenbergMarquardt search{Eigen::VectorXd::Constant(1, 20.0), {.absolute_gain = 1e-20}};
  bool refused = false;
  while (!search.finished()) {
    const double x = search.trial()(0);
    if (x <= 0.0) {
      refused = true;
      search.tell({.squares = std::numeric_limits<double>::infinity()});
    } else {
      search.tell(equations(Eigen::VectorXd::Constant(1, std::log(x)), Eigen::MatrixXd::Constant(1, 1, 1.0 / x)));
    }
  }
  EXPECT_TRUE(refused);
  EXPECT_NEAR(search.best()(0), 1.0, 1e-8);
}

TEST(LevenbergMarquardt, AStartThatMayNotBeEndsTheSearchThere) {
  LevenbergMarquardt search{Eigen::Vector2d{1.0, 2.0}, {}};
  search.tell({.squares = std::numeric_limits<double>::quiet_NaN()});
  EXPECT_TRUE(search.finished());
  EXPECT_TRUE(std::isinf(search.squares()));
  EXPECT_EQ(search.best()(1), 2.0);
}

TEST(Minimum, OfAParabolaIsItsVertex) {
  EXPECT_NEAR(least_over([](double x) { return (x - 0.3) * (x - 0.3) + 2.0; }, {.low = -5, .high = 5}, 4), 0.3, 1e-5);
}

TEST(Minimum, OfTwoValleysIsTheDeeperOne) {
  const auto valleys = [](double x) {
    return -std::exp(-20.0 * (x - 1.0) * (x - 1.0)) - 1.5 * std::exp(-20.0 * (x - 8.0) * (x - 8.0));
  };
  EXPECT_NEAR(least_over(valleys, {.low = 0, .high = 10}, 21), 8.0, 1e-5);
}

TEST(Minimum, OfASlopeIsItsEnd) {
  EXPECT_NEAR(least_over([](double x) { return x; }, {.low = 2, .high = 3}, 5), 2.0, 1e-5);
}

TEST(OrthogonalFit, FindsTheCoefficientsAndLeavesWhatIsAtRightAngles) {
  Eigen::MatrixXd columns(4, 3);
  columns << 1, 0, 7,  //
      1, 1, 9,         //
      1, 2, 11,        //
      1, 3, 13;
  columns.col(2) += Eigen::Vector4d{1, -1, -1, 1};  // at right angles to both
  const OrthogonalFit fit{columns, 2};
  EXPECT_NEAR(fit.coefficients(0)(0), 7.0, 1e-13);
  EXPECT_NEAR(fit.coefficients(0)(1), 2.0, 1e-13);
  EXPECT_NEAR((columns.col(2) - Eigen::Vector4d{1, -1, -1, 1}).norm(), 0.0, 1e-13);
}

TEST(OrthogonalFit, AColumnThatSaysNothingNewIsLeftOut) {
  Eigen::MatrixXd columns(3, 3);
  columns << 1, 2, 3,  //
      1, 2, 4,         //
      1, 2, 5;
  const OrthogonalFit fit{columns, 2};
  EXPECT_EQ(fit.coefficients(0)(0), 0.0);
  EXPECT_NEAR(fit.coefficients(0)(1), 2.0, 1e-13);
}

TEST(OrthogonalFit, ColumnsThatBeginWithZerosAreFittedLikeAnyOther) {
  constexpr Eigen::Index rows = 50;
  Eigen::MatrixXd columns(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto t = static_cast<double>(i);
    columns.row(i) << 1.0 + t, (i < 30 ? 0.0 : t), (i < 41 ? 0.0 : t * t);
  }
  const Eigen::MatrixXd before = columns;
  Eigen::MatrixXd all(rows, 4);
  all << columns, 3.0 * before.col(0) - 2.0 * before.col(1) + 0.5 * before.col(2);
  const OrthogonalFit fit{all, 3};
  const Eigen::VectorXd found = fit.coefficients(0);
  EXPECT_NEAR(found(0), 3.0, 1e-11);
  EXPECT_NEAR(found(1), -2.0, 1e-11);
  EXPECT_NEAR(found(2), 0.5, 1e-11);
  EXPECT_NEAR(all.col(3).norm(), 0.0, 1e-10);
}

}  // namespace
}  // namespace fantail::identify::model
