// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <span>

#include <gtest/gtest.h>

#include "core/flight_plan.hpp"
#include "protocol/plan_block.hpp"

namespace fantail::protocol {
namespace {

// In flash erased bytes lie behind it, in a board's memory whatever was there before.
TEST(PlanBlock, WhatLiesBehindItIsNeitherWrittenNorRead) {
  std::array<std::byte, largest_plan_block> room{};
  room.fill(std::byte{0x5A});
  const std::size_t size = write_plan_block(core::default_plan(), room);
  EXPECT_EQ(room.at(size), std::byte{0x5A});
  const auto block = std::span<const std::byte>{room}.first(size);
  EXPECT_TRUE(read_plan_block(block).plan);
  EXPECT_EQ(plan_block_checksum(block), plan_crc(core::default_plan()));
}

// docs/can.md tells it to whoever sends plans.
TEST(PlanBlock, TheLargestHas1024Bytes) { EXPECT_EQ(largest_plan_block, 1024U); }

}  // namespace
}  // namespace fantail::protocol
