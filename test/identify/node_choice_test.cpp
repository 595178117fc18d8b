// SPDX-License-Identifier: MIT
#include "identify/node_choice.hpp"

#include <variant>

#include <gtest/gtest.h>

#include "identify/axis_text.hpp"
#include "identify/flown_log.hpp"
#include "identify/make_record.hpp"
#include "logs/refused.hpp"

namespace fantail::identify {
namespace {

using sim::InputFault;
using test::expect_refused;
using test::flown_log;

// 1 s to 9 s on the log's clock; burn-out at 4 s.
Record record() { return make_record(flown_log(), find_window(flown_log(), "control"), {}); }

TEST(NodeChoice, MayBeTimesInTheRecord) {
  EXPECT_EQ(std::get<NodeTimes>(find_nodes(flown_log(), record(), "0,5")), (NodeTimes{0.0, 5.0}));
  EXPECT_EQ(std::get<NodeTimes>(find_nodes(flown_log(), record(), "2.5")), (NodeTimes{2.5}));
}

TEST(NodeChoice, MayBeEvenOrAutomatic) {
  EXPECT_EQ(std::get<EvenNodes>(find_nodes(flown_log(), record(), "even:3")).intervals, 3U);
  EXPECT_EQ(std::get<EvenNodes>(find_nodes(flown_log(), record(), "even:0")).intervals, 0U);
  EXPECT_EQ(std::get<AutomaticNodes>(find_nodes(flown_log(), record(), "auto")).most, 6U);
}

TEST(NodeChoice, MayDivideThrustAndCoast) {
  const NodeTimes nodes = std::get<NodeTimes>(find_nodes(flown_log(), record(), "thrust:2,coast:2"));
  ASSERT_EQ(nodes.size(), 5U);
  const NodeTimes expected{0.0, 1.5, 3.0, 5.5, 8.0};
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_NEAR(nodes[k], expected[k], 1e-9);
  }
}

TEST(NodeChoice, NeedsToKnowBurnOutForThat) {
  logs::RollLog log = flown_log();
  log.burnout_s = 0.5;
  expect_refused(InputFault::bad_data, {"--nodes thrust:1,coast:1", "burnt out at 0.5 s", "outside the window control"},
                 [&] { (void)find_nodes(log, record(), "thrust:1,coast:1"); });
  log.burnout_s.reset();
  log.specific_force_m_s2.clear();
  expect_refused(InputFault::bad_data, {"when the motor burnt out"},
                 [&] { (void)find_nodes(log, record(), "thrust:1,coast:1"); });
}

TEST(NodeChoice, OfAnotherKindIsRefusedWithTheKindsThereAre) {
  for (const char* text : {"", "5,0", "1,1", "a", "1,", "even:", "even:-1", "even:1.5", "even:1000", "thrust:2",
                           "coast:1,thrust:1", "thrust:0,coast:1", "automatic"}) {
    expect_refused(InputFault::bad_configuration, {"--nodes", text, "even:N; thrust:N,coast:M; auto"},
                   [&] { (void)find_nodes(flown_log(), record(), text); });
  }
}

TEST(Axis, IsReadFromFirstLastAndStep) {
  const auto axis = parse_axis("1:60:0.5");
  ASSERT_TRUE(axis);
  EXPECT_EQ(axis->values().size(), 119U);
  for (const char* text :
       {"", "1", "1:60", "1:60:0", "60:1:1", "0:60:1", "1:60:-1", "a:60:1", "1:60:1:1", "1:60:0.001", "::"}) {
    EXPECT_FALSE(parse_axis(text)) << text;
  }
}

}  // namespace
}  // namespace fantail::identify
