// SPDX-License-Identifier: MIT
// What was downloaded is verified whole before anybody relies on it: the file on the PC, the bus and the flash can each
// be at fault, and only the last of them is damage of the record.

#include "link/log_download.hpp"
#include "link/made_record.hpp"
#include "random_stream.hpp"
#include "seed.hpp"
#include "sil/bench_at_world.hpp"
#include "sil/bus_filter.hpp"
#include "system/folder.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

using link::LogCheck;
using link::LogPart;
using test::Bytes;

constexpr std::uint32_t record_begin = 4 * 4096;

/// Two flights in the flash, and what was downloaded of them earlier in a file on the PC.
class LogVerify : public testing::Test {
 protected:
  LogVerify() {
    record = test::flight(0, 400, "first");
    test::fill_sector(record);
    second_begin = static_cast<std::uint32_t>(record.size());
    protocol::append(record, test::flight(1, 100, "second"));
    test::fill_sector(record);
    std::ranges::copy(record, place.flash.cells().begin() + record_begin);
    place.power_cycle();
  }

  void damage_flash(std::uint32_t at, std::uint32_t size) {
    std::ranges::fill(place.flash.cells().subspan(record_begin + at, size), std::byte{0});
  }
  /// As `bench log` does it: goes on with `there`, and verifies.
  LogCheck log(
      const Bytes& there, link::LogReader& with, std::uint32_t* fetched_again = nullptr,
      const std::function<void()>& between = [] {}) {
    LogPart part{path};
    part.start_anew();
    part.append(there);
    const link::LogStretch stretch{.offset = 0, .size = with.info().used_bytes};
    resumed = link::download(with, stretch, part, [](std::uint32_t) {});
    between();
    const LogCheck check = link::verify(with, stretch, part, resumed, [&](std::uint32_t bytes) {
      if (fetched_again != nullptr) {
        *fetched_again = bytes;
      }
    });
    copy = part.read(0, stretch.size);
    return check;
  }
  LogCheck log(const Bytes& there) { return log(there, reader); }

  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::LogReader reader{place, link};
  test::Folder folder;
  const std::string path = folder / "record.part";
  Bytes record;
  Bytes copy;
  std::uint32_t second_begin = 0;
  std::uint32_t resumed = 0;
};

TEST_F(LogVerify, AWholeDownloadIsIntactAndNothingOfItIsFetchedTwice) {
  EXPECT_EQ(reader.info().used_bytes, record.size());
  const LogCheck check = log({});
  EXPECT_TRUE(check.intact);
  EXPECT_EQ(check.mended_bytes + check.unsteady_bytes, 0U);
  EXPECT_EQ(copy, record);
}

