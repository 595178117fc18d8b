// SPDX-License-Identifier: MIT
#include "identify/model/roll_model.hpp"

#include <gtest/gtest.h>

#include "identify/model/planted.hpp"
#include "text/error.hpp"

namespace fantail::identify::model {
namespace {

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
  EXPECT_THROW(check_nodes(record, {0.0, 5.0, 6.0}), text::Error);
  EXPECT_THROW(check_nodes(record, {0.0, 0.0}), text::Error);
  EXPECT_THROW(check_nodes(record, {}), text::Error);
}

}  // namespace
}  // namespace fantail::identify::model
