// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "protocol/bus_codec.hpp"

namespace fantail::protocol {

/// At 1 Mbit/s.
inline constexpr core::Microseconds bus_bit_time{1};

/// Bits that a data frame occupies the bus with, from its start bit through the three bits of the space between frames,
/// with the stuff bits that its own content needs. Length at most 8.
[[nodiscard]] std::uint32_t bits_on_wire(const BusFrame& frame);

/// The same for the least fortunate content; 135 for 8 bytes.
[[nodiscard]] constexpr std::uint32_t worst_bits_on_wire(std::uint8_t length) {
  const std::uint32_t stuffed =
      34U + 8U * length;  // start bit to CRC; the first stuff bit takes five bits, each further one four
  constexpr std::uint32_t never_stuffed = 13;  // CRC delimiter, acknowledge slot and delimiter, 7 of end, 3 of space
  return stuffed + (stuffed - 1U) / 4U + never_stuffed;
}

/// One kind of frame, sent at most once in each period.
struct PeriodicFrame {
  std::uint16_t id = 0;
  std::uint32_t bits = 0;
  core::Microseconds period{};  ///< above zero
};

/// Share of the bus's time that these frames take; above 1 they do not fit.
[[nodiscard]] float bus_load(std::span<const PeriodicFrame> frames);

/// From the moment frame `id` is handed to the controller until it has been received, if every node always offers its
/// most urgent waiting frame and no frame is disturbed: one less urgent frame is on the wire already, and every more
/// urgent one comes as often as it may (Davis, Burns, Bril, Lukkien: Controller Area Network schedulability analysis:
/// refuted, revisited and revised, 2007). Empty when there is no bound below a minute, or no such frame.
[[nodiscard]] std::optional<core::Microseconds> worst_latency(std::span<const PeriodicFrame> frames, std::uint16_t id);

}  // namespace fantail::protocol
