// SPDX-License-Identifier: MIT
#include "avionics/plan_store.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "flash_rig.hpp"
#include "random_stream.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t header_size = 16;

// A board that has just been powered up on this flash.
struct Board : FlashRig {
  FlashAccess access{flash};
  PlanStore store{access};
  StoredPlan found{};

  explicit Board(const hal::FlashGeometry& geometry = small_flash) : FlashRig{geometry} { load(); }
  explicit Board(std::span<const std::byte> cells, const hal::FlashGeometry& geometry = small_flash)
      : FlashRig{cells, geometry} {
    load();
  }
  void load() {
    const auto loaded = store.load(world.time);
    ASSERT_TRUE(loaded.has_value());
    found = *loaded;
  }
  // 0: no plan.
  [[nodiscard]] int number() const { return found.plan ? number_of(*found.plan) : 0; }

  // Number of ticks it took.
  int write(const Bytes& block, int most_ticks = 10'000) {
    store.begin_write(block);
    int ticks = 0;
    for (; store.write() == PlanWrite::under_way && ticks < most_ticks; ++ticks) {
      store.update(world.time);
      world.time += tick;
    }
    return ticks;
  }
};

Bytes flash_with(std::initializer_list<int> numbers, const hal::FlashGeometry& geometry = small_flash) {
  Board board{geometry};
  for (const int number : numbers) {
    board.write(block_of(numbered_plan(number)));
    EXPECT_EQ(board.store.write(), PlanWrite::stored);
  }
  return board.cells();
}

TEST(PlanStore, ABlankFlashHasNoPlanAndNothingIsBroken) {
  const Board board;
  EXPECT_FALSE(board.found.plan.has_value());
  EXPECT_FALSE(board.found.broken);
  EXPECT_FALSE(board.found.flash_failed);
}

TEST(PlanStore, APlanThatWasWrittenIsThereAfterPowerUpWithTheChecksumOfItsBlock) {
  const Board board{flash_with({7})};
  EXPECT_EQ(board.number(), 7);
  EXPECT_EQ(board.found.block_crc, protocol::plan_block_crc(block_of(numbered_plan(7))));
  EXPECT_FALSE(board.found.broken);
}

TEST(PlanStore, OfManyWrittenPlansTheLastIsFound) {
  EXPECT_EQ((Board{flash_with({1, 2})}.number()), 2);
  EXPECT_EQ((Board{flash_with({1, 2, 3})}.number()), 3);
  EXPECT_EQ((Board{flash_with({9, 8, 7, 6, 5})}.number()), 5);
}

TEST(PlanStore, GoesOnWithTheOtherSlotAfterPowerUp) {
  Bytes cells = flash_with({1});
  for (int number = 2; number < 8; ++number) {
    Board board{cells};
    EXPECT_EQ(board.number(), number - 1);
    const Bytes other_slot = board.cells();
    board.write(block_of(numbered_plan(number)));
    cells = board.cells();
    const std::ptrdiff_t spared = number % 2 == 0 ? 0 : 4096;
    EXPECT_TRUE(std::equal(cells.begin() + spared, cells.begin() + spared + 4096, other_slot.begin() + spared));
  }
}

TEST(PlanStore, TheSlotsKeepToThemselves) {
  Board board{Bytes(small_flash.size, std::byte{0x5A})};
  EXPECT_TRUE(board.found.broken);
  board.write(block_of(numbered_plan(1)));
  board.write(block_of(numbered_plan(2)));
  const Bytes cells = board.cells();
  EXPECT_TRUE(std::all_of(cells.begin() + 8192, cells.end(), [](std::byte b) { return b == std::byte{0x5A}; }));
}

TEST(PlanStore, EverySizeOfBlockIsWrittenAndReadBack) {
  for (const std::size_t size : {1U, 255U, 256U, 257U, 511U, 512U, 1023U, 1024U}) {
    Board board;
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
    EXPECT_EQ((Board{flash_with({1, 2, 3}, geometry), geometry}.number()), 3) << page;
  }
}

TEST(PlanStore, EverySingleBitOfTheStoredSlotThatFlipsIsNoticed) {
  Bytes cells = flash_with({7});
  const std::size_t block = block_of(numbered_plan(7)).size();
  for (std::size_t byte = 0; byte < 256 + block; byte = byte + 1 == header_size ? 256 : byte + 1) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      cells[byte] ^= std::byte{1} << bit;
      const Board board{cells};
      ASSERT_FALSE(board.found.plan.has_value()) << byte << " " << bit;
      ASSERT_TRUE(board.found.broken) << byte << " " << bit;
      cells[byte] ^= std::byte{1} << bit;
    }
  }
}

