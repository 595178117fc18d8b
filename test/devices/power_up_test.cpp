// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "whole_board.hpp"

namespace fantail::devices {
namespace {

// The driver of the switch needs 50 ms to know it, and what it says meanwhile is not "open".
TEST(PowerUp, WithTheSwitchClosedDoesNotArmBeforeItWasOpened) {
  WholeBoard board;
  board.set_switch(true);
  board.run(4'000);
  board.try_to_arm();
  EXPECT_EQ(board.record().phase, core::Phase::safe);
  EXPECT_EQ(board.refusal(), "switch_not_cycled");
  board.set_switch(false);
  board.run(100);
  board.try_to_arm();
  EXPECT_EQ(board.record().phase, core::Phase::armed) << board.refusal();
}

}  // namespace
}  // namespace fantail::devices
