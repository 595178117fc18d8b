// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/log_frame.hpp"

namespace fantail::protocol {

/// Lays one frame after the other into pages: a frame may be taken out in pieces of any size.
class LogFrameWriter {
 public:
  using Parts = std::array<std::span<const std::byte>, 4>;

  LogFrameWriter() = default;
  LogFrameWriter(const LogFrameWriter&) = delete;  // it looks into itself
  LogFrameWriter& operator=(const LogFrameWriter&) = delete;

  /// Bytes of a frame with this payload.
  [[nodiscard]] static std::size_t frame_size(const Parts& payload) {
    return log_frame_overhead + payload[0].size() + payload[1].size() + payload[2].size() + payload[3].size();
  }

  /// When the frame before is done(). The payload, in up to four parts and at most largest_log_payload bytes in all,
  /// stays where it is until this one is. The head's length is filled in here. Writes as much as write().
  std::size_t begin(LogFrameHead head, const Parts& payload, std::span<std::byte> out);

  /// The next bytes of the frame, as many as there is room for; says how many.
  std::size_t write(std::span<std::byte> out);

  /// Forgets the rest of the frame.
  void abandon() { part_ = parts_.size(); }

  /// Nothing was begun, or all of it has been written.
  [[nodiscard]] bool done() const { return part_ == parts_.size(); }

 private:
  static constexpr std::size_t tail = 5;  ///< the last part

  std::array<std::byte, log_head_size> head_{};
  std::array<std::byte, 4> tail_{};
  std::array<std::span<const std::byte>, tail + 1> parts_{};  ///< what is left of head, payload and tail
  std::size_t part_ = parts_.size();
  std::uint32_t crc_ = 0;
};

}  // namespace fantail::protocol
