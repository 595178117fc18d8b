// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::protocol {

inline void append(std::vector<std::byte>& bytes, std::span<const std::byte> more) {
  std::ranges::copy(more, std::back_inserter(bytes));  // insert() makes GCC 12 warn of bounds that are kept
}

/// A whole frame, made in the simplest way.
inline std::vector<std::byte> frame(const LogFrameHead& head, std::span<const std::byte> payload) {
  const auto first = encode(head);
  std::vector<std::byte> bytes{first.begin(), first.end()};
  append(bytes, payload);
  std::array<std::byte, 4> checksum{};
  put<4>(checksum, 0, crc32c(bytes));
  append(bytes, checksum);
  return bytes;
}

inline std::vector<std::byte> frame(std::uint32_t sequence, std::span<const std::byte> payload) {
  return frame({.type = static_cast<std::uint8_t>(LogRecord::tick),
                .length = static_cast<std::uint16_t>(payload.size()),
                .sequence = sequence,
                .time = core::Microseconds{1'000}},
               payload);
}

}  // namespace fantail::protocol
