// SPDX-License-Identifier: MIT
#include "avionics/plan_store.hpp"

#include "plan_store_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

TEST(PlanStore, ABlankFlashHasNoPlanAndNothingIsBroken) {
  const PlanBoard board;
  EXPECT_FALSE(board.found.plan.has_value());
  EXPECT_FALSE(board.found.broken);
  EXPECT_FALSE(board.found.flash_failed);
}

TEST(PlanStore, APlanThatWasWrittenIsThereAfterPowerUpWithTheChecksumOfItsBlock) {
  const PlanBoard board{flash_with({7})};
  EXPECT_EQ(board.number(), 7);
  EXPECT_EQ(board.found.block_crc, protocol::plan_block_crc(block_of(numbered_plan(7))));
  EXPECT_FALSE(board.found.broken);
}

TEST(PlanStore, OfManyWrittenPlansTheLastIsFound) {
  EXPECT_EQ((PlanBoard{flash_with({1, 2})}.number()), 2);
  EXPECT_EQ((PlanBoard{flash_with({1, 2, 3})}.number()), 3);
  EXPECT_EQ((PlanBoard{flash_with({9, 8, 7, 6, 5})}.number()), 5);
}

TEST(PlanStore, GoesOnWithTheOtherSlotAfterPowerUp) {
  Bytes cells = flash_with({1});
  for (int number = 2; number < 8; ++number) {
    PlanBoard board{cells};
    EXPECT_EQ(board.number(), number - 1);
    const Bytes other_slot = board.cells();
    board.write(block_of(numbered_plan(number)));
    cells = board.cells();
    const std::ptrdiff_t spared = number % 2 == 0 ? 0 : 4096;
    EXPECT_TRUE(std::equal(cells.begin() + spared, cells.begin() + spared + 4096, other_slot.begin() + spared));
  }
}

TEST(PlanStore, TheSlotsKeepToThemselves) {
  PlanBoard board{Bytes(small_flash.size, std::byte{0x5A})};
  EXPECT_TRUE(board.found.broken);
  board.write(block_of(numbered_plan(1)));
  board.write(block_of(numbered_plan(2)));
  const Bytes cells = board.cells();
  EXPECT_TRUE(std::all_of(cells.begin() + 8192, cells.end(), [](std::byte b) { return b == std::byte{0x5A}; }));
}

TEST(PlanStore, EverySizeOfBlockIsWrittenAndReadBack) {
  for (const std::size_t size : {1U, 255U, 256U, 257U, 511U, 512U, 1023U, 1024U}) {
    PlanBoard board;
    Bytes block(size);
    for (std::size_t i = 0; i < size; ++i) {
      block[i] = static_cast<std::byte>(i * 7 + 1);
    }
    board.write(block);
    EXPECT_EQ(board.store.write(), PlanWrite::stored) << size;
    const Bytes cells = board.cells();
    EXPECT_TRUE(std::equal(block.begin(), block.end(), cells.begin() + 256)) << size;
    EXPECT_EQ(board.flash.begun(), 1 + (size + 255) / 256 + 1) << "erase, pages, header";
  }
}

TEST(PlanStore, PagesOfOtherSizesDo) {
  for (const std::uint32_t page : {16U, 64U, 512U, 1024U, 2048U}) {
    const hal::FlashGeometry geometry{.size = 65'536, .sector_size = 4096, .page_size = page};
    EXPECT_EQ((PlanBoard{flash_with({1, 2, 3}, geometry), geometry}.number()), 3) << page;
  }
}

TEST(PlanStore, EverySingleBitOfTheStoredSlotThatFlipsIsNoticed) {
  Bytes cells = flash_with({7});
  const std::size_t block = block_of(numbered_plan(7)).size();
  for (std::size_t byte = 0; byte < 256 + block; byte = byte + 1 == slot_header_size ? 256 : byte + 1) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      cells[byte] ^= std::byte{1} << bit;
      const PlanBoard board{cells};
      ASSERT_FALSE(board.found.plan.has_value()) << byte << " " << bit;
      ASSERT_TRUE(board.found.broken) << byte << " " << bit;
      cells[byte] ^= std::byte{1} << bit;
    }
  }
}

TEST(PlanStore, EverySingleBitOfTheNewerSlotThatFlipsLeavesTheOlderPlanAndSaysSo) {
  Bytes cells = flash_with({7, 8});
  const std::size_t block = block_of(numbered_plan(8)).size();
  for (std::size_t byte = 0; byte < 256 + block; byte = byte + 1 == slot_header_size ? 256 : byte + 1) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      cells[4096 + byte] ^= std::byte{1} << bit;
      const PlanBoard board{cells};
      ASSERT_EQ(board.number(), 7) << byte << " " << bit;
      ASSERT_TRUE(board.found.broken) << byte << " " << bit;
      cells[4096 + byte] ^= std::byte{1} << bit;
    }
  }
}

TEST(PlanStore, AnIntactBlockThatMustNotFlyIsBrokenAndIsTheOneThatIsOverwritten) {
  core::FlightPlan bad = numbered_plan(8);
  bad.controller.canard_limit = core::Angle::from_degrees(90.0F);
  PlanBoard board{flash_with({7})};
  board.write(block_of(bad));  // the store keeps blocks; who offers one has looked at it
  PlanBoard next{board.cells()};
  EXPECT_EQ(next.number(), 7);
  EXPECT_TRUE(next.found.broken);
  next.write(block_of(numbered_plan(9)));
  const PlanBoard after{next.cells()};
  EXPECT_EQ(after.number(), 9);
  EXPECT_FALSE(after.found.broken);
}

TEST(FlashMap, EverythingHasItsOwnSectorsAndTheFlightRegionIsTheRest) {
  constexpr auto map = flash_map(hal::sim::flash_16_mib);
  static_assert(map.has_value());
  EXPECT_EQ(map->plan_slots, (std::array<std::uint32_t, 2>{0, 4096}));
  EXPECT_EQ(map->boot_sectors, (std::array<std::uint32_t, 2>{8192, 12'288}));
  EXPECT_EQ(map->flight_begin, 16'384U);
  EXPECT_EQ(map->flight_end, 16'777'216U);
  EXPECT_EQ(map->flight_sectors(), 4092U);
}

TEST(FlashMap, AFlashThatIsTooSmallOrMakesNoSenseHasNone) {
  EXPECT_TRUE(flash_map({20'480, 4096, 256}).has_value());
  EXPECT_FALSE(flash_map({16'384, 4096, 256}).has_value()) << "no sector for flights";
  EXPECT_FALSE(flash_map({65'536, 1024, 256}).has_value()) << "a block and its header need five pages";
  EXPECT_FALSE(flash_map({65'536, 4096, 4096}).has_value()) << "the header needs a page of its own";
  EXPECT_FALSE(flash_map({65'536, 4096, 8}).has_value()) << "a page is smaller than a header";
  EXPECT_FALSE(flash_map({65'537, 4096, 256}).has_value());
  EXPECT_FALSE(flash_map({0, 0, 0}).has_value());
}

}  // namespace
}  // namespace fantail::avionics
