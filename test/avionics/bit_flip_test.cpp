// SPDX-License-Identifier: MIT
#include <iostream>

#include <gtest/gtest.h>

#include "cut_flight.hpp"
#include "seed.hpp"

namespace fantail::avionics {
namespace {

/// Flips one bit and says whether a reader notices: it gives every other record, and none that was not written.
class Flipper {
 public:
  explicit Flipper(const CutFlight& flight) : flight_{flight}, bytes_{flight.log().begin(), flight.log().end()} {}

  [[nodiscard]] bool noticed(std::size_t bit) {
    const std::size_t byte = bit / 8;
    const std::size_t from = flight_.reader_begin(byte);
    // As far as any length can lead, so that what lies behind cannot matter.
    const std::size_t to = std::min(bytes_.size(), byte + 2 * protocol::largest_log_payload);
    bytes_[byte] ^= std::byte{1} << (bit % 8);
    const auto window = std::span<const std::byte>{bytes_}.subspan(from, to - from);
    const std::vector<Record> read = records_in(window);
    const bool all_written =
        std::ranges::all_of(read, [&](const Record& r) { return flight_.was_written(r, window, from); });
    const auto there = static_cast<std::size_t>(
        std::ranges::count_if(read, [&](const Record& r) { return r.end + from <= byte || r.begin + from > byte; }));
    const auto all = static_cast<std::size_t>(
        std::ranges::count_if(flight_.records().begin() + static_cast<std::ptrdiff_t>(first_from(from)),
                              flight_.records().begin() + static_cast<std::ptrdiff_t>(first_from(to)),
                              [&](const Record& r) { return r.end <= to && (r.end <= byte || r.begin > byte); }));
    bytes_[byte] ^= std::byte{1} << (bit % 8);
    return all_written && there == read.size() && there == all;
  }

 private:
  [[nodiscard]] std::size_t first_from(std::size_t byte) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(flight_.records(), byte, {}, &Record::begin) -
                                    flight_.records().begin());
  }

  const CutFlight& flight_;
  Bytes bytes_;
};

TEST(BitFlip, EveryOneInAFlightOfAHundredRecordsCostsItsRecordAndNoOther) {
  const CutFlight flight{20, 68};
  Flipper flipper{flight};
  const std::size_t bits = 8 * flight.log().size();
  std::size_t noticed = 0;
  for (std::size_t bit = 0; bit < bits; ++bit) {
    noticed += flipper.noticed(bit) ? 1 : 0;
  }
  EXPECT_EQ(noticed, bits);
  std::cout << "flight of 100 records: " << bits << " bits flipped, " << noticed << " noticed\n";
}

TEST(BitFlip, SeededOnesInAWholeFlightCostTheirRecordsAndNoOthers) {
  const CutFlight flight{500, 10'500};
  Flipper flipper{flight};
  const std::size_t bits = 8 * flight.log().size();
  core::RandomStream random{test::seed(20'261'121)};
  const std::size_t flips = everything_is_tried() ? bits : 2000;
  std::size_t noticed = 0;
  for (std::size_t i = 0; i < flips; ++i) {
    const std::size_t bit =
        everything_is_tried() ? i : static_cast<std::size_t>(random.whole(0, static_cast<int>(bits) - 1));
    noticed += flipper.noticed(bit) ? 1 : 0;
  }
  EXPECT_EQ(noticed, flips);
  std::cout << "flight of 11 s: " << flips << " bits flipped, " << noticed << " noticed\n";
}

}  // namespace
}  // namespace fantail::avionics
