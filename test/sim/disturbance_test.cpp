// SPDX-License-Identifier: MIT
#include "sim/disturbance.hpp"

#include "seed.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

// Straight from the definition: walks all segments.
double naive(const std::vector<DisturbanceNode>& nodes, double time_s) {
  if (time_s <= nodes.front().time_s) {
    return nodes.front().angle_rad;
  }
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    if (time_s < nodes[i + 1].time_s) {
      const double share = (time_s - nodes[i].time_s) / (nodes[i + 1].time_s - nodes[i].time_s);
      return (1.0 - share) * nodes[i].angle_rad + share * nodes[i + 1].angle_rad;
    }
  }
  return nodes.back().angle_rad;
}

TEST(Disturbance, IsZeroWithoutNodes) {
  EXPECT_EQ(Disturbance{}.at(3.0), 0.0);
  EXPECT_EQ(Disturbance{std::vector<DisturbanceNode>{}}.at(-3.0), 0.0);
}

TEST(Disturbance, OneNodeIsAConstant) {
  const Disturbance constant{{{2.0, -0.1}}};
  for (const double time_s : {-100.0, 2.0, 100.0}) {
    EXPECT_EQ(constant.at(time_s), -0.1);
  }
}

TEST(Disturbance, RunsStraightBetweenNodesAndStaysConstantOutside) {
  const Disturbance disturbance{{{0.0, 0.1}, {1.5, -7.3}, {3.0, -7.0}}};
  EXPECT_DOUBLE_EQ(disturbance.at(-1.0), 0.1);
  EXPECT_DOUBLE_EQ(disturbance.at(0.0), 0.1);
  EXPECT_DOUBLE_EQ(disturbance.at(0.75), -3.6);
  EXPECT_DOUBLE_EQ(disturbance.at(1.5), -7.3);
  EXPECT_DOUBLE_EQ(disturbance.at(2.5), -7.1);
  EXPECT_DOUBLE_EQ(disturbance.at(3.0), -7.0);
  EXPECT_DOUBLE_EQ(disturbance.at(60.0), -7.0);
}

TEST(Disturbance, IsRightForAnyOrderOfQuestionsAndAnySpacingOfNodes) {
  std::mt19937_64 random{test::seed(4711)};
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  for (int run = 0; run < 100; ++run) {
    std::vector<DisturbanceNode> nodes;
    double time_s = 20.0 * unit() - 10.0;
    const auto count = 2 + random() % 20;
    for (std::size_t i = 0; i < count; ++i) {
      nodes.push_back({time_s, unit() - 0.5});
      time_s += unit() < 0.3 ? 1e-6 * (1.0 + unit()) : 5.0 * unit() + 1e-3;  // slots with many nodes and with none
    }
    const Disturbance disturbance{nodes};
    const double span_s = nodes.back().time_s - nodes.front().time_s;
    for (int i = 0; i < 300; ++i) {
      const double when_s = nodes.front().time_s + span_s * (1.2 * unit() - 0.1);
      ASSERT_NEAR(disturbance.at(when_s), naive(nodes, when_s), 1e-9) << "run " << run;
    }
    for (const DisturbanceNode& node : nodes) {
      ASSERT_EQ(disturbance.at(node.time_s), node.angle_rad) << "run " << run;
    }
  }
}

TEST(Disturbance, SurvivesTimesThatAreAbsurdlyCloseOrFar) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ((Disturbance{{{0.0, 1.0}, {tiny, 2.0}, {4.0 * tiny, 3.0}}}.at(tiny)), 2.0);
  EXPECT_EQ((Disturbance{{{-1e308, 1.0}, {0.0, 2.0}, {1e308, 3.0}}}.at(0.0)), 2.0);
}

TEST(Disturbance, RefusesTimesThatDoNotIncreaseAndNumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW((Disturbance{{{1.0, 0.0}, {0.5, 0.0}}}), std::invalid_argument);
  EXPECT_THROW((Disturbance{{{1.0, 0.0}, {1.0, 0.1}}}), std::invalid_argument);
  EXPECT_THROW((Disturbance{{{nan, 0.0}}}), std::invalid_argument);
  EXPECT_THROW((Disturbance{{{0.0, nan}, {1.0, 0.0}}}), std::invalid_argument);
  EXPECT_THROW((Disturbance{{{0.0, 0.0}, {infinity, 0.0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace fantail::sim
