// SPDX-License-Identifier: MIT
#include "identify/levenberg_marquardt.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace fantail::identify {
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

}  // namespace
}  // namespace fantail::identify
