// SPDX-License-Identifier: MIT
// Which limits excuse what, of which rocket.
#include <gtest/gtest.h>

#include "faults/campaign.hpp"
#include "faults/stop_rule.hpp"
#include "figures.hpp"
#include "input/scenario_file.hpp"
#include "text/number.hpp"

namespace fantail::faults {
namespace {

sim::Scenario launch_with(const std::vector<std::string>& changes) {
  return input::load_scenario("tasha3_launch2", input::parse_overrides(changes));
}

TEST(FaultLimit, SaysHowTheRocketThatWasFlownBreaksTheRuleOfTheStop) {
  const auto about = [](const std::vector<std::string>& changes) {
    const StopRule rule{launch_with(changes), hardover_back.fault};
    EXPECT_FALSE(rule.is_kept());
    return figures(rule.sentence());
  };
  // 4 x offset + stop is too much for 3 x limit; even a stop at the limit makes 28.6, or one between 12 and 16.4 does.
  EXPECT_EQ(about({}), (Numbers{"4", "4.9", "25", "44.6", "3", "9", "27", "28.6"}));
  EXPECT_EQ(about({"controller.canard_limit_deg=12"}),
            (Numbers{"4", "4.9", "25", "44.6", "3", "12", "36", "12", "16.4"}));
  EXPECT_EQ(about({"servo.stop_deg=5"}), (Numbers{"5", "9"})) << "the stop is inside of the plan limit";
}

// At the negative stop 4 x 4.9 + 12.5 is 32.1 of 36 deg; at the positive one the canard does the work of the others.
TEST(FaultLimit, OfOneCanardBlamesTheOtherThreeOnlyWhereTheyCannotBalanceIt) {
  const auto excuse = [](const std::string& fault, const std::vector<std::string>& changes) {
    return known_limit(*cell_of("servo/" + fault + "/controlling").row, Phase::controlling, launch_with(changes))
        ->excuse;
  };
  EXPECT_EQ(excuse("hardover_back", {}), Excuse::three_lack);
  EXPECT_EQ(excuse("hardover", {}), Excuse::comes_back);
  EXPECT_EQ(excuse("garbage", {}), Excuse::three_lack);
  EXPECT_EQ(excuse("hardover_back", {"controller.canard_limit_deg=12"}), Excuse::three_lack);
  EXPECT_EQ(excuse("hardover_back", {"controller.canard_limit_deg=12", "servo.stop_deg=12.5"}), Excuse::comes_back);
  EXPECT_EQ(excuse("hardover_back", {"disturbance.angles_deg=[4.9]"}), Excuse::comes_back);
  EXPECT_EQ(excuse("hardover", {"disturbance.angles_deg=[4.9]"}), Excuse::three_lack);
  // 4 x 3 + 13 is 25 of 27 deg.
  EXPECT_EQ(excuse("hardover", {"disturbance.angles_deg=[3]"}), Excuse::three_lack);
  EXPECT_EQ(excuse("hardover", {"disturbance.angles_deg=[3]", "aerodynamics.canard_stall_deg=13"}), Excuse::comes_back);
}

TEST(FaultLimit, OfARollThatComesBackExcusesNoneThatDoesNot) {
  const Cell cell = cell_of("servo/hardover/controlling");
  const CellLimit limit{known_limit(*cell.row, cell.phase, launch_with({}))};
  EXPECT_EQ(concluded(cell, {{.came_back = true, .apart_deg = 20.0}}, limit).colour, Colour::known_limit);
  EXPECT_EQ(concluded(cell, {{.apart_deg = 20.0}}, limit).colour, Colour::red);
  EXPECT_EQ(concluded(cell, {{.outcome = Outcome::holds}}, limit).colour, Colour::green);
  Findings findings{.lasted = true, .apart_deg = 20.0, .apart_at_end_deg = 10.0};
  EXPECT_TRUE(findings.came_back(cell.expected()));
  findings.apart_at_end_deg = 10.1;
  EXPECT_FALSE(findings.came_back(cell.expected()));
}

TEST(FaultLimit, ExcusesNoBreachOfWhatHoldsForEveryFlight) {
  const Cell cell = cell_of("servo/hardover_back/controlling");
  const KnownLimit* const limit = known_limit(*cell.row, cell.phase, launch_with({}));
  faults::Run run{.apart_deg = 100.0, .what = "far off"};
  EXPECT_EQ(concluded(cell, {run}, {limit}).colour, Colour::known_limit);
  run.is_breach = true;
  EXPECT_EQ(concluded(cell, {run}, {limit}).colour, Colour::red);
}

// The same flight by the same number, of a campaign whose rocket has that stop.
TEST(FaultLimit, SaysWhatTheNearestStopMakesOfTheWorstFlight) {
  const std::string cell = "servo/hardover_back/controlling";
  Campaign campaign{.scenario = "tasha3_launch2", .every = 400};
  const Alone far = fly_alone(campaign, cell, 1);
  ASSERT_EQ(far.judged.colour, Colour::known_limit);
  campaign.changes = {input::parse_override("servo.stop_deg=9.5")};
  const Alone near = fly_alone(campaign, cell, 1);
  const Numbers said = figures(far.judged.of_rocket);
  ASSERT_GE(said.size(), 3U) << far.judged.of_rocket;
  EXPECT_EQ((Numbers{said.end() - 3, said.end()}),
            (Numbers{"9.5", text::fixed(near.run.apart_deg, 1), text::fixed(far.run.apart_deg, 1)}));
  EXPECT_NE(far.judged.of_rocket.find("not safe"), std::string::npos) << far.judged.of_rocket;
  EXPECT_FALSE(near.run.outcome);
  EXPECT_LT(near.run.apart_deg, far.run.apart_deg);
}

}  // namespace
}  // namespace fantail::faults
