// SPDX-License-Identifier: MIT
#include "core/canard_sharing.hpp"

#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr int hand_over = 100;  // ticks
constexpr Angle near = Angle::from_degrees(1e-4F);

/// Four canards in a row of ticks. What does not stand in `stuck` turns at once to what is asked of it, as far as the
/// plan limit lets it.
class Rig {
 public:
  explicit Rig(Angle plan_limit = 9_deg) : limit_{plan_limit}, sharing_{plan_limit} {}

  std::array<std::optional<Angle>, canard_count> stuck{};
  std::array<bool, canard_count> silent{};
  CanardVerdicts verdicts{};

  /// One tick under the roll command; what each canard is asked for.
  Angle tick(Angle roll_command) {
    CanardContributions contributions;
    for (std::size_t i = 0; i < canard_count; ++i) {
      contributions[i] = silent[i] ? std::nullopt : std::optional{angle(i)};
    }
    sharing_.update(verdicts, contributions);
    asked_ = sharing_.asked_of_each(roll_command);
    return asked_;
  }
  Angle run(int ticks, Angle roll_command) {
    for (int i = 0; i < ticks; ++i) {
      tick(roll_command);
    }
    return asked_;
  }
  void stick(std::size_t canard, Angle at) {
    stuck[canard] = at;
    verdicts[canard] = CanardVerdict::stalled;
  }
  void heal(std::size_t canard) {
    stuck[canard].reset();
    verdicts[canard] = CanardVerdict::healthy;
  }
  [[nodiscard]] Angle angle(std::size_t canard) const { return stuck[canard].value_or(clamp(asked_, limit_)); }
  /// Mean of what the four add to the roll.
  [[nodiscard]] Angle mean() const { return (angle(0) + angle(1) + angle(2) + angle(3)) / 4.0F; }
  [[nodiscard]] const CanardSharing& sharing() const { return sharing_; }

 private:
  Angle limit_;
  CanardSharing sharing_;
  Angle asked_;
};

TEST(CanardSharing, WithoutAVerdictEachCanardIsAskedForTheRollCommand) {
  Rig rig;
  EXPECT_EQ(rig.run(5, 4_deg), 4_deg);
  EXPECT_FALSE(rig.sharing().is_active());
  EXPECT_EQ(rig.sharing().reach().lowest, -9_deg);
  EXPECT_EQ(rig.sharing().reach().highest, 9_deg);
}

// c = 4 u / 3 of one that stands at trim; (4 u - a) / 3 of one that is stuck at a.
TEST(CanardSharing, ThreeDoTheWorkOfFourAndUndoWhatTheFourthDoes) {
  for (const Angle at : {0_deg, 9_deg, -9_deg, 25_deg}) {
    Rig rig;
    rig.stick(2, at);
    const Angle asked = rig.run(2 * hand_over, 3_deg);
    EXPECT_LE(abs(asked - (12_deg - at) / 3.0F), near);
    EXPECT_LE(abs(rig.mean() - 3_deg), near) << at.degrees();
  }
}

TEST(CanardSharing, TwoDoTheWorkOfFour) {
  Rig rig;
  rig.stick(0, 5_deg);
  rig.stick(1, -2_deg);
  EXPECT_LE(abs(rig.run(2 * hand_over, 3_deg) - 4.5_deg), near);  // (12 - 3) / 2
  EXPECT_LE(abs(rig.mean() - 3_deg), near);
}

// (4 u - w a) / (4 - w) with w of 1/100 a tick: of u = 3 and a = -9 from 3 to 7 in a tenth of a second.
TEST(CanardSharing, NeitherAVerdictNorItsEndIsAStep) {
  Rig rig;
  rig.stick(3, -9_deg);
  Angle before = 3_deg;
  for (int i = 1; i <= hand_over; ++i) {
    const float w = static_cast<float>(i) / 100.0F;
    const Angle asked = rig.tick(3_deg);
    EXPECT_LE(abs(asked - (12_deg + 9.0F * w * 1_deg) / (4.0F - w)), near) << i;
    EXPECT_LE(abs(asked - before), 0.08_deg);  // the slope is 48 / (4 - w)^2 degrees over w
    before = asked;
  }
  EXPECT_LE(abs(rig.run(hand_over, 3_deg) - 7_deg), near);

  // Still stuck, although the verdict is gone: it goes back as slowly.
  rig.verdicts[3] = CanardVerdict::healthy;
  before = 7_deg;
  for (int i = 0; i < hand_over; ++i) {
    const Angle asked = rig.tick(3_deg);
    EXPECT_LE(abs(asked - before), 0.08_deg) << i;
    before = asked;
  }
  EXPECT_FALSE(rig.sharing().is_active());
  EXPECT_EQ(rig.tick(3_deg), 3_deg);
}

