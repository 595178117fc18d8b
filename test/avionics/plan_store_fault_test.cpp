// SPDX-License-Identifier: MIT
#include "avionics/plan_store.hpp"
#include "avionics/sealed_words.hpp"
#include "plan_store_rig.hpp"
#include "properties.hpp"
#include "random_stream.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;

// Each tick of a write, and many ways in which the cells were caught.
TEST(PlanStore, APowerCutAtAnyPointOfAWriteLeavesTheOldPlanOrTheWholeNewOne) {
  const Bytes block = block_of(numbered_plan(3));
  for (const auto& before : {flash_with({}), flash_with({1}), flash_with({1, 2}), flash_with({9, 1, 2})}) {
    const int old_number = PlanBoard{before}.number();
    const int whole = PlanBoard{before}.write(block);
    const std::uint64_t programs = 1 + (block.size() + 255) / 256;  // before the header
    int cut_before_the_header = 0;
    for (int ticks = 0; ticks <= whole; ++ticks) {
      for (std::uint64_t seed = 0; seed < 40; ++seed) {
        PlanBoard board{before};
        board.write(block, ticks);
        board.flash.cut_power(seed);
        const PlanBoard next{board.cells()};
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
    PlanBoard board{cells};
    const int found = board.number();
    RC_ASSERT(found == known);
    RC_ASSERT(found != 0 || life < 40);  // by then one has got through
    const int number = random.whole(1, 100);
    board.write(block_of(numbered_plan(number)), random.chance(0.3) ? 1000 : random.whole(0, 16));
    board.flash.cut_power(static_cast<std::uint64_t>(random.whole(0, 1'000'000)));
    cells = board.cells();
    const int after = PlanBoard{cells}.number();
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
  PlanBoard board{flash_with({1})};
  board.flash.set_stays_busy(true);
  const int ticks = board.write(block_of(numbered_plan(2)));
  EXPECT_EQ(board.store.write(), PlanWrite::flash_failed);
  EXPECT_EQ(ticks, 2002);  // the first one at 0 s, the last one at 2.001 s
  EXPECT_EQ((PlanBoard{board.cells()}.number()), 1);
}

TEST(PlanStore, AFlashThatBecomesBusyOrSilentInTheMiddleLeavesTheOldPlan) {
  const Bytes before = flash_with({1});
  const Bytes block = block_of(numbered_plan(2));
  const int whole = PlanBoard{before}.write(block);
  for (int ticks = 0; ticks < whole; ++ticks) {
    for (const bool silent : {false, true}) {
      PlanBoard board{before};
      board.write(block, ticks);
      board.flash.set_stays_busy(!silent);
      board.flash.set_answers(!silent);
      for (int i = 0; i < 2100; ++i) {
        board.store.update(board.world.time);
        board.world.time += tick;
      }
      EXPECT_EQ(board.store.write(), PlanWrite::flash_failed) << ticks;
      if (board.flash.begun() < 4) {
        EXPECT_EQ((PlanBoard{board.cells()}.number()), 1) << ticks;
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
  for (std::uint32_t at = 0; at < 256 + block.size(); at += at + 1 == slot_header_size ? 241 : 1) {
    const std::byte right = at < slot_header_size ? std::byte{} : block[at < 256 ? 0 : at - 256];
    PlanBoard board{before};
    // A bit of the block that cannot become what it should be; of the header, all bits, whatever they should be.
    board.flash.stick(4096 + at, at < slot_header_size ? std::byte{0xFF} : std::byte{0x10},
                      at < slot_header_size ? std::byte{0xFF} : ~right);
    board.write(block);
    const bool header_is_ones = at < slot_header_size && board.store.write() == PlanWrite::stored;
    if (!header_is_ones) {
      ASSERT_EQ(board.store.write(), PlanWrite::read_back_differs) << at;
      ASSERT_TRUE(board.store.load(board.world.time).has_value());
      ASSERT_EQ(number_of(*board.store.load(board.world.time)->plan), 1) << at;
    }
  }
}

/// Reads the beginning of the second slot wrongly, as often as it is told; the cells are right.
class DisturbedFlash final : public hal::Flash {
 public:
  DisturbedFlash(hal::Flash& flash, int reads) : flash_{flash}, reads_{reads} {}
  [[nodiscard]] hal::FlashGeometry geometry() const override { return flash_.geometry(); }
  hal::FlashResult read(std::uint32_t address, std::span<std::byte> out) override {
    const hal::FlashResult result = flash_.read(address, out);
    if (result == hal::FlashResult::ok && loaded && address == 4096 && reads_ > 0) {
      reads_ -= 1;
      out[0] ^= std::byte{1};
    }
    return result;
  }
  hal::FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) override {
    return flash_.program(address, bytes);
  }
  hal::FlashResult erase_sector(std::uint32_t address) override { return flash_.erase_sector(address); }
  [[nodiscard]] bool busy() override { return flash_.busy(); }

  bool loaded = false;

 private:
  hal::Flash& flash_;
  int reads_;
};

// The bus was told that the old plan stays in force, so that is the one of the next power-up.
TEST(PlanStore, AHeaderThatWasReadBackWronglyDoesNotWinAtTheNextPowerUp) {
  for (const int wrong_reads : {1, 1000}) {
    FlashRig rig{flash_with({1})};
    DisturbedFlash disturbed{rig.flash, wrong_reads};
    FlashAccess access{disturbed};
    PlanStore store{access};
    ASSERT_TRUE(store.load(rig.world.time).has_value());
    disturbed.loaded = true;
    const Bytes block = block_of(numbered_plan(2));
    store.begin_write(block);
    for (int ticks = 0; store.write() == PlanWrite::under_way && ticks < 1'000; ++ticks) {
      store.update(rig.world.time);
      rig.world.time += tick;
    }
    EXPECT_EQ(store.write(), PlanWrite::read_back_differs);
    EXPECT_EQ((PlanBoard{rig.cells()}.number()), 1) << wrong_reads;

    // And a write after it is as good as ever.
    disturbed.loaded = false;
    store.begin_write(block);
    for (int ticks = 0; store.write() == PlanWrite::under_way && ticks < 1'000; ++ticks) {
      store.update(rig.world.time);
      rig.world.time += tick;
    }
    EXPECT_EQ(store.write(), PlanWrite::stored);
    EXPECT_EQ((PlanBoard{rig.cells()}.number()), 2) << wrong_reads;
  }
}

// Headers with their right checksum, as only another program could have written them.
TEST(PlanStore, AnIntactHeaderThatDoesNotFitItsBlockIsBroken) {
  const Bytes block = block_of(numbered_plan(7));
  const auto size = static_cast<std::uint32_t>(block.size());
  const std::uint32_t crc = protocol::plan_block_crc(block);
  struct Case {
    std::uint32_t size;
    std::uint32_t crc;
  };
  for (const Case& bad : {Case{0, crc}, Case{0, 0}, Case{size - 1, crc}, Case{size + 1, crc}, Case{1025, crc},
                          Case{0xFFFFFFFFU, crc}, Case{size, crc ^ 1U}}) {
    Bytes cells = flash_with({7});
    std::ranges::copy(seal<3>({1, bad.size, bad.crc}), cells.begin());
    const PlanBoard board{cells};
    EXPECT_FALSE(board.found.plan.has_value()) << bad.size;
    EXPECT_TRUE(board.found.broken) << bad.size;
  }
  Bytes cells = flash_with({7});
  std::ranges::copy(seal<3>({1, size, crc}), cells.begin());
  EXPECT_EQ(PlanBoard{cells}.number(), 7) << "the layout that this test assumes";
}

TEST(PlanStore, AWriteIsWithdrawnOnlyBeforeItsErase) {
  const Bytes block = block_of(numbered_plan(2));
  PlanBoard board{flash_with({1})};
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

}  // namespace
}  // namespace fantail::avionics
