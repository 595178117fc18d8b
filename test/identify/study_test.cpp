// SPDX-License-Identifier: MIT
#include "identify/study.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/flight_plan_fields.hpp"
#include "identify/choices.hpp"
#include "identify/flown_log.hpp"
#include "identify/planted_log.hpp"
#include "logs/refused.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

TEST(Study, HasAResultForEachWindowAndMethod) {
  const logs::RollLog log = planted_log({});
  Question question = planted_question("0");
  question.windows = {find_window(log, ":4"), find_window(log, "4:")};
  question.methods = {Method::grid, Method::continuous};
  const Study found = study(log, question);
  EXPECT_EQ(found.data, "planted.csv");
  ASSERT_EQ(found.windows.size(), 2U);
  for (const WindowFindings& window : found.windows) {
    ASSERT_EQ(window.results.size(), 2U);
    EXPECT_EQ(window.results[0].method, Method::grid);
    EXPECT_EQ(window.results[0].model.alpha_m2, 20.0);  // as planted; both stand on the grid
    EXPECT_EQ(window.results[0].model.beta_m, 9.0);
    EXPECT_NEAR(window.results[1].model.alpha_m2, 20.0, 0.2);
    EXPECT_NEAR(window.results[1].model.node_rad[0], -5.0 * radians_per_degree, 0.001);
    EXPECT_TRUE(window.remarks.empty());
  }
  EXPECT_EQ(found.windows[0].record.window, ":4");
  EXPECT_NEAR(found.windows[1].record.window_begin_s, 4.0, 1e-9);
}

TEST(Study, TakesAwayALagThatItWasToldOrFound) {
  logs::RollLog log = planted_log({.sample_hz = 500.0});
  delay_canards(log, 10);
  Question question = planted_question("0");
  question.options.with_error_map = false;
  EXPECT_GT(study(log, question).windows[0].results[0].simulation.mean_abs_angle_error_rad, 2e-3);
  question.record.lag_s = 0.02;
  EXPECT_LT(study(log, question).windows[0].results[0].simulation.mean_abs_angle_error_rad, 2e-4);
  question.record.lag_s = 0.0;
  question.fit_lag = true;
  const Study found = study(log, question);
  EXPECT_TRUE(found.windows[0].lag_is_fitted);
  EXPECT_NEAR(found.windows[0].lag_s, 0.02, 0.0005);
  EXPECT_LT(found.windows[0].results[0].simulation.mean_abs_angle_error_rad, 2e-4);
}

TEST(Study, SaysThatThereAreGaps) {
  logs::RollLog log = planted_log({});
  test::cut_out(log, 3.005, 3.495);
  const Study found = study(log, planted_question());
  ASSERT_EQ(found.windows[0].remarks.size(), 1U);
  EXPECT_NE(found.windows[0].remarks[0].find("1 gap"), std::string::npos);
}

TEST(Study, OfAClosedLoopNeedsTheReference) {
  Question question = planted_question();
  question.options.closed_loop = closed_loop::Control{.controller = core::default_plan().controller};
  test::expect_refused(text::ErrorKind::bad_data, {"planted.csv", "no column reference_deg", "window all"},
                       [&] { (void)study(planted_log({}), question); });
}

TEST(Study, OfAClosedLoopSaysThatTheLawThatFlewIsNotTheOneAskedFor) {
  Question question = planted_question();
  question.options.closed_loop = closed_loop::Control{.controller = core::default_plan().controller};
  logs::RollLog log = planted_log({.seconds = 1.0});
  log.reference_rad = log.excitation_rad = std::vector<double>(log.time_s.size(), 0.0);
  const auto says = [&](double estimate_rad) {
    log.offset_estimate_rad.assign(log.time_s.size(), estimate_rad);
    const Study found = study(log, question);
    return std::ranges::any_of(found.windows[0].remarks,
                               [](const std::string& remark) { return remark.find("estimate") != std::string::npos; });
  };
  EXPECT_TRUE(says(0.01));
  EXPECT_FALSE(says(0.0));
}

TEST(Study, PassesTheWarningsOfTheLogOn) {
  logs::RollLog log = planted_log({});
  log.warnings = {"a doubt"};
  EXPECT_EQ(study(log, planted_question()).warnings, (std::vector<std::string>{"a doubt"}));
}

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