// The monitor needs a while to withdraw a verdict. Meanwhile the canard is a servo that follows c with its lag: then
// c = (4 u - a) / 3 and a = c have one solution, c = u.
TEST(CanardSharing, ACanardThatComesToLifeTakesUpItsShareBeforeItsVerdictIsWithdrawn) {
  Rig rig;
  rig.stick(1, 0_deg);
  ASSERT_LE(abs(rig.run(2 * hand_over, 6_deg) - 8_deg), near);
  Angle shaft;
  Angle before = 8_deg;
  for (int i = 0; i < 300; ++i) {
    rig.stuck[1] = shaft;
    const Angle asked = rig.tick(6_deg);
    shaft += 0.04F * (asked - shaft);  // a lag of 25 ms
    EXPECT_LE(abs(asked - before), 0.2_deg) << i;
    before = asked;
  }
  EXPECT_LE(abs(before - 6_deg), 0.01_deg);
  EXPECT_LE(abs(shaft - 6_deg), 0.01_deg);
}

// One is judged wrongly, by a model of the servo that is too fast: nothing comes of it at rest.
TEST(CanardSharing, AVerdictOnACanardThatFollowsChangesNothingAtRest) {
  Rig rig;
  rig.run(10, 5_deg);
  rig.verdicts[0] = CanardVerdict::slipping;
  EXPECT_LE(abs(rig.run(500, 5_deg) - 5_deg), near);
}

// On and off faster than the hand-over: w stays small, and so does the ripple.
TEST(CanardSharing, AVerdictThatComesAndGoesIsARipple) {
  Rig rig;
  rig.stick(0, 0_deg);
  Angle lowest = 90_deg;
  Angle highest = -lowest;
  for (int i = 0; i < 2000; ++i) {
    rig.verdicts[0] = i % 20 < 10 ? CanardVerdict::stalled : CanardVerdict::healthy;
    const Angle asked = rig.tick(6_deg);
    lowest = std::min(lowest, asked);
    highest = std::max(highest, asked);
  }
  EXPECT_GE(lowest, 6_deg);
  EXPECT_LE(highest, 6.2_deg);  // w of at most 0.1: 24 / 3.9
}

TEST(CanardSharing, ASilentEncoderOfACanardThatFollowedChangesNothing) {
  Rig rig;
  rig.run(10, 5_deg);
  rig.silent[2] = true;
  rig.verdicts[2] = CanardVerdict::dead;
  EXPECT_EQ(rig.run(500, 5_deg), 5_deg);
  EXPECT_FALSE(rig.sharing().is_active());
}

TEST(CanardSharing, ASilentEncoderOfAStuckCanardLeavesItWhereItWasSeen) {
  Rig rig;
  rig.stick(2, -3_deg);
  rig.run(2 * hand_over, 3_deg);
  rig.silent[2] = true;
  rig.verdicts[2] = CanardVerdict::dead;
  EXPECT_LE(abs(rig.run(500, 3_deg) - 5_deg), near);
}

TEST(CanardSharing, OneThatFallsSilentAfterASingleTickStaysJudged) {
  Rig rig;
  rig.stick(0, -3_deg);
  rig.tick(3_deg);
  EXPECT_TRUE(rig.sharing().is_active());
  rig.silent[0] = true;
  EXPECT_LE(abs(rig.run(2 * hand_over, 3_deg) - 5_deg), near);
}

