// SPDX-License-Identifier: MIT
#include "avionics/boot_counter.hpp"

#include "avionics/sealed_words.hpp"
#include "flash_rig.hpp"
#include "properties.hpp"
#include "random_stream.hpp"

namespace fantail::avionics {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t first_sector = 8192;
constexpr std::size_t second_sector = 12'288;

struct Board : FlashRig {
  FlashAccess access{flash};
  BootCounter boots{access};

  using FlashRig::FlashRig;

  // Number of ticks it took.
  int run(int most_ticks = 10'000) {
    int ticks = 0;
    for (; !boots.finished() && ticks < most_ticks; ++ticks) {
      boots.update(world.time);
      world.time += tick;
    }
    return ticks;
  }
};

void put_record(Bytes& cells, std::size_t at, std::uint32_t count) {
  std::ranges::copy(seal<1>({count}), cells.begin() + static_cast<std::ptrdiff_t>(at));
}

// A flash that has seen this many power-ups, as the description of the format says.
Bytes flash_after(std::uint32_t boots) {
  Bytes cells(small_flash.size, std::byte{0xFF});
  for (std::uint32_t count = 1; count <= boots; ++count) {
    const std::uint32_t slot = (count - 1) % 512;
    const std::size_t sector = (count - 1) / 512 % 2 == 0 ? second_sector : first_sector;
    if (slot == 0) {
      std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(sector), 4096, std::byte{0xFF});
    }
    put_record(cells, sector + std::size_t{8} * slot, count);
  }
  return cells;
}

TEST(BootCounter, CountsAThousandPowerUpsWithOneProgramEach) {
  Bytes cells(small_flash.size, std::byte{0xFF});
  std::uint64_t begun = 0;
  for (std::uint32_t boot = 1; boot <= 1100; ++boot) {
    Board board{cells};
    board.run();
    ASSERT_EQ(board.boots.count(), boot);
    ASSERT_LE(board.flash.begun(), 2U);
    begun += board.flash.begun();
    cells = board.cells();
    if (boot == 1 || boot == 512 || boot == 513 || boot == 1100) {
      ASSERT_EQ(cells, flash_after(boot)) << boot;
    }
  }
  EXPECT_EQ(begun, 1100U + 3U) << "one program each, and an erase for every 512";
}

TEST(BootCounter, LeavesEverySectorButItsOwnAlone) {
  Board board{Bytes(small_flash.size, std::byte{0x5A})};
  board.run();
  EXPECT_TRUE(board.boots.count().has_value());
  const Bytes cells = board.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    ASSERT_TRUE((i >= first_sector && i < first_sector + 8192) || cells[i] == std::byte{0x5A}) << i;
  }
}

TEST(BootCounter, HasNoCountUntilItHasBeenReadBack) {
  Board board{flash_after(3)};
  for (int ticks = 0; !board.boots.finished(); ++ticks) {
    ASSERT_FALSE(board.boots.count().has_value()) << ticks;
    board.boots.update(board.world.time);
    board.world.time += tick;
  }
  EXPECT_EQ(board.boots.count(), 4U);
  EXPECT_FALSE(board.flash.busy());
}

TEST(BootCounter, NoCountIsEverRepeatedAfterAPowerCutAtAnyPoint) {
  for (const std::uint32_t before : {0U, 1U, 2U, 510U, 511U, 512U, 513U, 1023U, 1024U, 1025U, 1536U}) {
    const Bytes cells = flash_after(before);
    const int whole = Board{cells}.run();
    for (int ticks = whole - 12; ticks <= whole; ++ticks) {  // before that, it only reads
      for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Board cut{cells};
        cut.run(ticks);
        const auto handed_out = cut.boots.count();
        cut.flash.cut_power(seed);
        Board next{cut.cells()};
        next.run();
        ASSERT_TRUE(next.boots.count().has_value());
        ASSERT_GT(*next.boots.count(), handed_out.value_or(before)) << "tick " << ticks << " seed " << seed;
        ASSERT_LE(*next.boots.count(), before + 514) << "and it wastes at most a sector of counts";
        Board after{next.cells()};
        after.run();
        ASSERT_EQ(after.boots.count(), *next.boots.count() + 1);
      }
    }
    EXPECT_EQ(Board{cells}.run(whole - 12), whole - 12);
  }
}