TEST(PlanStore, EverySingleBitOfTheNewerSlotThatFlipsLeavesTheOlderPlanAndSaysSo) {
  Bytes cells = flash_with({7, 8});
  const std::size_t block = block_of(numbered_plan(8)).size();
  for (std::size_t byte = 0; byte < 256 + block; byte = byte + 1 == header_size ? 256 : byte + 1) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      cells[4096 + byte] ^= std::byte{1} << bit;
      const Board board{cells};
      ASSERT_EQ(board.number(), 7) << byte << " " << bit;
      ASSERT_TRUE(board.found.broken) << byte << " " << bit;
      cells[4096 + byte] ^= std::byte{1} << bit;
    }
  }
}

TEST(PlanStore, AnIntactBlockThatMustNotFlyIsBrokenAndIsTheOneThatIsOverwritten) {
  core::FlightPlan bad = numbered_plan(8);
  bad.controller.canard_limit = core::Angle::from_degrees(90.0F);
  Board board{flash_with({7})};
  board.write(block_of(bad));  // the store keeps blocks; who offers one has looked at it
  Board next{board.cells()};
  EXPECT_EQ(next.number(), 7);
  EXPECT_TRUE(next.found.broken);
  next.write(block_of(numbered_plan(9)));
  const Board after{next.cells()};
  EXPECT_EQ(after.number(), 9);
  EXPECT_FALSE(after.found.broken);
}

// Each tick of a write, and many ways in which the cells were caught.
TEST(PlanStore, APowerCutAtAnyPointOfAWriteLeavesTheOldPlanOrTheWholeNewOne) {
  const Bytes block = block_of(numbered_plan(3));
  for (const auto& before : {flash_with({}), flash_with({1}), flash_with({1, 2}), flash_with({9, 1, 2})}) {
    const int old_number = Board{before}.number();
    const int whole = Board{before}.write(block);
    const std::uint64_t programs = 1 + (block.size() + 255) / 256;  // before the header
    int cut_before_the_header = 0;
    for (int ticks = 0; ticks <= whole; ++ticks) {
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        Board board{before};
        board.write(block, ticks);
        board.flash.cut_power(seed);
        const Board next{board.cells()};
        if (board.flash.begun() <= programs) {
          ASSERT_EQ(next.number(), old_number) << "tick " << ticks << " seed " << seed;
          cut_before_the_header += 1;
        } else if (next.number() != old_number) {
          ASSERT_EQ(next.number(), 3) << "tick " << ticks << " seed " << seed;
        }
        if (board.store.write() == PlanWrite::stored) {
          ASSERT_EQ(next.number(), 3);
        }
      }
    }
    EXPECT_GT(cut_before_the_header, 40 * 8);
  }
}

// Writes and cuts in any order: only what was stored, or was being stored at the cut, is ever found.
RC_GTEST_PROP(PlanStore, ALifeOfPowerCutsNeverLosesTheLastStoredPlan, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  Bytes cells(small_flash.size, std::byte{0xFF});
  int known = 0;
  for (int life = 0; life < 60; ++life) {
    Board board{cells};
    const int found = board.number();
    RC_ASSERT(found == known);
    RC_ASSERT(found != 0 || life < 40);  // by then one has got through
    const int number = random.whole(1, 100);
    board.write(block_of(numbered_plan(number)), random.chance(0.3) ? 1000 : random.whole(0, 16));
    board.flash.cut_power(static_cast<std::uint64_t>(random.whole(0, 1'000'000)));
    cells = board.cells();
    const int after = Board{cells}.number();
    RC_ASSERT(after == found || after == number);
    RC_ASSERT(board.store.write() != PlanWrite::stored || after == number);
    known = after;
  }
}

TEST(PlanStore, AWriteAsksOneThingATick) {
  FlashRig rig;
  WatchedFlash watched{rig.flash};
  FlashAccess access{watched};
  PlanStore store{access};
  ASSERT_TRUE(store.load(rig.world.time).has_value());
  const Bytes block(1024, std::byte{0x42});
  store.begin_write(block);
  while (store.write() == PlanWrite::under_way) {
    watched.calls = 0;
    watched.bytes_read = 0;
    store.update(rig.world.time);
    rig.world.time += tick;
    ASSERT_LE(watched.calls, 1);
    ASSERT_LE(watched.bytes_read, 256U);
    ASSERT_LT(rig.world.time, 1s);
  }
  EXPECT_EQ(store.write(), PlanWrite::stored);
}

