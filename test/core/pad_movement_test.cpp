// SPDX-License-Identifier: MIT
#include "core/pad_movement.hpp"

#include "core/angle.hpp"
#include "core/inputs.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

constexpr float g = standard_gravity_m_s2;
constexpr float block_s = 0.1F;
constexpr Vector3 upright{g, 0.0F, 0.0F};

float deg(float degrees) { return Angle::from_degrees(degrees).radians(); }

/// Blocks until it has moved; at most 1000.
int blocks_until_moved(PadMovement& movement, const Vector3& rate, const Vector3& force) {
  int blocks = 0;
  while (!movement.has_moved() && blocks < 1000) {
    movement.take(block_s, rate, force);
    ++blocks;
  }
  return blocks;
}

TEST(PadMovement, ARocketThatStandsHasNotMovedAfterAnHour) {
  PadMovement movement;
  for (int i = 0; i < 36'000; ++i) {
    movement.take(block_s, {deg(0.3F), deg(-0.3F), deg(0.3F)}, upright);
  }
  EXPECT_FALSE(movement.has_moved());
  EXPECT_FALSE(movement.has_fallen());
}

TEST(PadMovement, ATurnOfTenDegreesAcrossTheAxisIsMovement) {
  PadMovement movement;
  EXPECT_EQ(blocks_until_moved(movement, {0.0F, deg(10.0F), 0.0F}, upright), 11) << "10 deg/s, less what is forgotten";
  PadMovement both;
  EXPECT_EQ(blocks_until_moved(both, {0.0F, deg(-6.0F), deg(8.0F)}, upright), 11) << "10 deg/s in all";
}

TEST(PadMovement, ARailThatRocksByFiveDegreesEitherWayHasNotMoved) {
  PadMovement movement;
  for (int i = 0; i < 600; ++i) {
    movement.take(block_s, {0.0F, (i / 5) % 2 == 0 ? deg(10.0F) : deg(-10.0F), 0.0F}, upright);
  }
  EXPECT_FALSE(movement.has_moved());
}

TEST(PadMovement, RollAloneIsNone) {
  PadMovement movement;
  EXPECT_EQ(blocks_until_moved(movement, {deg(90.0F), 0.0F, 0.0F}, upright), 1000);
}

TEST(PadMovement, WhileItIsPushedATurnIsNotHeldAgainstALaunch) {
  PadMovement movement;
  for (int i = 0; i < 29; ++i) {
    movement.take(block_s, {0.0F, deg(20.0F), 0.0F}, {5.0F * g, 0.0F, 0.0F});
  }
  EXPECT_FALSE(movement.has_moved());
  movement.take(block_s, {}, {0.9F * g, 0.0F, 0.0F});
  EXPECT_TRUE(movement.has_moved()) << "the push is over, and the turn remains";
}

TEST(PadMovement, APushOfThreeSecondsIsMovement) {
  PadMovement movement;
  EXPECT_EQ(blocks_until_moved(movement, {}, {1.21F * g, 0.0F, 0.0F}), 30);
  PadMovement broken_off;
  for (int i = 0; i < 100; ++i) {
    broken_off.take(block_s, {}, {(i % 30 == 29 ? 1.0F : 2.3F) * g, 0.0F, 0.0F});
  }
  EXPECT_FALSE(broken_off.has_moved());
}

TEST(PadMovement, LyingHangingAndFallingAreMovement) {
  for (const Vector3& force : {Vector3{0.49F * g, 0.87F * g, 0.0F}, Vector3{-g, 0.0F, 0.0F}, Vector3{}}) {
    PadMovement movement;
    EXPECT_EQ(blocks_until_moved(movement, {}, force), 3);
  }
  PadMovement leaning;
  EXPECT_EQ(blocks_until_moved(leaning, {}, {0.51F * g, 0.86F * g, 0.0F}), 1000);
}

TEST(PadMovement, EightTenthsOfASecondWithoutWeightAreAFlight) {
  PadMovement movement;
  for (int i = 0; i < 7; ++i) {
    movement.take(block_s, {}, {-0.39F * g, 0.0F, 0.0F});
  }
  for (int i = 0; i < 7; ++i) {
    movement.take(block_s, {}, {0.41F * g, 0.0F, 0.0F});
  }
  EXPECT_FALSE(movement.has_fallen()) << "a drop ends";
  for (int i = 0; i < 7; ++i) {
    movement.take(block_s, {}, {0.2F * g, 0.2F * g, -0.2F * g});
  }
  EXPECT_FALSE(movement.has_fallen());
  movement.take(block_s, {}, {});
  EXPECT_TRUE(movement.has_fallen());
  for (int i = 0; i < 100; ++i) {
    movement.take(block_s, {}, upright);
  }
  EXPECT_TRUE(movement.has_fallen() && movement.has_moved()) << "whatever comes, but rest";
}

TEST(PadMovement, AKickWhileItFallsDoesNotMakeItStand) {
  PadMovement movement;
  for (int i = 0; i < 5; ++i) {
    movement.take(block_s, {}, {});
  }
  movement.take(block_s, {}, {0.75F * g, 0.0F, 0.0F});  // 15 g for 5 ms
  for (int i = 0; i < 4; ++i) {
    movement.take(block_s, {}, {});
  }
  EXPECT_TRUE(movement.has_fallen());
}

TEST(PadMovement, FiveSecondsThatNobodyMeasuredAreMovement) {
  PadMovement movement;
  for (int i = 0; i < 49; ++i) {
    movement.miss();
  }
  movement.take(block_s, {}, upright);
  for (int i = 0; i < 49; ++i) {
    movement.miss();
  }
  EXPECT_FALSE(movement.has_moved());
  movement.miss();
  EXPECT_TRUE(movement.has_moved());
}

TEST(PadMovement, RestEndsAllOfIt) {
  PadMovement movement;
  for (int i = 0; i < 30; ++i) {
    movement.take(block_s, {0.0F, deg(9.0F), 0.0F}, {});
  }
  movement.require_rest();
  movement.rest();
  EXPECT_FALSE(movement.has_moved() || movement.has_fallen());
  EXPECT_EQ(blocks_until_moved(movement, {0.0F, deg(10.0F), 0.0F}, upright), 11) << "no turn of before counts";
}

}  // namespace
}  // namespace fantail::core
