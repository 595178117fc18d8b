// SPDX-License-Identifier: MIT
#include "protocol/log_losses.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "log_bytes.hpp"
#include "protocol/log_notes.hpp"

namespace fantail::protocol {
namespace {

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