RC_GTEST_PROP(BootCounter, ALifeOfPowerCutsNeverRepeatsACount, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  Bytes cells = flash_after(static_cast<std::uint32_t>(random.whole(400, 520)));
  std::uint32_t highest = 0;
  for (int life = 0; life < 150; ++life) {
    Board board{cells};
    board.run(random.chance(0.5) ? 1000 : random.whole(30, 42));
    if (const auto count = board.boots.count()) {
      RC_ASSERT(*count > highest);
      highest = *count;
    }
    board.flash.cut_power(static_cast<std::uint64_t>(random.whole(0, 1'000'000)));
    cells = board.cells();
  }
  RC_ASSERT(highest >= 400U + 50U);
}

TEST(BootCounter, AnySingleBitThatFlipsInItsSectorsRepeatsNoCount) {
  for (const std::uint32_t before : {1U, 5U, 512U, 513U, 514U}) {
    const Bytes cells = flash_after(before);
    const std::size_t newest =
        ((before - 1) / 512 % 2 == 0 ? second_sector : first_sector) + std::size_t{8} * ((before - 1) % 512);
    for (std::size_t byte = first_sector; byte < first_sector + 8192;
         byte += (byte + 24 >= newest && byte < newest + 24) ? 1 : 61) {
      for (unsigned bit = 0; bit < 8; ++bit) {
        Bytes flipped = cells;
        flipped[byte] ^= std::byte{1} << bit;
        Board board{flipped};
        board.run();
        ASSERT_TRUE(board.boots.count().has_value());
        ASSERT_GT(*board.boots.count(), before) << byte << " " << bit;
        ASSERT_LE(*board.boots.count(), before + 2) << byte << " " << bit;
      }
    }
  }
}

TEST(BootCounter, ASectorThatOnlyLooksBlankIsErasedBeforeItIsUsed) {
  Board board{flash_after(512)};
  board.run();
  EXPECT_EQ(board.boots.count(), 513U);
  EXPECT_EQ(board.flash.begun(), 2U) << "an erase and a program";
}

TEST(BootCounter, ErasedFlashIsNoRecordAlthoughItsChecksumIsRight) {
  const std::array<std::byte, 4> ones{std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}};
  EXPECT_EQ(protocol::crc32c(ones), 0xFFFFFFFFU) << "the trap";
  Bytes blank(8, std::byte{0xFF});
  EXPECT_FALSE(unseal<1>(std::span{blank}.first<8>()).has_value());
}

TEST(BootCounter, ASlotWithABitThatIsStuckIsPassedOverAndItsCountIsNotUsed) {
  for (const std::byte stuck : {std::byte{0x00}, std::byte{0xFF}}) {  // seen at once; seen when it is read back
    Board board{flash_after(10)};
    board.flash.stick(second_sector + 80, std::byte{0x04}, stuck);
    board.run();
    EXPECT_EQ(board.boots.count(), 12U);
    const Bytes cells = board.cells();
    EXPECT_EQ(unseal<1>(std::span{cells}.subspan(second_sector + 88).first<8>())->front(), 12U);
  }
}

TEST(BootCounter, AFlashThatKeepsNothingFailsAfterFourSlots) {
  Board board{flash_after(10)};
  for (std::uint32_t at = 0; at < 4096; ++at) {
    board.flash.stick(static_cast<std::uint32_t>(second_sector) + at, std::byte{0xFF}, std::byte{0xFF});
  }
  board.run();
  EXPECT_TRUE(board.boots.failed());
  EXPECT_FALSE(board.boots.count().has_value());
  EXPECT_EQ(board.flash.begun(), 5U) << "an erase and four programs";
}

TEST(BootCounter, StopsAtTheLastNumberAndDoesNotBeginAgain) {
  Bytes cells(small_flash.size, std::byte{0xFF});
  put_record(cells, first_sector, 0xFFFFFFFDU);
  Board last{cells};
  last.run();
  EXPECT_EQ(last.boots.count(), 0xFFFFFFFEU) << "the record of the next number reads like erased flash";
  Board beyond{last.cells()};
  beyond.run();
  EXPECT_TRUE(beyond.boots.failed());
  EXPECT_EQ(beyond.flash.begun(), 0U);
}

TEST(BootCounter, AFlashThatDoesNotAnswerOrStaysBusyHasFailed) {
  Board silent;
  silent.flash.set_answers(false);
  EXPECT_EQ(silent.run(), 1);
  EXPECT_TRUE(silent.boots.failed());
  Board busy;
  busy.flash.set_stays_busy(true);
  EXPECT_EQ(busy.run(), 2002);
  EXPECT_TRUE(busy.boots.failed());
  Board too_small{hal::FlashGeometry{.size = 8192, .sector_size = 4096, .page_size = 256}};
  too_small.run();
  EXPECT_TRUE(too_small.boots.failed());
}

}  // namespace
}  // namespace fantail::avionics
