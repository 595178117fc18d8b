// SPDX-License-Identifier: MIT
#include "protocol/bus_load.hpp"

#include "bus_rig.hpp"
#include "properties.hpp"
#include "protocol/bus_catalogue.hpp"
#include "random_stream.hpp"

namespace fantail::protocol {
namespace {

using core::Microseconds;

std::string binary(unsigned value, int bits) {
  std::string text;
  for (int i = bits - 1; i >= 0; --i) {
    text += ((value >> static_cast<unsigned>(i)) & 1U) != 0U ? '1' : '0';
  }
  return text;
}

// Long division of the text by the polynomial x15+x14+x10+x8+x7+x4+x3+1.
std::string crc15_of(std::string text) {
  const std::string polynomial = "1100010110011001";
  const std::size_t length = text.size();
  text += std::string(15, '0');
  for (std::size_t i = 0; i < length; ++i) {
    if (text[i] == '1') {
      for (std::size_t k = 0; k < polynomial.size(); ++k) {
        text[i + k] = text[i + k] == polynomial[k] ? '0' : '1';
      }
    }
  }
  return text.substr(length);
}

std::string frame_text(const BusFrame& frame) {
  std::string text{"0"};
  text += binary(frame.id, 11) + "000" + binary(frame.length, 4);
  for (std::size_t i = 0; i < frame.length; ++i) {
    text += binary(frame.data[i], 8);
  }
  return text + crc15_of(text);
}

/// Writes a stuff bit wherever the last five characters are the same, and counts what is there in the end.
std::uint32_t naive_bits(const BusFrame& frame) {
  std::string wire;
  for (const char bit : frame_text(frame)) {
    wire += bit;
    if (wire.size() >= 5 && wire.substr(wire.size() - 5) == std::string(5, bit)) {
      wire += bit == '0' ? '1' : '0';
    }
  }
  wire += "1";        // CRC delimiter
  wire += "01";       // acknowledged
  wire += "1111111";  // end of frame
  wire += "111";      // space
  return static_cast<std::uint32_t>(wire.size());
}

TEST(BusLoad, TheNaiveCrc15GivesTheCheckValueOfItsCatalogueEntry) {
  std::string text;
  for (const char c : std::string{"123456789"}) {
    text += binary(static_cast<unsigned char>(c), 8);
  }
  EXPECT_EQ(crc15_of(text), binary(0x059E, 15));
}

// A frame of zeros: id 0 and nothing in it are 19 zeros, with a CRC of zeros 34: a stuff bit after the first five, and
// then, because the stuff bit ends the run, after every five more: 6 of them.
TEST(BusLoad, AFrameOfZerosHasAStuffBitAfterEveryFive) { EXPECT_EQ(bits_on_wire(BusFrame{}), 34U + 6U + 13U); }

TEST(BusLoad, FramesOfEveryLengthHaveTheBitsOfTheirText) {
  core::RandomStream random{7};
  for (unsigned i = 0; i < 60; ++i) {
    BusFrame frame{.id = static_cast<std::uint16_t>(random.whole(0, 2047)), .length = static_cast<std::uint8_t>(i % 9)};
    for (std::size_t k = 0; k < frame.length; ++k) {
      frame.data.at(k) = static_cast<std::uint8_t>(random.chance(0.5) ? random.whole(0, 255) : i % 2 == 0 ? 0 : 0xFF);
    }
    EXPECT_EQ(bits_on_wire(frame), naive_bits(frame)) << i;
  }
}

RC_GTEST_PROP(BusLoad, ExactBitsEqualTheTextOfTheWireAndNeverExceedTheWorst, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  for (int i = 0; i < 100; ++i) {
    BusFrame frame{.id = static_cast<std::uint16_t>(random.whole(0, 2047)),
                   .length = static_cast<std::uint8_t>(random.whole(0, 8))};
    const int kind = random.whole(0, 2);  // long runs, noise, nibbles that alternate just too late
    for (std::size_t k = 0; k < frame.length; ++k) {
      const int noise = random.whole(0, 255);
      const int runs = random.chance(0.5) ? 0x00 : 0xFF;
      frame.data[k] = static_cast<std::uint8_t>(kind == 0 ? runs : kind == 1 ? noise : 0x78 ^ (noise & 0x88));
    }
    RC_ASSERT(bits_on_wire(frame) == naive_bits(frame));
    RC_ASSERT(bits_on_wire(frame) <= worst_bits_on_wire(frame.length));
    RC_ASSERT(bits_on_wire(frame) >= 47U + 8U * frame.length);
  }
}

// 34 + 8n bits can be stuffed; Davis et al. 2007: 55 + 10 n altogether.
TEST(BusLoad, TheWorstFrameIsThatOfTheTextbook) {
  for (std::uint8_t length = 0; length <= 8; ++length) {
    EXPECT_EQ(worst_bits_on_wire(length), 55U + 10U * length);
  }
  EXPECT_EQ(worst_bits_on_wire(8), 135U);
}

std::vector<PeriodicFrame> everything_at_its_fastest() {
  std::vector<PeriodicFrame> frames;
  for (const BusFrameKind& kind : bus_catalogue()) {
    frames.push_back({.id = kind.id, .bits = worst_bits_on_wire(kind.length), .period = kind.fastest_period});
  }
  return frames;
}

// Frames in one second, added up by hand: 200 + 50 + 10 + 10 + 100 + 50 from the bench, 2 * 1000 + 2 * 100 + 2 * 10 +
// 100 + 50 + 10 + 1 + 1 + 10 + 50 + 50 + 10 from the avionics. LogData has no rate of its own.
TEST(BusLoad, EverythingAtItsFastestTakesLessThanFourTenthsOfTheBus) {
  constexpr double frames_a_second = 420 + 2502;
  const float load = bus_load(everything_at_its_fastest());
  EXPECT_NEAR(load, frames_a_second * 135e-6, 1e-6);
  EXPECT_LT(load, 0.40F);
}

TEST(BusLoad, ARequestWaitsForOneFrameAtMost) {
  const auto frames = everything_at_its_fastest();
  EXPECT_EQ(worst_latency(frames, 0x010), Microseconds{270});
}

// The numbers of the example in Davis et al. 2007, section 3.1, at 125 kbit/s (1 ms a frame): there the first frame of
// C takes 3 ms and the second 3.5.
TEST(BusLoad, TheSecondFrameOfABusyPeriodCanBeTheLatest) {
  const std::array<PeriodicFrame, 3> frames{{{.id = 1, .bits = 1000, .period = Microseconds{2500}},
                                             {.id = 2, .bits = 1000, .period = Microseconds{3500}},
                                             {.id = 3, .bits = 1000, .period = Microseconds{3500}}}};
  EXPECT_EQ(worst_latency(frames, 1), Microseconds{2000});
  EXPECT_EQ(worst_latency(frames, 2), Microseconds{3000});
  EXPECT_EQ(worst_latency(frames, 3), Microseconds{3500});
}

TEST(BusLoad, AFrameWithoutAPeriodTakesNoShareAndDelaysAnyOtherByItsOwnLengthAtMost) {
  const std::array<PeriodicFrame, 3> with{{{.id = 1, .bits = 100, .period = Microseconds{1000}},
                                           {.id = 2, .bits = 100, .period = Microseconds{2000}},
                                           {.id = 3, .bits = 130, .period = std::nullopt}}};
  const std::span without = std::span{with}.first(2);
  EXPECT_FLOAT_EQ(bus_load(with), 0.15F);
  EXPECT_EQ(worst_latency(without, 1), Microseconds{200});  // frame 2 is on the wire already
  EXPECT_EQ(worst_latency(with, 1), Microseconds{230});     // now it may be frame 3
  EXPECT_EQ(worst_latency(without, 2), Microseconds{200});
  EXPECT_EQ(worst_latency(with, 2), Microseconds{330});
  EXPECT_FALSE(worst_latency(with, 3));
}

TEST(BusLoad, OnlyTheDataOfTheFlightRecordHaveNoPeriodAndTheyAreTheLeastUrgent) {
  for (const BusFrameKind& kind : bus_catalogue()) {
    EXPECT_EQ(kind.fastest_period.has_value(), kind.id != 0x180);
    EXPECT_LE(kind.id, 0x180);
  }
}

TEST(BusLoad, ThereIsNoBoundOnAFullBusAndNoneForAFrameThatIsNotThere) {
  const std::array<PeriodicFrame, 2> frames{
      {{.id = 1, .bits = 135, .period = Microseconds{135}}, {.id = 2, .bits = 135, .period = Microseconds{1000}}}};
  EXPECT_FALSE(worst_latency(frames, 2));
  EXPECT_FALSE(worst_latency(frames, 3));
  EXPECT_GT(bus_load(frames), 1.0F);
}

// One frame alone, so long that nothing but a time was meant.
TEST(BusLoad, ABoundIsBelowAMinuteOrNone) {
  const auto alone = [](std::uint32_t bits) {
    return worst_latency(std::array{PeriodicFrame{.id = 1, .bits = bits, .period = std::chrono::minutes{3}}}, 1);
  };
  EXPECT_EQ(alone(59'999'999), Microseconds{59'999'999});
  EXPECT_FALSE(alone(60'000'000));
  EXPECT_FALSE(alone(60'000'001));
}

// The more urgent one comes again a bit after the bus has fallen idle and the other one has begun.
TEST(BusLoad, AFrameThatIsReadyOneBitTooLateDoesNotTakePart) {
  const std::array frames{PeriodicFrame{.id = 1, .bits = 100, .period = Microseconds{101}},
                          PeriodicFrame{.id = 2, .bits = 1, .period = Microseconds{1000}}};
  EXPECT_EQ(worst_latency(frames, 2), Microseconds{101});
}

TEST(BusLoad, AFrameOfWhichOnlyThePeriodIsKnownIsTheMostUrgentAndTakesNoTime) {
  const std::array frames{PeriodicFrame{.period = Microseconds{1000}}};
  EXPECT_EQ(bus_load(frames), 0.0F);
  EXPECT_EQ(worst_latency(frames, 0), Microseconds{0});
}

// A frame without a period: only its first one is looked at, and what it then holds up.
constexpr Microseconds endless = std::chrono::minutes{1};

/// A bus bit by bit: at each bit the frames that are due join the queue, and a free bus takes the most urgent one.
std::map<std::uint16_t, Microseconds> simulated_latency(const std::vector<PeriodicFrame>& frames,
                                                        const std::vector<Microseconds>& first, Microseconds duration) {
  std::map<std::uint16_t, Microseconds> worst;
  std::vector<std::pair<std::uint16_t, std::pair<Microseconds, std::uint32_t>>> queue;
  Microseconds free{};
  for (Microseconds now{}; now < duration; ++now) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      if (now >= first[i] && (now - first[i]) % frames[i].period.value_or(endless) == Microseconds{}) {
        queue.push_back({frames[i].id, {now, frames[i].bits}});
      }
    }
    if (now >= free && !queue.empty()) {
      const auto next = std::ranges::min_element(queue);
      const auto [queued, bits] = next->second;
      free = now + Microseconds{bits};
      worst[next->first] = std::max(worst[next->first], free - queued);
      queue.erase(next);
    }
  }
  return worst;
}

