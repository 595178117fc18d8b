// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "identify/minimum.hpp"
#include "identify/node_times.hpp"
#include "identify/orthogonal_fit.hpp"
#include "identify/planted.hpp"
#include "sim/input_error.hpp"

namespace fantail::identify {
namespace {

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

TEST(NodeTimes, SharesRunStraightBetweenNodesAndStayOutside) {
  const NodeTimes nodes{1.0, 3.0, 4.0};
  EXPECT_EQ(node_share(nodes, 0.0).left, 0U);
  EXPECT_EQ(node_share(nodes, 0.0).right_share, 0.0);
  const NodeShare middle = node_share(nodes, 1.5);
  EXPECT_EQ(middle.left, 0U);
  EXPECT_EQ(middle.right, 1U);
  EXPECT_DOUBLE_EQ(middle.right_share, 0.25);
  EXPECT_EQ(node_share(nodes, 9.0).right, 2U);
}

TEST(NodeTimes, EvenOnesEndWithTheRecord) {
  const Record record = planted_record({.seconds = 4.0});
  EXPECT_EQ(even_nodes(record, 4), (NodeTimes{0.0, 1.0, 2.0, 3.0, 4.0}));
  EXPECT_EQ(even_nodes(record, 0), NodeTimes{0.0});
}

TEST(NodeTimes, OneThatNoSampleTellsIsRefused) {
  const Record record = planted_record({.seconds = 4.0});
  EXPECT_NO_THROW(check_nodes(record, {0.0, 5.0}));
  EXPECT_THROW(check_nodes(record, {0.0, 5.0, 6.0}), sim::InputError);
  EXPECT_THROW(check_nodes(record, {0.0, 0.0}), sim::InputError);
  EXPECT_THROW(check_nodes(record, {}), sim::InputError);
}

}  // namespace
}  // namespace fantail::identify
