// SPDX-License-Identifier: MIT
// The disturbance bends when it bends, on the log's clock: whatever a lag takes off the window's begin, nodes stay.
#include <cmath>

#include <gtest/gtest.h>

#include "identify/planted_log.hpp"
#include "identify/study.hpp"

namespace fantail::identify {
namespace {

using namespace model;
using namespace result;

// The log's clock begins at 2 s, so these bend at 2, 2.5, 3, 3.5 and 4 s.
const Planting bent{.node_time_s = {0.0, 0.5, 1.0, 1.5, 2.0},
                    .node_deg = {0.0, -12.0, 0.0, -12.0, 0.0},
                    .seconds = 2.0,
                    .sample_hz = 500.0};
constexpr const char* bends = "2,2.5,3,3.5,4";

Question asked(const char* nodes) {
  Question question = planted_question(nodes);
  question.options.with_error_map = false;
  return question;
}

TEST(LogClock, NodesStayWhereTheyAreWhenAnEarlyCanardColumnCutsTheBeginOff) {
  logs::RollLog log = planted_log(bent);
  delay_canards(log, -20);
  Question question = asked(bends);
  question.record.lag_s = -0.04;
  const WindowFindings found = study(log, question).windows[0];
  EXPECT_NEAR(found.record.window_begin_s, 2.04, 1e-9);
  EXPECT_NEAR(found.results[0].model.alpha_m2, 20.0, 0.1);
}

TEST(LogClock, NodesStayWhereTheyAreWhenTheLagIsFitted) {
  logs::RollLog log = planted_log(bent);
  delay_canards(log, 10);
  Question question = asked(bends);
  question.fit_lag = true;
  const WindowFindings found = study(log, question).windows[0];
  EXPECT_NEAR(found.lag_s, 0.02, 1e-4);
  EXPECT_NEAR(found.results[0].model.alpha_m2, 20.0, 0.1);
}

TEST(LogClock, EvenNodesDivideTheWindowAsItWasAskedFor) {
  logs::RollLog log = planted_log(bent);
  delay_canards(log, -20);
  Question question = asked("even:4");
  question.record.lag_s = -0.04;
  EXPECT_NEAR(study(log, question).windows[0].results[0].model.alpha_m2, 20.0, 0.1);
}

TEST(LogClock, CountsForALaterWindow) {
  const logs::RollLog log = planted_log(bent);
  Question question = asked("2.5,3,3.5,4");
  question.windows = {{.from_s = 2.5, .to_s = 4.0}};
  EXPECT_NEAR(study(log, question).windows[0].results[0].model.alpha_m2, 20.0, 0.1);
}

}  // namespace
}  // namespace fantail::identify
