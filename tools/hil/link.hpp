// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/time.hpp"
#include "hil/wire.hpp"
#include "protocol/hil_frame.hpp"

namespace fantail::hil {

/// Called a few times a second while nothing comes. What it throws ends the waiting.
using Waiting = std::function<void()>;

struct Patience {
  std::chrono::milliseconds send_again{250};
  std::chrono::milliseconds give_up{5'000};
};

/// The world's side of the link (protocol/hil_frame.hpp): it asks, and waits for the answer.
class Link {
 public:
  explicit Link(std::unique_ptr<Wire> wire, Waiting waiting = {}, const Patience& patience = {})
      : wire_{std::move(wire)}, waiting_{std::move(waiting)}, patience_{patience} {}

  /// Where the payload of the next question goes.
  [[nodiscard]] std::span<std::byte> payload() { return out_.payload(); }
  /// Its payload is valid until the next call. Throws TargetError when no answer came in time.
  [[nodiscard]] protocol::LogFrame ask(protocol::HilType type, std::size_t payload_size, core::Microseconds time = {});

  /// Questions that were asked more than once, since either was damaged on its way, they or the answer.
  [[nodiscard]] std::uint32_t asked_again() const { return asked_again_; }
  /// Of the frames that came, those that were damaged.
  [[nodiscard]] std::uint32_t damaged() const { return in_.damaged(); }

 private:
  [[noreturn]] void give_up(std::uint32_t damaged_frames) const;

  std::unique_ptr<Wire> wire_;
  Waiting waiting_;
  Patience patience_;
  protocol::HilFrameIn in_;
  protocol::HilFrameOut out_;
  std::uint32_t sequence_ = 0;
  std::uint32_t asked_again_ = 0;
};

}  // namespace fantail::hil
