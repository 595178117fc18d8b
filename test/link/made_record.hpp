// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "protocol/log_bytes.hpp"
#include "protocol/log_header.hpp"

namespace fantail::test {

// Flights that nobody flew, one record a millisecond, for whoever looks at the frames alone.

using Bytes = std::vector<std::byte>;

inline Bytes header_of(std::uint32_t sequence, std::uint32_t flight, std::string_view vehicle) {
  const auto fixed = encode(protocol::LogHeader{.flight = flight, .power_up = 7, .vehicle = vehicle});
  return protocol::frame({.type = static_cast<std::uint8_t>(protocol::LogRecord::header),
                          .length = static_cast<std::uint16_t>(fixed.size()),
                          .sequence = sequence,
                          .time = core::Microseconds{1'000 * sequence}},
                         fixed);
}

inline Bytes tick_of(std::uint32_t sequence) {
  const std::array<std::byte, 60> payload{std::byte{1}, std::byte{2}};
  return protocol::frame({.type = static_cast<std::uint8_t>(protocol::LogRecord::tick),
                          .length = payload.size(),
                          .sequence = sequence,
                          .time = core::Microseconds{1'000 * sequence}},
                         payload);
}

inline Bytes flight(std::uint32_t number, std::uint32_t ticks, std::string_view vehicle = "rocket") {
  Bytes bytes = header_of(0, number, vehicle);
  for (std::uint32_t i = 1; i <= ticks; ++i) {
    protocol::append(bytes, tick_of(i));
  }
  return bytes;
}

inline void fill_sector(Bytes& bytes) { bytes.resize((bytes.size() + 4095) / 4096 * 4096, std::byte{0xFF}); }

}  // namespace fantail::test
