// SPDX-License-Identifier: MIT
#include <chrono>

#include "core/flight_plan.hpp"
#include "log_bytes.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame_writer.hpp"
#include "protocol/plan_block.hpp"
#include "test.hpp"

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

using Bytes = std::vector<std::byte>;

constexpr std::byte not_written{0x5A};
constexpr LogFrameHead some_head{.type = 2, .sequence = 0x01020304, .time = core::Microseconds{0x0A0B0C0D0E0F}};

/// Other bytes in every part, and none that stands for not_written room.
Bytes some_bytes(std::size_t size, unsigned first) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>((first + i) % 0x50);
  }
  return bytes;
}

struct Payload {
  Bytes a{};
  Bytes b{};
  Bytes c{};
  [[nodiscard]] LogFrameWriter::Parts parts() const { return {a, b, c}; }
  [[nodiscard]] Bytes whole() const {
    Bytes all = a;
    append(all, b);
    append(all, c);
    return all;
  }
};

Bytes frame_of(const Payload& payload) {
  LogFrameHead whole = some_head;
  whole.length = static_cast<std::uint16_t>(payload.whole().size());
  return frame(whole, payload.whole());
}

/// Pages of one size, of which the first has only `first` bytes left, as a recorder fills them; behind each lies what
/// is not its own.
Bytes written_into_pages(LogFrameWriter& writer, const Payload& payload, std::size_t first, std::size_t page) {
  Bytes all;
  std::size_t room = first;
  for (bool begun = false; !begun || !writer.done(); begun = true) {
    Bytes out(room + 8, not_written);
    const auto space = std::span{out}.first(room);
    const std::size_t size = begun ? writer.write(space) : writer.begin(some_head, payload.parts(), space);
    EXPECT_TRUE(size == room || writer.done()) << "a page is filled as long as there is something left";
    EXPECT_TRUE(std::ranges::all_of(std::span{out}.subspan(size), [](std::byte b) { return b == not_written; }));
    append(all, std::span{out}.first(size));
    room = page;
  }
  return all;
}

// Three bytes of checksum on one page and the fourth on the next, a part that ends where a page does, a part that is
// empty: whatever falls together.
TEST(LogFrameWriter, AFrameInPiecesOfAnySizeIsTheFrameInOnePiece) {
  LogFrameWriter writer;
  for (const Payload& payload :
       {Payload{}, Payload{.a = some_bytes(1, 1)}, Payload{.b = some_bytes(7, 3), .c = some_bytes(2, 60)},
        Payload{.a = some_bytes(5, 9), .c = some_bytes(11, 20)},
        Payload{some_bytes(4, 1), some_bytes(3, 11), some_bytes(9, 40)}}) {
    const Bytes whole = frame_of(payload);
    EXPECT_EQ(LogFrameWriter::frame_size(payload.parts()), whole.size());
    for (std::size_t first = 0; first < whole.size() + 2; ++first) {
      for (const std::size_t page : {1U, 2U, 3U, 7U, 64U}) {
        ASSERT_EQ(written_into_pages(writer, payload, first, page), whole) << first << " and then " << page;
      }
    }
  }
}

TEST(LogFrameWriter, WhatWasNotBegunOrIsOverWritesNothing) {
  Bytes out(40, not_written);
  LogFrameWriter writer;
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(out), 0U);
  writer.begin(some_head, Payload{.a = some_bytes(3, 1)}.parts(), std::span{out}.first(21));
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(std::span{out}.subspan(21)), 0U);
  EXPECT_EQ(out[21], not_written);
}

// As when the flash fails in the middle of a frame.
TEST(LogFrameWriter, AFrameThatIsAbandonedLeavesNothingInTheNextOne) {
  LogFrameWriter writer;
  const Payload first{.a = some_bytes(30, 1)};
  const Payload second{.a = some_bytes(2, 7), .b = some_bytes(3, 30)};
  Bytes out(20, not_written);
  EXPECT_EQ(writer.begin(some_head, first.parts(), out), 20U);
  EXPECT_FALSE(writer.done());
  writer.abandon();
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(out), 0U);
  EXPECT_EQ(written_into_pages(writer, second, 5, 64), frame_of(second));
}

}  // namespace

}  // namespace fantail::protocol
