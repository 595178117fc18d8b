// SPDX-License-Identifier: MIT
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

#include <gtest/gtest.h>

#include "core/flight_plan.hpp"
#include "protocol/little_endian.hpp"
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

TEST(PlanBlock, AListThatIsFullAndOneThatIsEmptyComeBack) {
  core::FlightPlan plan = core::default_plan();
  for (const std::size_t steps : {std::size_t{8}, std::size_t{0}}) {
    plan.reference.step_times_count = plan.reference.step_angles_count = static_cast<std::uint8_t>(steps);
    for (std::size_t i = 0; i < steps; ++i) {
      plan.reference.step_times.at(i) = std::chrono::seconds{1 + i};
      plan.reference.step_angles.at(i) = core::Angle::from_degrees(static_cast<float>(i));
    }
    std::array<std::byte, plan_block_size> block{};
    write_plan_block(plan, block);
    const PlanBlockReading back = read_plan_block(block);
    ASSERT_TRUE(back.plan) << steps;
    EXPECT_EQ(back.plan->reference.step_times_count, steps);
    EXPECT_EQ(back.plan->reference.step_angles_count, steps);
    if (steps == 8) {
      EXPECT_EQ(back.plan->reference.step_times[7], std::chrono::seconds{8});
      EXPECT_EQ(back.plan->reference.step_angles[7], core::Angle::from_degrees(7.0F));
    }
  }
}

TEST(PlanBlock, EachOfItsFirstFourLettersIsLookedAt) {
  for (std::size_t letter = 0; letter < 4; ++letter) {
    std::array<std::byte, plan_block_size> block{};
    write_plan_block(core::default_plan(), block);
    block.at(letter) ^= std::byte{0x20};
    put<4>(block, block.size() - 4, plan_block_crc(block));  // sealed by somebody who knows about the checksum
    const PlanBlockReading reading = read_plan_block(block);
    EXPECT_FALSE(reading.plan) << letter;
    EXPECT_EQ(reading.fault, PlanBlockFault::no_plan_block) << letter;
  }
}

// docs/can.md tells it to whoever sends plans.
TEST(PlanBlock, TheLargestHas1024Bytes) { EXPECT_EQ(largest_plan_block, 1024U); }

}  // namespace
}  // namespace fantail::protocol
