// SPDX-License-Identifier: MIT
#include "protocol/log_frame_writer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "log_bytes.hpp"

namespace fantail::protocol {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::byte not_written{0x5A};
constexpr LogFrameHead some_head{.type = 2, .sequence = 0x01020304, .time = core::Microseconds{0x0A0B0C0D0E0F}};

/// Other bytes in every part, and none that stands for not_written room.
Bytes some_bytes(std::size_t size, unsigned first) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>((first + i) % 0x50);
  }
  return bytes;
}

struct Payload {
  Bytes a{};
  Bytes b{};
  Bytes c{};
  [[nodiscard]] LogFrameWriter::Parts parts() const { return {a, b, c}; }
  [[nodiscard]] Bytes whole() const {
    Bytes all = a;
    append(all, b);
    append(all, c);
    return all;
  }
};

Bytes frame_of(const Payload& payload) {
  LogFrameHead whole = some_head;
  whole.length = static_cast<std::uint16_t>(payload.whole().size());
  return frame(whole, payload.whole());
}

/// Pages of one size, of which the first has only `first` bytes left, as a recorder fills them; behind each lies what
/// is not its own.
Bytes written_into_pages(LogFrameWriter& writer, const Payload& payload, std::size_t first, std::size_t page) {
  Bytes all;
  std::size_t room = first;
  for (bool begun = false; !begun || !writer.done(); begun = true) {
    Bytes out(room + 8, not_written);
    const auto space = std::span{out}.first(room);
    const std::size_t size = begun ? writer.write(space) : writer.begin(some_head, payload.parts(), space);
    EXPECT_TRUE(size == room || writer.done()) << "a page is filled as long as there is something left";
    EXPECT_TRUE(std::ranges::all_of(std::span{out}.subspan(size), [](std::byte b) { return b == not_written; }));
    append(all, std::span{out}.first(size));
    room = page;
  }
  return all;
}

// Three bytes of checksum on one page and the fourth on the next, a part that ends where a page does, a part that is
// empty: whatever falls together.
TEST(LogFrameWriter, AFrameInPiecesOfAnySizeIsTheFrameInOnePiece) {
  LogFrameWriter writer;
  for (const Payload& payload :
       {Payload{}, Payload{.a = some_bytes(1, 1)}, Payload{.b = some_bytes(7, 3), .c = some_bytes(2, 60)},
        Payload{.a = some_bytes(5, 9), .c = some_bytes(11, 20)},
        Payload{some_bytes(4, 1), some_bytes(3, 11), some_bytes(9, 40)}}) {
    const Bytes whole = frame_of(payload);
    EXPECT_EQ(LogFrameWriter::frame_size(payload.parts()), whole.size());
    for (std::size_t first = 0; first < whole.size() + 2; ++first) {
      for (const std::size_t page : {1U, 2U, 3U, 7U, 64U}) {
        ASSERT_EQ(written_into_pages(writer, payload, first, page), whole) << first << " and then " << page;
      }
    }
  }
}

TEST(LogFrameWriter, WhatWasNotBegunOrIsOverWritesNothing) {
  Bytes out(40, not_written);
  LogFrameWriter writer;
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(out), 0U);
  writer.begin(some_head, Payload{.a = some_bytes(3, 1)}.parts(), std::span{out}.first(21));
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(std::span{out}.subspan(21)), 0U);
  EXPECT_EQ(out[21], not_written);
}

// As when the flash fails in the middle of a frame.
TEST(LogFrameWriter, AFrameThatIsAbandonedLeavesNothingInTheNextOne) {
  LogFrameWriter writer;
  const Payload first{.a = some_bytes(30, 1)};
  const Payload second{.a = some_bytes(2, 7), .b = some_bytes(3, 30)};
  Bytes out(20, not_written);
  EXPECT_EQ(writer.begin(some_head, first.parts(), out), 20U);
  EXPECT_FALSE(writer.done());
  writer.abandon();
  EXPECT_TRUE(writer.done());
  EXPECT_EQ(writer.write(out), 0U);
  EXPECT_EQ(written_into_pages(writer, second, 5, 64), frame_of(second));
}

}  // namespace
}  // namespace fantail::protocol