RC_GTEST_PROP(BusLoad, NoSimulatedFrameIsLaterThanItsBound, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  auto frames = everything_at_its_fastest();
  std::vector<Microseconds> first;
  for (const PeriodicFrame& frame : frames) {
    first.emplace_back(
        random.whole(0, static_cast<int>(std::min(frame.period.value_or(endless).count(), std::int64_t{3000}))));
  }
  for (const auto& [id, latency] : simulated_latency(frames, first, Microseconds{12'000})) {
    RC_ASSERT(latency <= worst_latency(frames, id).value_or(endless));
  }
}

// The worst moment: everything at once, just after a less urgent frame has begun. Of equal lengths any will do.
TEST(BusLoad, TheBoundIsReachedWhenEverythingComesAtOnce) {
  auto frames = everything_at_its_fastest();
  for (const PeriodicFrame& frame : everything_at_its_fastest()) {
    if (frame.id == frames.back().id) {
      break;  // the least urgent one is never held up by another
    }
    std::vector<Microseconds> first(frames.size(), Microseconds{1});
    first.back() = Microseconds{0};
    const auto latency = simulated_latency(frames, first, Microseconds{6000}).at(frame.id);
    EXPECT_LE(latency, *worst_latency(frames, frame.id));
    EXPECT_GE(latency, *worst_latency(frames, frame.id) - Microseconds{1});
  }
}

TEST(BusCatalogue, HasEveryFrameOnceAndFindsItByItsIdentifier) {
  for (const BusFrameKind& kind : bus_catalogue()) {
    EXPECT_EQ(find_bus_frame(kind.id), &kind);
  }
  EXPECT_EQ(find_bus_frame(0x7FF), nullptr);
}

TEST(BusCatalogue, WhatAnAvionicsListensToIsWhatTheBenchSends) {
  std::vector<std::uint16_t> from_bench;
  for (const BusFrameKind& kind : bus_catalogue()) {
    if (kind.sender == BusNode::bench) {
      from_bench.push_back(kind.id);
    }
  }
  EXPECT_TRUE(std::ranges::equal(bench_frame_ids(), from_bench));
}

TEST(BusCatalogue, WhatCanEraseComesFromTheBenchIsProtectedAndMovesNothing) {
  const BusFrameKind& kind = *find_bus_frame(0x050);
  EXPECT_EQ(kind.sender, BusNode::bench);
  EXPECT_TRUE(kind.has_counter);
  EXPECT_FALSE(kind.can_move);
}

TEST(BusCatalogue, EverythingThatCanMoveSomethingComesFromTheBenchAndIsProtected) {
  for (const BusFrameKind& kind : bus_catalogue()) {
    if (kind.can_move) {
      EXPECT_EQ(kind.sender, BusNode::bench);
      EXPECT_TRUE(kind.has_counter);
    }
  }
  EXPECT_TRUE(find_bus_frame(0x010)->can_move);
}

}  // namespace
}  // namespace fantail::protocol
