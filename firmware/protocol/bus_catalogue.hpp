// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace fantail::protocol {

enum class BusNode : std::uint8_t { bench, avionics };

/// What is known of a frame before one is seen.
struct BusFrameKind {
  std::uint16_t id = 0;
  std::string_view name{};
  BusNode sender = BusNode::bench;
  std::uint8_t length = 0;
  std::optional<std::chrono::milliseconds> fastest_period{};  ///< empty: takes what all others leave
  bool has_counter = false;                                   ///< and a CRC-8
  bool can_move = false;                                      ///< a canard may move because of it
};

inline constexpr std::size_t bus_frame_count = 22;

/// Every frame of the bus, the most urgent first.
[[nodiscard]] std::span<const BusFrameKind, bus_frame_count> bus_catalogue();

inline constexpr std::size_t bench_frame_count = 6;

/// What avionics listen for.
[[nodiscard]] std::span<const std::uint16_t, bench_frame_count> bench_frame_ids();

/// Null for an identifier that the bus does not have.
[[nodiscard]] const BusFrameKind* find_bus_frame(std::uint16_t id);

}  // namespace fantail::protocol
