// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

// A flight log (.ftl) is a stream of frames, little-endian, as they lie in the flash one behind the other; between them
// may be erased flash (0xFF) and whatever a power cut left.
//   0  u8   0xA5
//   1  u8   type of the record
//   2  u16  length of the payload
//   4  u32  sequence: 0 for the first record of a flight, then one more with each
//   8  u48  time in microseconds since power-up
//  14  payload
//   n  u32  CRC-32C of everything before it

inline constexpr std::byte log_sync{0xA5};
inline constexpr std::size_t log_head_size = 14;
inline constexpr std::size_t log_frame_overhead = log_head_size + 4;
/// A longer one is not a frame.
inline constexpr std::size_t largest_log_payload = 4096;

/// Every record that this version writes. A reader passes over the types it does not know.
enum class LogRecord : std::uint8_t {
  header = 1,
  checkpoint = 2,
  tick = 3,
  event = 4,
  health = 5,
};

struct LogFrameHead {
  std::uint8_t type = 0;
  std::uint16_t length = 0;
  std::uint32_t sequence = 0;
  core::Microseconds time{};  ///< 0 to 2^48 - 1
};

/// Into the first log_head_size bytes.
inline void encode(const LogFrameHead& head, std::span<std::byte> out) {
  out[0] = log_sync;
  out[1] = static_cast<std::byte>(head.type);
  put<2>(out, 2, head.length);
  put<4>(out, 4, head.sequence);
  put<6>(out, 8, static_cast<std::uint64_t>(head.time.count()));
}
[[nodiscard]] std::array<std::byte, log_head_size> encode(const LogFrameHead& head);

struct LogFrame {
  LogFrameHead head;
  std::span<const std::byte> payload;
  std::size_t position = 0;  ///< of its first byte
};

/// Finds the intact frames in any bytes whatever: what is not one is passed over and counted.
class LogFrameReader {
 public:
  /// The bytes outlive this object.
  explicit LogFrameReader(std::span<const std::byte> bytes) : bytes_{bytes} {}

  /// The next intact frame; empty at the end.
  std::optional<LogFrame> next();

  /// Bytes so far that belong to no intact frame and are not erased flash.
  [[nodiscard]] std::size_t foreign_bytes() const { return foreign_bytes_; }
  /// How far the bytes have been read.
  [[nodiscard]] std::size_t position() const { return position_; }

 private:
  [[nodiscard]] std::optional<LogFrame> frame_here() const;
  void pass_over_byte();

  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
  std::size_t foreign_bytes_ = 0;
};

}  // namespace fantail::protocol