// 512 bytes in the middle: what a power cut of the PC leaves of a block that had not reached its disk.
TEST_F(LogVerify, ZerosInTheMiddleOfWhatWasThereAreFetchedAgainAndTheRecordIsIntact) {
  Bytes there(record.begin(), record.begin() + 24'000);
  std::ranges::fill(std::span{there}.subspan(12'000, 512), std::byte{0});
  std::uint32_t lost = 0;  // some were zero before
  for (std::size_t i = 0; i < there.size(); ++i) {
    lost += there[i] == record[i] ? 0U : 1U;
  }
  ASSERT_GT(lost, 0U);
  const LogCheck check = log(there);
  EXPECT_EQ(resumed, 24'000U) << "its first and last bytes are right, so the download goes on with it";
  EXPECT_TRUE(check.intact);
  EXPECT_EQ(check.mended_bytes, lost);
  EXPECT_TRUE(check.agrees());
  EXPECT_EQ(copy, record);
}

// No record is damaged by it: the first flight only seems to have ended earlier.
TEST_F(LogVerify, TheEndOfAFlightThatLooksErasedOnThePcIsFetchedAgain) {
  const std::uint32_t end = 18 + 78 * 300;
  ASSERT_LT(end + 5'000, second_begin);
  Bytes there(record.begin(), record.end() - 4'096);
  std::ranges::fill(std::span{there}.first(second_begin).subspan(end), std::byte{0xFF});
  const LogCheck check = log(there);
  EXPECT_TRUE(check.intact);
  EXPECT_EQ(copy, record);
}

TEST_F(LogVerify, WholeRecordsInAWrongPlaceAreNotBelieved) {
  Bytes there(record.begin(), record.begin() + 28'000);
  std::ranges::copy(std::span{record}.subspan(4'096, 8'192), there.begin() + 12'288);
  const LogCheck check = log(there);
  EXPECT_TRUE(check.intact);
  EXPECT_EQ(copy, record);
}

TEST_F(LogVerify, DamageAnywhereOnThePcIsMended) {
  core::RandomStream random{test::seed()};
  for (int trial = 0; trial < 40; ++trial) {
    const auto size = static_cast<std::size_t>(random.whole(5'000, static_cast<int>(record.size())));
    Bytes there(record.begin(), record.begin() + static_cast<std::ptrdiff_t>(size));
    for (int hole = random.whole(1, 4); hole > 0; --hole) {
      const int at = random.whole(0, static_cast<int>(size) - 1);
      const int length = std::min(random.whole(1, 6'000), static_cast<int>(size) - at);
      const auto value = static_cast<std::byte>(random.chance(0.5)   ? 0
                                                : random.chance(0.5) ? 0xFF
                                                                     : random.whole(0, 255));
      std::fill_n(there.begin() + at, length, value);
    }
    const LogCheck check = log(there);
    EXPECT_TRUE(check.intact) << "trial " << trial;
    ASSERT_EQ(copy, record) << "trial " << trial;
  }
}

TEST_F(LogVerify, DamageInTheFlashIsSaidSoAfterTwoFetchesThatAgree) {
  damage_flash(8'000, 512);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{20'000}}) {
    Bytes there(place.flash.cells().begin() + record_begin, place.flash.cells().begin() + record_begin + kept);
    const LogCheck check = log(there);
    EXPECT_FALSE(check.intact);
    EXPECT_TRUE(check.agrees());
    EXPECT_EQ(check.mended_bytes, 0U);
    EXPECT_TRUE(std::ranges::equal(copy, place.flash.cells().subspan(record_begin, copy.size())));
  }
}

// By switching off: of the last record of each flight so many bytes were written.
TEST_F(LogVerify, ALastRecordThatWasCutOffIsNoDamageAndWasReadAlikeTwice) {
  const auto cells = place.flash.cells().subspan(record_begin);
  const std::size_t end = link::split_flights(record)[1].end;
  std::ranges::fill(cells.subspan(second_begin - 40, 40), std::byte{0xFF});
  std::ranges::fill(cells.subspan(end - 40, 40), std::byte{0xFF});
  std::uint32_t fetched = 0;
  const LogCheck check = log({}, reader, &fetched);
  EXPECT_TRUE(check.intact);
  EXPECT_TRUE(check.agrees());
  EXPECT_EQ(fetched, record.size()) << "whole, once more: it might have been cut off on its way";
  damage_flash(8'000, 512);
  EXPECT_FALSE(log({}).intact) << "damage elsewhere";
}

// What is missing of the last record came as erased flash the first time.
TEST_F(LogVerify, ADownloadWhoseEndCameAsErasedFlashIsNoRecordThatWasCutOff) {
  const std::size_t end = link::split_flights(record)[1].end;
  const Bytes whole = record;
  std::ranges::fill(place.flash.cells().subspan(record_begin + end - 400, 400), std::byte{0xFF});
  std::uint32_t fetched = 0;
  const LogCheck check =
      log({}, reader, &fetched, [&] { std::ranges::copy(whole, place.flash.cells().begin() + record_begin); });
  EXPECT_TRUE(check.intact);
  EXPECT_GT(check.mended_bytes, 300U);
  EXPECT_EQ(copy, whole);
}

// A flash, or its wire, that gives other bytes each time: the CRC-32C of the answer is that of what was read.
TEST_F(LogVerify, AFlashThatIsReadDifferentlyEachTimeIsNotCalledDamaged) {
  damage_flash(8'000, 40);
  int reads = 0;
  place.after_tick = [&] {
    reads += 1;
    place.flash.cells()[record_begin + 8'100] = static_cast<std::byte>(reads);
  };
  const LogCheck check = log({});
  EXPECT_FALSE(check.intact);
  EXPECT_FALSE(check.agrees());
  EXPECT_GT(check.unsteady_bytes, 0U);
}

TEST_F(LogVerify, AnotherRecordOfTheSameLengthIsNotTheOneThatWasDownloaded) {
  (void)log({});
  EXPECT_TRUE(link::still_there(reader, 0, copy));
  place.flash.cells()[record_begin + 700] ^= std::byte{1};
  EXPECT_FALSE(link::still_there(reader, 0, copy));
}

}  // namespace
}  // namespace fantail::sil
