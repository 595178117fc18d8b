// SPDX-License-Identifier: MIT
#include <iostream>

#include "cut_flight.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

/// What a flash has left of the flight when the power was cut while one byte of it was programmed.
enum class Tear : std::uint8_t {
  in_order,  ///< byte by byte: the one is half programmed, and those behind it are blank
  at_once,   ///< some bits of the whole page are programmed, whichever
};

struct Outcome {
  std::size_t cuts = 0;
  std::size_t complete = 0;  ///< records that were looked for: their last byte had been programmed before the cut
  std::size_t lost = 0;      ///< of these
  std::size_t false_ones = 0;
  std::size_t saved = 0;  ///< records that came back though their program was cut
  std::size_t boots = 0;  ///< that found their place behind the flight, and blank
};

class Cutter {
 public:
  explicit Cutter(CutFlight& flight) : flight_{flight} { std::ranges::fill(region(), std::byte{0xFF}); }

  /// Bytes in rising order.
  void cut(std::size_t byte, Tear tear, std::uint64_t seed) {
    const std::size_t index = flight_.program_of(byte);
    for (; programmed_ < index; ++programmed_) {
      put(flight_.programs()[programmed_]);
    }
    const NotingFlash::Program& program = flight_.programs()[index];
    const std::size_t begin = flight_.begin_of(program);
    const auto cells = region().subspan(begin, program.bytes.size());
    if (tear == Tear::at_once) {
      hal::sim::tear_program(cells, program.bytes, seed);
    } else {
      const std::size_t at = byte - begin;
      std::ranges::copy(std::span{program.bytes}.first(at), cells.begin());
      hal::sim::RandomBits random{seed};
      cells[at] &= program.bytes[at] | random.byte(random.next() % 257);
    }
    look(begin);
    boot();
    if (outcome.cuts % 64 == 0) {
      fly_again(begin);
    }
    outcome.cuts += 1;
    std::ranges::fill(cells, std::byte{0xFF});
  }

  Outcome outcome;

 private:
  [[nodiscard]] std::span<std::byte> region() { return region_of(flight_.flash()); }

  void put(const NotingFlash::Program& program) {
    std::ranges::copy(program.bytes, region().begin() + static_cast<std::ptrdiff_t>(flight_.begin_of(program)));
  }

  // A short flight is read as a whole. Of a long one, what lies some way before the cut is as it was at the cut
  // before; every 64th time all of it is read (fly_again).
  void look(std::size_t program_begin) {
    const std::size_t from = flight_.log().size() < 65'536 ? 0 : flight_.reader_begin(program_begin);
    const std::size_t to = std::min(program_begin + 2 * protocol::largest_log_payload, region().size());  // then blank
    const auto bytes = region().subspan(from, to - from);
    const std::vector<Record> read = records_in(bytes);
    std::size_t came_back = 0;
    for (const Record& record : read) {
      outcome.false_ones += flight_.was_written(record, bytes, from) ? 0 : 1;
      (record.end + from <= program_begin ? came_back : outcome.saved) += 1;
    }
    const std::size_t whole = flight_.ended_by(program_begin) - flight_.ended_by(from);
    outcome.complete += whole;
    outcome.lost += whole - came_back;
  }

  // The place of the next flight: a fresh sector behind everything, blank to its end.
  void boot() {
    FlashAccess access{flight_.flash()};
    FlightRegion found{access};
    while (!found.finished()) {
      found.update({});
    }
    const auto next_sector = found.open();
    ASSERT_TRUE(next_sector.has_value());
    const auto rest = region().subspan(std::size_t{*next_sector} * 4096);
    const bool blank = std::ranges::all_of(rest.first(4096), [](std::byte b) { return b == std::byte{0xFF}; });
    outcome.boots += blank ? 1 : 0;
  }

  // Another flight on a flash that looks so, and every record of both.
  void fly_again(std::size_t program_begin) {
    hal::sim::Flash copy{one_mib};
    std::ranges::copy(flight_.flash().cells(), copy.cells().begin());
    RecorderRig rig{copy, 99};
    rig.run(core::Phase::armed, 30);
    rig.run(core::Phase::launched, 40);
    rig.tick(core::Phase::armed);
    rig.settle(core::Phase::armed);
    const std::size_t second = rig.noting.programs.front().address - flash_map(one_mib)->flight_begin;
    EXPECT_GE(second, program_begin);  // the same where the cut left nothing to be seen of a sector's first page
    EXPECT_EQ(second % 4096, 0U);
    const auto bytes = region_of(copy);
    std::size_t first_flight = 0;
    std::size_t second_flight = 0;
    for (const Record& record : records_in(bytes)) {
      if (record.begin >= second) {
        EXPECT_EQ(record.sequence, second_flight);
        second_flight += 1;
      } else {
        EXPECT_TRUE(flight_.was_written(record, bytes, 0));
        first_flight += record.end <= program_begin ? 1 : 0;
      }
    }
    EXPECT_EQ(first_flight, flight_.ended_by(program_begin));
    EXPECT_EQ(events_in(bytes.subspan(second)).back().kind, protocol::LogEventKind::recording_ended);
  }

  CutFlight& flight_;
  std::size_t programmed_ = 0;  ///< programs that are whole in the flash
};

void expect_nothing_lost(const Outcome& outcome, std::string_view name) {
  EXPECT_EQ(outcome.lost, 0U);
  EXPECT_EQ(outcome.false_ones, 0U);
  EXPECT_EQ(outcome.boots, outcome.cuts);
  std::cout << name << ": " << outcome.cuts << " power cuts; of " << outcome.complete
            << " records before the cut that were looked for, " << outcome.lost << " lost, " << outcome.false_ones
            << " false; of torn pages " << outcome.saved << " saved; the next boot went on behind " << outcome.boots
            << " of them\n";
}

TEST(PowerCut, AtEveryByteOfAFlightOfAHundredRecordsLosesNoneThatWasComplete) {
  CutFlight flight{20, 68};
  ASSERT_EQ(flight.records().size(), 100U);
  Cutter cutter{flight};
  for (std::size_t byte = 0; byte < flight.log().size(); ++byte) {
    cutter.cut(byte, Tear::in_order, byte + 2);
    cutter.cut(byte, Tear::at_once, byte);
  }
  EXPECT_EQ(cutter.outcome.cuts, 2 * flight.log().size());
  expect_nothing_lost(cutter.outcome, "flight of 100 records");
}

TEST(PowerCut, AtSeededPlacesOfAWholeFlightLosesNoRecordThatWasComplete) {
  CutFlight flight{500, 10'500};
  ASSERT_GT(flight.records().size(), 11'000U);
  std::vector<std::size_t> places;
  if (everything_is_tried()) {
    for (std::size_t byte = 0; byte < flight.log().size(); ++byte) {
      places.push_back(byte);
    }
  } else {
    core::RandomStream random{test::seed(20'261'121)};
    for (int i = 0; i < 2000; ++i) {
      places.push_back(static_cast<std::size_t>(random.whole(0, static_cast<int>(flight.log().size()) - 1)));
    }
    std::ranges::sort(places);
  }
  Cutter cutter{flight};
  for (const std::size_t byte : places) {
    cutter.cut(byte, byte % 2 == 0 ? Tear::in_order : Tear::at_once, byte + 2);
  }
  expect_nothing_lost(cutter.outcome, "flight of 11 s");
}

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
