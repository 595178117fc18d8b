// SPDX-License-Identifier: MIT
#include <bit>

#include "hal/sim/flash.hpp"
#include "test.hpp"

namespace fantail::hal::sim {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::byte>;

constexpr FlashGeometry small{.size = 4096, .sector_size = 1024, .page_size = 64};

struct SimFlash : testing::Test {
  WorldSide world{};
  Flash flash{world, small};
  std::byte at(std::uint32_t address) {
    std::array<std::byte, 1> out{};
    EXPECT_EQ(flash.read(address, out), FlashResult::ok);
    return out[0];
  }
};

TEST_F(SimFlash, IsDeliveredErasedAndAsLargeAsAW25Q128) {
  Flash large;
  EXPECT_EQ(large.geometry().size, 16'777'216U);
  EXPECT_EQ(large.geometry().sector_size, 4096U);
  EXPECT_EQ(large.geometry().page_size, 256U);
  EXPECT_TRUE(std::ranges::all_of(large.cells(), [](std::byte byte) { return byte == std::byte{0xFF}; }));
}

TEST_F(SimFlash, WithoutAWorldEverythingIsDoneAtOnce) {
  Flash instant{small};
  const std::array byte{std::byte{0x12}};
  EXPECT_EQ(instant.program(5, byte), FlashResult::ok);
  EXPECT_FALSE(instant.busy());
  EXPECT_EQ(instant.cells()[5], std::byte{0x12});
  EXPECT_EQ(instant.erase_sector(0), FlashResult::ok);
  EXPECT_EQ(instant.cells()[5], std::byte{0xFF});
  EXPECT_EQ(instant.begun(), 2U);
}

TEST_F(SimFlash, AProgramTakesAMillisecondInWhichNothingElseCanBeAsked) {
  std::array byte{std::byte{0x12}};
  EXPECT_EQ(flash.program(5, byte), FlashResult::ok);
  world.time += 999us;
  EXPECT_TRUE(flash.busy());
  EXPECT_EQ(flash.program(6, byte), FlashResult::busy);
  EXPECT_EQ(flash.read(6, byte), FlashResult::busy);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::busy);
  EXPECT_EQ(flash.cells()[5], std::byte{0xFF});
  world.time += 1us;
  EXPECT_FALSE(flash.busy());
  EXPECT_EQ(at(5), std::byte{0x12});
  EXPECT_EQ(at(6), std::byte{0xFF});
}

TEST_F(SimFlash, AnEraseTakesFiftyMilliseconds) {
  std::ranges::fill(flash.cells(), std::byte{0});
  EXPECT_EQ(flash.erase_sector(1024), FlashResult::ok);
  world.time += 49'999us;
  EXPECT_TRUE(flash.busy());
  world.time += 1us;
  EXPECT_EQ(at(1023), std::byte{0});
  EXPECT_EQ(at(1024), std::byte{0xFF});
  EXPECT_EQ(at(2047), std::byte{0xFF});
  EXPECT_EQ(at(2048), std::byte{0});
}

TEST_F(SimFlash, WhatIsOutOfRangeIsNotBegun) {
  EXPECT_EQ(flash.program(60, Bytes(5)), FlashResult::out_of_range);
  EXPECT_EQ(flash.erase_sector(64), FlashResult::out_of_range);
  Bytes out(2);
  EXPECT_EQ(flash.read(4095, out), FlashResult::out_of_range);
  EXPECT_FALSE(flash.busy());
  EXPECT_EQ(flash.begun(), 0U);
}

TEST_F(SimFlash, APowerCutDuringAProgramClearsSomeOfTheBitsThatWereAskedAndNoOther) {
  const std::array wanted{std::byte{0x0F}, std::byte{0x00}, std::byte{0xFF}, std::byte{0xA5}};
  std::set<std::uint32_t> seen;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Flash cut{world, small};
    EXPECT_EQ(cut.program(64, wanted), FlashResult::ok);
    cut.cut_power(seed);
    EXPECT_FALSE(cut.busy());
    const Bytes left{cut.cells().begin() + 64, cut.cells().begin() + 68};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_EQ(left[i] & wanted[i], wanted[i]) << "a bit that was to stay one, seed " << seed;
    }
    EXPECT_EQ(cut.cells()[63], std::byte{0xFF});
    EXPECT_EQ(cut.cells()[68], std::byte{0xFF});
    if (seed == 0) {
      EXPECT_EQ(left, Bytes(4, std::byte{0xFF}));
    }
    if (seed == 1) {
      EXPECT_TRUE(std::ranges::equal(left, wanted));
    }
    seen.insert(std::bit_cast<std::uint32_t>(std::array{left[0], left[1], left[2], left[3]}));
  }
  EXPECT_GT(seen.size(), 100U);
}

