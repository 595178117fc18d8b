// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/time.hpp"
#include "protocol/log_frame.hpp"

namespace fantail::protocol {

// Hardware in the loop: a world on one side of a wire, a flight computer on the other. Both send frames of the flight
// log's format (log_frame.hpp) with types of their own. The world leads: it sends a frame and waits for the one frame
// that answers it, which carries the same sequence. A frame that was damaged or lost is sent again; whoever gets one
// that it has answered already sends the same answer again, and does nothing else. So nothing is ever done twice.
//
//   world                         flight computer
//   hello  version, layout   ->   ready   version, layout, who it is
//   begin  plan, scales ...  ->   begun                            the avionics has been made anew
//   tick   sensors, frames   ->   done    the record, servos, frames
// and, instead of `begun` or `done`, as often as it wants,
//                                 flash_request   read, program, erase
//   flash_answer             ->   ... as before

enum class HilType : std::uint8_t {
  hello = 0x40,
  ready,
  begin,
  begun,
  tick,
  done,
  flash_request,
  flash_answer,
  refused,  ///< it was not understood; says why
};

/// Of the messages' layout, beside what HilLayout sees of it.
inline constexpr std::uint16_t hil_version = 1;
/// The flight plan's block with what goes with it, or a tick with 64 frames of the bus.
inline constexpr std::size_t largest_hil_payload = 2048;

/// One frame on its way out; its payload is written in place.
class HilFrameOut {
 public:
  [[nodiscard]] std::span<std::byte> payload() { return std::span{bytes_}.subspan(log_head_size, largest_hil_payload); }

  /// Makes the frame complete. Valid until the next one.
  std::span<const std::byte> seal(HilType type, std::uint32_t sequence, std::size_t payload_size,
                                  core::Microseconds time = {});
  /// The last one again; empty when there was none.
  [[nodiscard]] std::span<const std::byte> sealed() const { return std::span{bytes_}.first(size_); }

 private:
  std::array<std::byte, log_frame_overhead + largest_hil_payload> bytes_{};
  std::size_t size_ = 0;
};

/// Frames out of bytes that arrive in pieces of any size.
class HilFrameIn {
 public:
  /// Where the next bytes may be put. What next() returned before is no longer valid.
  [[nodiscard]] std::span<std::byte> room();
  void arrived(std::size_t bytes) { end_ += bytes; }

  /// The next intact frame; empty when there is none yet.
  std::optional<LogFrame> next();

  /// Frames whose checksum was wrong, or whose length is impossible.
  [[nodiscard]] std::uint32_t damaged() const { return damaged_; }

 private:
  std::array<std::byte, log_frame_overhead + largest_hil_payload> bytes_{};
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
  std::uint32_t damaged_ = 0;
};

}  // namespace fantail::protocol
