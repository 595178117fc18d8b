// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/clock.hpp"
#include "hal/emulator/channel.hpp"
#include "protocol/hil_frame.hpp"

namespace fantail::world_link {

/// The flight computer's side of the link (protocol/hil_frame.hpp): it is asked, and answers.
class Link {
 public:
  /// The channel outlives this object.
  explicit Link(hal::emulator::Channel& channel) : channel_{channel} {}
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;

  /// Waits for the next question; one that was answered before gets its answer again. Its payload is valid until the
  /// next call.
  [[nodiscard]] protocol::LogFrame receive();

  /// Where the payload of the answer goes.
  [[nodiscard]] std::span<std::byte> payload() { return out_.payload(); }
  void answer(protocol::HilType type, std::size_t payload_size, hal::Microseconds time = {});

  /// Instead of an answer a question of this side, in the middle of its work. Empty when a world has begun anew
  /// instead: then this work is for nobody, and its answer will not be sent.
  [[nodiscard]] std::optional<protocol::LogFrame> ask(protocol::HilType type, std::size_t payload_size);

 private:
  [[nodiscard]] bool is_news(const protocol::LogFrame& frame);

  hal::emulator::Channel& channel_;
  protocol::HilFrameIn in_;
  protocol::HilFrameOut out_;
  std::optional<protocol::LogFrameHead> last_;     ///< the question that was taken last
  std::optional<protocol::LogFrame> begins_anew_;  ///< a hello that came in the middle of work
};

}  // namespace fantail::world_link