TEST_F(SimFlash, APowerCutDuringAnEraseLeavesAnythingFromTheOldSectorToABlankOneAndNothingBesideIt) {
  bool more_zeros = false;
  bool some_ones = false;
  bool half = false;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Flash cut{world, small};
    std::ranges::fill(cut.cells(), std::byte{0x3C});
    EXPECT_EQ(cut.erase_sector(1024), FlashResult::ok);
    cut.cut_power(seed);
    EXPECT_EQ(cut.cells()[1023], std::byte{0x3C});
    EXPECT_EQ(cut.cells()[2048], std::byte{0x3C});
    const auto sector = cut.cells().subspan(1024, 1024);
    const auto all = [&](auto rule) { return std::ranges::all_of(sector, rule); };
    if (seed < 2) {
      EXPECT_TRUE(all([&](std::byte byte) { return byte == (seed == 0 ? std::byte{0x3C} : std::byte{0xFF}); }));
      continue;
    }
    const bool subset = all([](std::byte byte) { return (byte & std::byte{0x3C}) == byte; });
    const bool old_or_erased = all([](std::byte byte) { return byte == std::byte{0x3C} || byte == std::byte{0xFF}; });
    more_zeros = more_zeros || subset;
    half = half || old_or_erased;
    some_ones = some_ones || (!subset && !old_or_erased);
  }
  EXPECT_TRUE(more_zeros);
  EXPECT_TRUE(some_ones);
  EXPECT_TRUE(half);
}

TEST_F(SimFlash, TheSameSeedTearsTheSameBits) {
  Flash twin{world, small};
  for (Flash* one : {&flash, &twin}) {
    EXPECT_EQ(one->program(0, Bytes(64)), FlashResult::ok);
    one->cut_power(77);
    EXPECT_EQ(one->erase_sector(1024), FlashResult::ok);
    one->cut_power(78);
  }
  EXPECT_TRUE(std::ranges::equal(flash.cells(), twin.cells()));
}

TEST_F(SimFlash, APowerCutAfterTheEndOfAnOperationSpoilsNothing) {
  EXPECT_EQ(flash.program(0, Bytes(64)), FlashResult::ok);
  world.time += 1ms;
  flash.cut_power(0);
  EXPECT_EQ(at(0), std::byte{0});
  EXPECT_EQ(at(63), std::byte{0});
}

TEST_F(SimFlash, ADeviceThatDoesNotAnswerFailsAndOneThatStaysBusySaysSo) {
  Bytes byte(1);
  flash.set_answers(false);
  EXPECT_EQ(flash.read(0, byte), FlashResult::failed);
  EXPECT_EQ(flash.program(0, byte), FlashResult::failed);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::failed);
  flash.set_answers(true);
  flash.set_stays_busy(true);
  world.time += 1h;
  EXPECT_TRUE(flash.busy());
  EXPECT_EQ(flash.read(0, byte), FlashResult::busy);
  EXPECT_EQ(flash.erase_sector(0), FlashResult::busy);
  flash.set_stays_busy(false);
  EXPECT_EQ(flash.read(0, byte), FlashResult::ok);
}

TEST_F(SimFlash, AWornOutSectorTakesNothingAndSaysNothing) {
  Flash instant{small};
  instant.wear_out(small.sector_size);
  EXPECT_EQ(instant.program(small.sector_size, Bytes(8)), FlashResult::ok);
  EXPECT_EQ(instant.program(0, Bytes(8)), FlashResult::ok);
  Bytes out(8);
  EXPECT_EQ(instant.read(small.sector_size, out), FlashResult::ok);
  EXPECT_EQ(out, Bytes(8, std::byte{0xFF}));
  EXPECT_EQ(instant.read(0, out), FlashResult::ok);
  EXPECT_EQ(out, Bytes(8));
}

TEST_F(SimFlash, StuckBitsReadTheSameWhateverIsDone) {
  Flash instant{small};
  instant.stick(10, std::byte{0x81}, std::byte{0x01});
  Bytes out(20);
  EXPECT_EQ(instant.read(0, out), FlashResult::ok);
  EXPECT_EQ(out[10], std::byte{0x7F});
  EXPECT_EQ(instant.program(0, Bytes(64)), FlashResult::ok);
  EXPECT_EQ(instant.read(0, out), FlashResult::ok);
  EXPECT_EQ(out[9], std::byte{0});
  EXPECT_EQ(out[10], std::byte{0x01});
  Bytes beside(9);
  EXPECT_EQ(instant.read(11, beside), FlashResult::ok);
  EXPECT_EQ(beside, Bytes(9));
}

}  // namespace
}  // namespace fantail::hal::sim
