// SPDX-License-Identifier: MIT
#include "protocol/log_frame.hpp"

#include "log_bytes.hpp"
#include "properties.hpp"
#include "protocol/crc32c.hpp"
#include "protocol/log_losses.hpp"
#include "protocol/log_notes.hpp"

namespace fantail::protocol {
namespace {

std::vector<std::uint32_t> sequences(LogFrameReader& reader) {
  std::vector<std::uint32_t> found;
  while (const auto frame = reader.next()) {
    found.push_back(frame->head.sequence);
  }
  return found;
}

TEST(LogFrame, LiesThereAsItsDocumentationSays) {
  const std::vector<std::byte> payload{std::byte{0x11}, std::byte{0x22}};
  const std::vector<std::byte> bytes =
      frame({.type = 3, .length = 2, .sequence = 0x01020304, .time = core::Microseconds{0x0A0B0C0D0E0F}}, payload);
  constexpr std::array<std::uint8_t, 16> expected{0xA5, 3,    2,    0,    4,    3,    2,    1,
                                                  0x0F, 0x0E, 0x0D, 0x0C, 0x0B, 0x0A, 0x11, 0x22};
  ASSERT_EQ(bytes.size(), expected.size() + 4);
  EXPECT_TRUE(std::ranges::equal(std::span{bytes}.first(expected.size()), expected, {},
                                 [](std::byte b) { return std::to_integer<std::uint8_t>(b); }));
}

// What lies in flash, in logs and in their readers: docs/flight_log.md.
TEST(LogFrame, ARecordsTypeAndTheLongestPayloadAreThoseOfTheFormat) {
  EXPECT_EQ(static_cast<int>(LogRecord::header), 1);
  EXPECT_EQ(static_cast<int>(LogRecord::checkpoint), 2);
  EXPECT_EQ(static_cast<int>(LogRecord::tick), 3);
  EXPECT_EQ(static_cast<int>(LogRecord::event), 4);
  EXPECT_EQ(static_cast<int>(LogRecord::health), 5);
  EXPECT_EQ(largest_log_payload, 4096U);
}

TEST(LogFrame, AHeadOfWhichNothingIsSaidIsZerosAndLeavesWhatIsBehindItAlone) {
  std::array<std::byte, 20> bytes{};
  bytes.fill(std::byte{0x5A});
  encode(LogFrameHead{}, bytes);
  EXPECT_EQ(bytes[0], std::byte{0xA5});
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    EXPECT_EQ(bytes.at(i), i < 14 ? std::byte{} : std::byte{0x5A}) << i;
  }
}

TEST(LogFrame, OneOfWhichNothingIsSaidIsEmptyAndLiesAtTheBeginning) {
  const LogFrame nothing{};
  EXPECT_EQ(nothing.position, 0U);
  EXPECT_TRUE(nothing.payload.empty());
}

TEST(LogFrame, TheReaderSaysHowFarItIsAndWhereItHasFoundAFrame) {
  std::vector<std::byte> bytes = frame(1, std::vector<std::byte>(5));
  append(bytes, std::vector<std::byte>(3, std::byte{0xFF}));
  append(bytes, frame(2, {}));
  LogFrameReader reader{bytes};
  EXPECT_EQ(reader.position(), 0U);
  EXPECT_EQ(reader.foreign_bytes(), 0U);
  EXPECT_EQ(reader.next()->position, 0U);
  EXPECT_EQ(reader.position(), 23U);
  EXPECT_EQ(reader.next()->position, 26U);
  EXPECT_EQ(reader.position(), 44U);
}

TEST(LogFrame, ComesBackWithEverythingInIt) {
  const std::vector<std::byte> payload(300, std::byte{0x5A});
  const LogFrameHead head{
      .type = 9, .length = 300, .sequence = 0x8A0B0C0D, .time = core::Microseconds{(1LL << 48) - 1}};
  const std::vector<std::byte> bytes = frame(head, payload);
  LogFrameReader reader{bytes};
  const auto found = reader.next();
  ASSERT_TRUE(found);
  EXPECT_EQ(found->head.type, 9);
  EXPECT_EQ(found->head.sequence, 0x8A0B0C0DU);
  EXPECT_EQ(found->head.time, head.time);
  EXPECT_TRUE(std::ranges::equal(found->payload, payload));
  EXPECT_EQ(found->position, 0U);
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.foreign_bytes(), 0U);
}

TEST(LogFrame, ErasedFlashBetweenFramesIsNothing) {
  std::vector<std::byte> bytes = frame(1, {});
  bytes.insert(bytes.end(), 200, std::byte{0xFF});
  append(bytes, frame(2, {}));
  LogFrameReader reader{bytes};
  EXPECT_EQ(sequences(reader), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(reader.foreign_bytes(), 0U);
}

TEST(LogFrame, WhatComesBetweenFramesIsPassedOverAndCounted) {
  std::vector<std::byte> bytes(10, std::byte{0x00});
  append(bytes, frame(1, {}));
  bytes.insert(bytes.end(), 7, log_sync);
  append(bytes, frame(2, {}));
  LogFrameReader reader{bytes};
  EXPECT_EQ(sequences(reader), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(reader.foreign_bytes(), 17U);
}

TEST(LogFrame, EverySingleBitThatIsFlippedCostsOneFrameAndNoMore) {
  std::vector<std::byte> bytes;
  for (std::uint32_t sequence = 0; sequence < 3; ++sequence) {
    append(bytes, frame(sequence, std::vector<std::byte>(50, std::byte{0x3C})));
  }
  const std::size_t size = bytes.size() / 3;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
    std::vector<std::uint32_t> expected{0, 1, 2};
    std::erase(expected, static_cast<std::uint32_t>(bit / 8 / size));
    LogFrameReader reader{bytes};
    EXPECT_EQ(sequences(reader), expected) << "bit " << bit;
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
  }
}

// An intact checksum alone is none: a reader that began anywhere would take what is left of a frame for another.
TEST(LogFrame, WhatDoesNotBeginWithTheSyncByteIsNoFrameWhateverItsChecksum) {
  std::vector<std::byte> bytes = frame(1, std::vector<std::byte>(5));
  bytes[0] = std::byte{0xA4};
  put<4>(bytes, bytes.size() - 4, crc32c(std::span{bytes}.first(bytes.size() - 4)));
  LogFrameReader reader{bytes};
  EXPECT_FALSE(reader.next());
  EXPECT_EQ(reader.foreign_bytes(), bytes.size());
}

TEST(LogFrame, ACutLeavesTheFramesBeforeIt) {
  std::vector<std::byte> bytes;
  for (std::uint32_t sequence = 0; sequence < 3; ++sequence) {
    append(bytes, frame(sequence, std::vector<std::byte>(50)));
  }
  const std::size_t size = bytes.size() / 3;
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
    LogFrameReader reader{std::span{bytes}.first(cut)};
    EXPECT_EQ(sequences(reader).size(), cut / size);
  }
}

