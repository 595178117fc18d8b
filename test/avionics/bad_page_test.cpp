// SPDX-License-Identifier: MIT
// A flash that does not keep what it is given, and does not say so.
#include <gtest/gtest.h>

#include "recorder_rig.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;

constexpr std::uint32_t sector = 4096;

struct BadPage : testing::Test {
  hal::sim::WorldSide world;
  hal::sim::Flash flash{world, one_mib, {}};
  RecorderRig rig{flash, 5, &world};
  const std::uint32_t begin = flash_map(one_mib)->flight_begin;

  void fly() {
    rig.run(Phase::armed, 1000);
    rig.run(Phase::launched, 2000);
    rig.tick(Phase::armed);
    rig.settle(Phase::armed);
  }
  /// What a reader finds: every record's number, each once and rising.
  std::vector<std::uint32_t> found() {
    Bytes read(region_of(flash).size());
    for (std::size_t at = 0; at < read.size(); at += 256) {
      EXPECT_EQ(flash.read(begin + static_cast<std::uint32_t>(at), std::span{read}.subspan(at, 256)),
                hal::FlashResult::ok);
    }
    std::vector<std::uint32_t> numbers;
    for (const Record& record : records_in(read)) {
      EXPECT_TRUE(numbers.empty() || record.sequence > numbers.back()) << "a record twice would be another flight";
      numbers.push_back(record.sequence);
    }
    return numbers;
  }
  [[nodiscard]] std::uint32_t bad_pages() const { return rig.service.flights().bad_pages(); }
};

TEST_F(BadPage, EveryPageIsReadBackAndASoundFlashHasNone) {
  fly();
  const auto numbers = found();
  EXPECT_EQ(numbers.back() + 1, numbers.size());
  EXPECT_EQ(bad_pages(), 0U);
  EXPECT_FALSE(rig.service.facts().has_bad_pages);
}

TEST_F(BadPage, OneBitThatDoesNotProgramCostsTheRecordAcrossItsBeginningAndNoOther) {
  for (int bit = 0; bit < 8; ++bit) {
    flash.stick(begin + 20 * sector / 2 + 100, std::byte{1} << bit, std::byte{1} << bit);
  }
  fly();
  const auto numbers = found();
  EXPECT_EQ(numbers.back() + 1 - numbers.size(), 1U) << "lost";
  EXPECT_EQ(bad_pages(), 1U);
  EXPECT_TRUE(rig.service.facts().has_bad_pages);
  EXPECT_FALSE(rig.service.facts().failed);
}

TEST_F(BadPage, OfAWornOutSectorNothingIsLostButTheRecordBeforeIt) {
  flash.wear_out(begin + 10 * sector);
  fly();
  const auto numbers = found();
  EXPECT_LE(numbers.back() + 1 - numbers.size(), 1U);
  EXPECT_EQ(bad_pages(), 1U);
  EXPECT_GT(rig.service.flights().used_bytes(), 11 * sector);
}

TEST_F(BadPage, ThreeBadSectorsInARowArePassedOverAndNineAreAFailedFlash) {
  for (std::uint32_t i = 10; i < 13; ++i) {
    flash.wear_out(begin + i * sector);
  }
  fly();
  const auto numbers = found();
  EXPECT_LE(numbers.back() + 1 - numbers.size(), 1U);
  EXPECT_FALSE(rig.service.facts().failed);

  hal::sim::Flash worn{world, one_mib, {}};
  for (std::uint32_t i = 4; i < 13; ++i) {
    worn.wear_out(begin + i * sector);
  }
  RecorderRig other{worn, 6, &world};
  other.run(Phase::armed, 1000);
  other.run(Phase::launched, 2000);
  EXPECT_TRUE(other.service.facts().failed);
  EXPECT_FALSE(other.service.recorder().busy());
}

}  // namespace
}  // namespace fantail::avionics
