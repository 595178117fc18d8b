// SPDX-License-Identifier: MIT
#include "identify/lag_fit.hpp"

#include <gtest/gtest.h>

#include "identify/planted_log.hpp"

namespace fantail::identify {
namespace {

// 500 Hz, so a sample is 2 ms.
LagFit fitted(int samples_late, const NodeChoice& nodes = EvenNodes{0}) {
  logs::RollLog log = planted_log({.seconds = 3.0, .sample_hz = 500.0});
  delay_canards(log, samples_late);
  const Question question = planted_question();
  return fit_lag(log, question.windows[0], question.record, tasha, nodes, question.options);
}

TEST(LagFit, FindsByHowMuchTheCanardsAreLate) {
  EXPECT_NEAR(fitted(6).lag_s, 0.012, 0.0005);
  EXPECT_NEAR(fitted(-9).lag_s, -0.018, 0.0005);
  EXPECT_NEAR(fitted(0).lag_s, 0.0, 0.0005);
  EXPECT_FALSE(fitted(6).at_the_edge);
}

TEST(LagFit, TakesOneDisturbanceForAllLagsEvenWhenItsNodesAreAutomatic) {
  EXPECT_NEAR(fitted(6, AutomaticNodes{2}).lag_s, 0.012, 0.0005);
}

TEST(LagFit, SaysWhenTheBestLiesAtTheEdge) {
  const LagFit fit = fitted(40);  // 80 ms
  EXPECT_TRUE(fit.at_the_edge);
  EXPECT_NEAR(fit.lag_s, largest_fitted_lag_s, 0.001);
}

}  // namespace
}  // namespace fantail::identify