TEST(LogFrame, AFrameThatClaimsMoreThanAnyHasIsNone) {
  const std::vector<std::byte> largest = frame(1, std::vector<std::byte>(largest_log_payload));
  const std::vector<std::byte> larger = frame(1, std::vector<std::byte>(largest_log_payload + 1));
  LogFrameReader accepts{largest};
  EXPECT_TRUE(accepts.next());
  LogFrameReader refuses{larger};
  EXPECT_FALSE(refuses.next());
}

// Bytes that mean nothing must not become a record: one in 2^32 candidates would, and these are far fewer.
RC_GTEST_PROP(LogFrame, NoneIsFoundInNoise, (std::vector<std::uint8_t> noise)) {
  std::vector<std::byte> bytes(noise.size());
  std::ranges::transform(noise, bytes.begin(), [](std::uint8_t b) { return b % 3 == 0 ? log_sync : std::byte{b}; });
  LogFrameReader reader{bytes};
  RC_ASSERT(!reader.next());
  RC_ASSERT(reader.position() == bytes.size());
}

using Bytes = std::vector<std::byte>;

LogFrame read(const Bytes& bytes) { return LogFrameReader{bytes}.next().value(); }

Bytes event(std::uint32_t sequence, const LogEvent& what) {
  const auto payload = pack(what);
  return frame({.type = static_cast<std::uint8_t>(LogRecord::event), .length = payload.size(), .sequence = sequence},
               payload);
}

class CutOff : public testing::Test {
 protected:
  [[nodiscard]] bool is(std::span<const std::byte> rest) const { return is_cut_off(read(last), rest); }

  const Bytes last = frame(6, Bytes(50));
  const Bytes next = frame(7, Bytes(600, std::byte{0x3C}));
};

TEST_F(CutOff, IsWhateverIsThereOfTheNextRecordAndErasedFlashBehindIt) {
  for (std::size_t size = 0; size < next.size(); ++size) {
    Bytes rest{next.begin(), next.begin() + static_cast<std::ptrdiff_t>(size)};
    EXPECT_TRUE(is(rest)) << size;
    rest.resize(9'000, std::byte{0xFF});
    EXPECT_TRUE(is(rest)) << size;
  }
  EXPECT_TRUE(is_cut_off({}, std::span{next}.first(20))) << "nothing is before it, and it is short";
}

// The record began on the page before, whole; of the page behind it any bit may stand.
TEST_F(CutOff, IsThePageThatWasBeingWrittenWhateverItHolds) {
  EXPECT_TRUE(is(Bytes(256, std::byte{0x42})));
  EXPECT_FALSE(is(Bytes(257, std::byte{0x42})));
  Bytes rest = next;
  rest.back() ^= std::byte{1};
  rest.resize(next.size() + 256, std::byte{0x42});
  EXPECT_TRUE(is(rest));
  rest.push_back(std::byte{0});
  EXPECT_FALSE(is(rest));
}

TEST_F(CutOff, IsNotALongRestThatBeginsWithNoNextRecord) {
  for (const Bytes& other : {frame(8, Bytes(600)), frame({.length = 4'097, .sequence = 7}, Bytes(4'097))}) {
    EXPECT_FALSE(is(std::span{other}.first(500)));
  }
  Bytes unsynchronized = next;
  unsynchronized[0] = std::byte{};
  EXPECT_FALSE(is(std::span{unsynchronized}.first(500)));
}

TEST_F(CutOff, IsNothingBehindTheEndOfARecording) {
  const Bytes rest(17, std::byte{0x42});
  const Bytes end = event(6, {.kind = LogEventKind::recording_ended});
  EXPECT_FALSE(is_cut_off(read(end), rest));
  EXPECT_TRUE(is_cut_off(read(event(6, {.kind = LogEventKind::phase})), rest));
}

TEST(DroppedBefore, IsWhatTheRecorderSaysAndNeverMoreThanIsMissing) {
  const Bytes dropped = event(9, {.kind = LogEventKind::records_dropped, .number = 3});
  EXPECT_EQ(dropped_before(read(dropped), 5), 3U);
  EXPECT_EQ(dropped_before(read(dropped), 2), 2U);
  EXPECT_EQ(dropped_before(read(event(9, {.kind = LogEventKind::phase, .number = 3})), 5), 0U);
  EXPECT_EQ(dropped_before(read(frame(9, Bytes(8))), 5), 0U) << "no event";
}

}  // namespace

}  // namespace fantail::protocol
