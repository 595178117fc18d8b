// SPDX-License-Identifier: MIT
#include "hal/nor_memory.hpp"

#include "properties.hpp"

namespace fantail::hal {
namespace {

constexpr FlashGeometry geometry{.size = 1024, .sector_size = 256, .page_size = 64};
using Bytes = std::vector<std::byte>;

struct NorMemoryTest : testing::Test {
  Bytes cells = Bytes(geometry.size, std::byte{0x5A});
  NorMemory memory{cells, geometry};
};

TEST_F(NorMemoryTest, ErasingTurnsOneSectorIntoOnesAndNothingBesideIt) {
  EXPECT_EQ(memory.erase_sector(256), FlashResult::ok);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cells[i], i / 256 == 1 ? std::byte{0xFF} : std::byte{0x5A}) << i;
  }
}

TEST_F(NorMemoryTest, OnlyTheStartOfASectorCanBeErased) {
  const Bytes before = cells;
  for (const std::uint32_t address : {1U, 64U, 255U, 257U, 1023U, 1024U, 1280U, 0xFFFFFF00U, 0xFFFFFFFFU}) {
    EXPECT_EQ(memory.erase_sector(address), FlashResult::out_of_range) << address;
  }
  EXPECT_EQ(cells, before);
}

TEST_F(NorMemoryTest, ProgrammingLeavesTheBitsThatBothHave) {
  const std::array bytes{std::byte{0xFF}, std::byte{0x0F}, std::byte{0x00}, std::byte{0xA5}};
  EXPECT_EQ(memory.program(60, bytes), FlashResult::ok);
  EXPECT_EQ(cells[59], std::byte{0x5A});
  EXPECT_EQ(cells[60], std::byte{0x5A});
  EXPECT_EQ(cells[61], std::byte{0x0A});
  EXPECT_EQ(cells[62], std::byte{0x00});
  EXPECT_EQ(cells[63], std::byte{0x00});
  EXPECT_EQ(cells[64], std::byte{0x5A});
}

TEST_F(NorMemoryTest, AProgramThatLeavesItsPageChangesNothing) {
  const Bytes before = cells;
  const Bytes two(2);
  EXPECT_EQ(memory.program(63, two), FlashResult::out_of_range);
  EXPECT_EQ(memory.program(1023, two), FlashResult::out_of_range);
  EXPECT_EQ(memory.program(1024, two), FlashResult::out_of_range);
  EXPECT_EQ(memory.program(std::numeric_limits<std::uint32_t>::max(), two), FlashResult::out_of_range);
  EXPECT_EQ(memory.program(0, Bytes(65)), FlashResult::out_of_range);
  EXPECT_EQ(cells, before);
  EXPECT_EQ(memory.program(64, Bytes(64)), FlashResult::ok);
}

TEST_F(NorMemoryTest, ReadingKnowsNoPagesAndEndsWithTheFlash) {
  cells[1023] = std::byte{7};
  Bytes out(1024);
  EXPECT_EQ(memory.read(0, out), FlashResult::ok);
  EXPECT_EQ(out, cells);
  Bytes two(2, std::byte{9});
  EXPECT_EQ(memory.read(1023, two), FlashResult::out_of_range);
  EXPECT_EQ(memory.read(0xFFFFFFFFU, two), FlashResult::out_of_range);
  EXPECT_EQ(two, Bytes(2, std::byte{9}));
  EXPECT_EQ(memory.read(1022, two), FlashResult::ok);
  EXPECT_EQ(two[1], std::byte{7});
}

TEST_F(NorMemoryTest, AGeometryThatDoesNotDivideOrIsNotTheSizeOfTheCellsDoesNothing) {
  EXPECT_TRUE(sensible(geometry));
  Bytes byte(1);
  for (const FlashGeometry& bad :
       {FlashGeometry{}, FlashGeometry{1024, 256, 0}, FlashGeometry{1024, 0, 64}, FlashGeometry{0, 256, 64},
        FlashGeometry{1024, 96, 64}, FlashGeometry{1000, 256, 64}, FlashGeometry{512, 256, 64}}) {
    NorMemory broken{cells, bad};
    EXPECT_EQ(broken.read(0, byte), FlashResult::out_of_range);
    EXPECT_EQ(broken.program(0, byte), FlashResult::out_of_range);
    EXPECT_EQ(broken.erase_sector(0), FlashResult::out_of_range);
  }
}

// Each bit by itself: a one until it is programmed to zero, then zero until its sector is erased.
RC_GTEST_PROP(NorMemory, EveryBitIsZeroExactlyWhenItWasProgrammedSinceItsLastErase, ()) {
  constexpr FlashGeometry small{.size = 64, .sector_size = 32, .page_size = 16};
  Bytes cells(small.size, std::byte{0xFF});
  NorMemory memory{cells, small};
  std::vector<bool> cleared(8 * std::size_t{small.size}, false);
  const int calls = *rc::gen::inRange(0, 60);
  for (int call = 0; call < calls; ++call) {
    const auto address = *rc::gen::inRange<std::uint32_t>(0, 70);
    if (*rc::gen::inRange(0, 4) == 0) {
      if (memory.erase_sector(address) == FlashResult::ok) {
        RC_ASSERT(address == 0 || address == 32);
        std::fill_n(cleared.begin() + 8 * static_cast<std::ptrdiff_t>(address), 256, false);
      }
      continue;
    }
    const auto values = *rc::gen::container<std::vector<std::uint8_t>>(*rc::gen::inRange<std::size_t>(1, 20),
                                                                       rc::gen::arbitrary<std::uint8_t>());
    const bool ok = memory.program(address, std::as_bytes(std::span{values})) == FlashResult::ok;
    RC_ASSERT(ok == (address < 64 && address / 16 == (address + values.size() - 1) / 16));
    for (std::size_t bit = 0; ok && bit < 8 * values.size(); ++bit) {
      if ((values[bit / 8] >> (bit % 8) & 1) == 0) {
        cleared[std::size_t{8} * address + bit] = true;
      }
    }
  }
  for (std::size_t bit = 0; bit < cleared.size(); ++bit) {
    RC_ASSERT((cells[bit / 8] >> (bit % 8) & std::byte{1}) == (cleared[bit] ? std::byte{0} : std::byte{1}));
  }
}

}  // namespace
}  // namespace fantail::hal
