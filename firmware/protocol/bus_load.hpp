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

/// CRC delimiter, acknowledge slot and delimiter, 7 of the end of frame, 3 of space: never stuffed.
inline constexpr std::uint32_t bits_after_the_crc = 13;

/// The same for the least fortunate content; 135 for 8 bytes.
[[nodiscard]] constexpr std::uint32_t worst_bits_on_wire(std::uint8_t length) {
  const std::uint32_t up_to_the_crc = 34U + 8U * length;
  // The first stuff bit takes five equal bits; it is the first of the next five, so each further one takes four.
  return up_to_the_crc + (up_to_the_crc - 1U) / 4U + bits_after_the_crc;
}

/// One kind of frame, sent at most once in each period. One without a period takes whatever time is left by the more
/// urgent ones, which it delays by its own length at most.
struct PeriodicFrame {
  std::uint16_t id = 0;
  std::uint32_t bits = 0;
  std::optional<core::Microseconds> period{};  ///< above zero
};

/// Share of the bus's time that the frames with a period take; above 1 they do not fit.
[[nodiscard]] float bus_load(std::span<const PeriodicFrame> frames);

/// From the moment frame `id` is handed to the controller until it has been received, if every node always offers its
/// most urgent waiting frame and no frame is disturbed: one less urgent frame is on the wire already, and every more
/// urgent one comes as often as it may (Davis, Burns, Bril, Lukkien: Controller Area Network schedulability analysis:
/// refuted, revisited and revised, 2007). Empty when there is no bound below a minute, or no such frame,
/// or it or a more urgent one has no period.
[[nodiscard]] std::optional<core::Microseconds> worst_latency(std::span<const PeriodicFrame> frames, std::uint16_t id);

}  // namespace fantail::protocol