TEST(CanardSharing, BeforeItsFirstTickItReachesWhatThePlanAllows) {
  const Rig rig;
  EXPECT_EQ(rig.sharing().reach().lowest, -9_deg);
  EXPECT_EQ(rig.sharing().reach().highest, 9_deg);
  EXPECT_EQ(rig.sharing().asked_of_each(4_deg), 4_deg);
}

TEST(CanardSharing, WithMoreThanTwoJudgedNothingIsShared) {
  Rig rig;
  for (const std::size_t canard : {0U, 1U}) {
    rig.stick(canard, 0_deg);
  }
  ASSERT_LE(abs(rig.run(2 * hand_over, 3_deg) - 6_deg), near);
  rig.stick(2, 0_deg);
  Angle before = 6_deg;
  for (int i = 0; i < hand_over; ++i) {
    const Angle asked = rig.tick(3_deg);
    EXPECT_LE(abs(asked - before), 0.07_deg);
    before = asked;
  }
  EXPECT_EQ(rig.tick(3_deg), 3_deg);
}

// (4 u - a) / 3 = +-9: u = (a +- 27) / 4. At the ends of its reach the three stand at the plan limit.
TEST(CanardSharing, ItsReachIsWhatThreeAtThePlanLimitAndTheStuckOneMakeTogether) {
  struct Case {
    Angle at, lowest, highest;
  };
  for (const auto& [at, lowest, highest] : {Case{0_deg, -6.75_deg, 6.75_deg}, Case{9_deg, -4.5_deg, 9_deg},
                                            Case{-9_deg, -9_deg, 4.5_deg}, Case{25_deg, -0.5_deg, 13_deg}}) {
    Rig rig;
    rig.stick(0, at);
    rig.run(2 * hand_over, 0_deg);
    EXPECT_LE(abs(rig.sharing().reach().lowest - lowest), near) << at.degrees();
    EXPECT_LE(abs(rig.sharing().reach().highest - highest), near) << at.degrees();
    for (const Angle end : {lowest, highest}) {
      rig.tick(end);
      EXPECT_LE(abs(rig.mean() - end), near) << at.degrees();
    }
  }
}

TEST(CanardSharing, WhatTheCanardsCannotMakeIsNoCommand) {
  Rig rig;
  rig.stick(0, 0_deg);
  rig.run(2 * hand_over, 0_deg);
  RollCommand roll{.before_excitation = 8_deg, .unclamped = 8_deg, .command = 8_deg};
  rig.sharing().limit(roll);
  EXPECT_LE(abs(roll.command - 6.75_deg), near);
  EXPECT_TRUE(roll.saturated);
  // With a helpful one the three could make 13: the law is not at its limit before.
  rig.stick(0, 25_deg);
  rig.run(5 * hand_over, 0_deg);
  roll = {.before_excitation = 12_deg, .unclamped = 12_deg, .command = 9_deg, .saturated = true};
  rig.sharing().limit(roll);
  EXPECT_EQ(roll.command, 12_deg);
  EXPECT_FALSE(roll.saturated);
  RollCommand none{.finite = false};
  rig.sharing().limit(none);
  EXPECT_EQ(none.command, Angle{});
}

// sigma of 22 degrees, 1000 counts: what reaches the other three is a thirtieth of it.
TEST(CanardSharing, ANoisyEncoderDoesNotShakeTheOtherCanards) {
  Rig rig;
  rig.verdicts[0] = CanardVerdict::slipping;
  double sum = 0.0;
  std::uint32_t random = 1;
  for (int i = 0; i < 3000; ++i) {
    random = random * 1664525U + 1013904223U;
    const double even = static_cast<double>(random) / 4294967296.0 - 0.5;  // sigma of 1 / sqrt(12)
    rig.stuck[0] = Angle::from_degrees(static_cast<float>(22.0 * std::sqrt(12.0) * even));
    const double asked = static_cast<double>(rig.tick(0_deg).degrees());
    sum += i < 500 ? 0.0 : asked * asked;
  }
  // A lag of a fiftieth a tick leaves sigma sqrt(0.02 / 1.98), and a third of it goes to each.
  EXPECT_NEAR(std::sqrt(sum / 2500.0), 22.0 * std::sqrt(0.02 / 1.98) / 3.0, 0.1);
}

}  // namespace
}  // namespace fantail::core
