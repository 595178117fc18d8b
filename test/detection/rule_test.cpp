// SPDX-License-Identifier: MIT
#include "detection/rule.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "text/error.hpp"

namespace fantail::detection {
namespace {

const Rule* rule_with(const std::vector<Rule>& rules, const std::string& name) {
  const auto found = std::ranges::find_if(
      rules, [&name](const Rule& rule) { return std::ranges::find(rule.names, name) != rule.names.end(); });
  return found == rules.end() ? nullptr : &*found;
}

TEST(Rule, WithoutNamesAllShippedLaunchPlansAndThePrintedRuleArePlayed) {
  const std::vector<Rule> rules = rules_of({});
  for (const char* name : {"tasha3_launch1", "tasha3_launch2", "tasha3_launch2_integral", published_launch_2}) {
    EXPECT_NE(rule_with(rules, name), nullptr) << name;
  }
  EXPECT_EQ(rule_with(rules, "tunnel_steps"), nullptr);
  // An integral changes nothing about a launch.
  EXPECT_EQ(rule_with(rules, "tasha3_launch2"), rule_with(rules, "tasha3_launch2_integral"));
}

// A gate keeps canards at trim for longer: without it the counts are those of the detection and the guide.
TEST(Rule, APlanThatWaitsAfterTheGuideIsPlayedAsIfItDidNot) {
  const std::vector<Rule> rules = rules_of({});
  EXPECT_EQ(rule_with(rules, "tasha3_launch2"), rule_with(rules, "tasha3_launch2_irec"));
  for (const Rule& rule : rules) {
    EXPECT_EQ(rule.plan.dormancy.until, core::DormantUntil::guide) << rule.name();
  }
}

TEST(Rule, ThePrintedRuleOfTheSecondLaunchIsRawAndGoesByHeightAlone) {
  const std::array<std::string, 1> name{published_launch_2};
  const std::vector<Rule> rules = rules_of(name);
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_FALSE(rules[0].judged);
  const core::LaunchDetectionPlan& detection = rules[0].plan.launch_detection;
  EXPECT_FLOAT_EQ(detection.threshold_m_s2, 2.5F * core::standard_gravity_m_s2);
  EXPECT_EQ(detection.hold, core::Microseconds{100'000});
  EXPECT_EQ(detection.accelerometers, core::AccelerometerRule::two_agree);
  EXPECT_FALSE(detection.low_pass);
  EXPECT_EQ(rules[0].plan.guide.minimum_speed_m_s, 0.0F);
  EXPECT_EQ(rules[0].plan.motion.height_origin, core::HeightOrigin::velocity_only);
}

TEST(Rule, ThePlanOfTheFirstLaunchHasThePrintedRule) {
  const std::array<std::string, 1> name{"tasha3_launch1"};
  const core::FlightPlan plan = rules_of(name).front().plan;
  EXPECT_FLOAT_EQ(plan.launch_detection.threshold_m_s2, 2.0F * core::standard_gravity_m_s2);
  EXPECT_EQ(plan.launch_detection.hold, core::Microseconds{200'000});
  EXPECT_EQ(plan.launch_detection.accelerometers, core::AccelerometerRule::one);
  EXPECT_FALSE(plan.launch_detection.low_pass);
}

TEST(Rule, APlanGivenTwiceIsPlayedOnce) {
  const std::array<std::string, 2> names{"tasha3_launch2", "tasha3_launch2"};
  const std::vector<Rule> rules = rules_of(names);
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules[0].name(), "tasha3_launch2");
}

TEST(Rule, ATunnelPlanAndANameThatIsNoneAreRefused) {
  for (const std::string name : {"tunnel_steps", "tasha9"}) {
    const std::array<std::string, 1> names{name};
    EXPECT_THROW((void)rules_of(names), text::Error) << name;
  }
}

}  // namespace
}  // namespace fantail::detection