TEST(PlanStore, AFlashThatStaysBusyForMoreThanTwoSecondsHasFailed) {
  Board board{flash_with({1})};
  board.flash.set_stays_busy(true);
  const int ticks = board.write(block_of(numbered_plan(2)));
  EXPECT_EQ(board.store.write(), PlanWrite::flash_failed);
  EXPECT_EQ(ticks, 2002);  // the first one at 0 s, the last one at 2.001 s
  EXPECT_EQ((Board{board.cells()}.number()), 1);
}

TEST(PlanStore, AFlashThatBecomesBusyOrSilentInTheMiddleLeavesTheOldPlan) {
  const Bytes before = flash_with({1});
  const Bytes block = block_of(numbered_plan(2));
  const int whole = Board{before}.write(block);
  for (int ticks = 0; ticks < whole; ++ticks) {
    for (const bool silent : {false, true}) {
      Board board{before};
      board.write(block, ticks);
      board.flash.set_stays_busy(!silent);
      board.flash.set_answers(!silent);
      for (int i = 0; i < 2100; ++i) {
        board.store.update(board.world.time);
        board.world.time += tick;
      }
      EXPECT_EQ(board.store.write(), PlanWrite::flash_failed) << ticks;
      if (board.flash.begun() < 4) {
        EXPECT_EQ((Board{board.cells()}.number()), 1) << ticks;
      }
    }
  }
}

TEST(PlanStore, AFlashThatIsStillBusyAtPowerUpIsAskedAgain) {
  FlashRig rig{flash_with({1})};
  EXPECT_EQ(rig.flash.erase_sector(4096), hal::FlashResult::ok);  // begun before a reset of the processor alone
  FlashAccess access{rig.flash};
  PlanStore store{access};
  EXPECT_FALSE(store.load(rig.world.time).has_value());
  rig.world.time += 4ms;
  const auto found = store.load(rig.world.time);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->plan.has_value());
}

TEST(PlanStore, AFlashThatCannotBeReadAtPowerUpIsSaidAndNeverWritten) {
  FlashRig rig{flash_with({1})};
  FlashAccess access{rig.flash};
  PlanStore store{access};
  rig.flash.set_answers(false);
  const auto found = store.load(rig.world.time);
  ASSERT_TRUE(found.has_value());
  EXPECT_TRUE(found->flash_failed);
  EXPECT_FALSE(found->plan.has_value());
  rig.flash.set_answers(true);
  const Bytes block = block_of(numbered_plan(2));
  store.begin_write(block);
  EXPECT_EQ(store.write(), PlanWrite::flash_failed);
  EXPECT_EQ(rig.flash.begun(), 0U);
}

TEST(PlanStore, AFlashThatDoesNotKeepWhatItWasToldIsFoundOutBeforeTheOldPlanIsLost) {
  const Bytes before = flash_with({1});
  const Bytes block = block_of(numbered_plan(2));
  for (std::uint32_t at = 0; at < 256 + block.size(); at += at + 1 == header_size ? 241 : 1) {
    const std::byte right = at < header_size ? std::byte{} : block[at < 256 ? 0 : at - 256];
    Board board{before};
    // A bit of the block that cannot become what it should be; of the header, all bits, whatever they should be.
    board.flash.stick(4096 + at, at < header_size ? std::byte{0xFF} : std::byte{0x10},
                      at < header_size ? std::byte{0xFF} : ~right);
    board.write(block);
    const bool header_is_ones = at < header_size && board.store.write() == PlanWrite::stored;
    if (!header_is_ones) {
      ASSERT_EQ(board.store.write(), PlanWrite::read_back_differs) << at;
      ASSERT_TRUE(board.store.load(board.world.time).has_value());
      ASSERT_EQ(number_of(*board.store.load(board.world.time)->plan), 1) << at;
    }
  }
}

TEST(PlanStore, AWriteIsWithdrawnOnlyBeforeItsErase) {
  const Bytes block = block_of(numbered_plan(2));
  Board board{flash_with({1})};
  board.store.begin_write(block);
  EXPECT_TRUE(board.store.withdraw());
  EXPECT_EQ(board.store.write(), PlanWrite::none);
  board.store.update(board.world.time);
  EXPECT_EQ(board.flash.begun(), 0U);
  board.store.begin_write(block);
  board.store.update(board.world.time);
  EXPECT_EQ(board.flash.begun(), 1U);
  EXPECT_FALSE(board.store.withdraw());
  EXPECT_EQ(board.store.write(), PlanWrite::under_way);
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
