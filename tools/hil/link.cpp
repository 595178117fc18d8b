// SPDX-License-Identifier: MIT
#include "hil/link.hpp"

#include <optional>

#include <fmt/core.h>

namespace fantail::hil {

using Clock = std::chrono::steady_clock;

protocol::LogFrame Link::ask(protocol::HilType type, std::size_t payload_size, core::Microseconds time) {
  sequence_ += 1;
  const auto question = out_.seal(type, sequence_, payload_size, time);
  wire_->write(question);
  const std::uint32_t damaged_before = damaged();
  std::optional<Clock::time_point> silent_since;
  for (;;) {
    while (const auto frame = in_.next()) {
      if (frame->head.sequence == sequence_) {  // else the answer to a question that was asked twice
        return *frame;
      }
    }
    const std::size_t count = wire_->read(in_.room(), patience_.send_again);
    in_.arrived(count);
    if (count != 0) {
      continue;
    }
    if (waiting_) {
      waiting_();
    }
    const auto now = Clock::now();
    silent_since = silent_since.value_or(now - patience_.send_again);
    if (now - *silent_since >= patience_.give_up) {
      give_up(damaged() - damaged_before);
    }
    asked_again_ += 1;
    wire_->write(question);
  }
}

void Link::give_up(std::uint32_t damaged_frames) const {
  const double seconds = 1e-3 * static_cast<double>(patience_.give_up.count());
  throw TargetError{damaged_frames == 0
                        ? fmt::format("the flight computer has said nothing for {:g} s", seconds)
                        : fmt::format("the flight computer's frames arrive damaged, {} of them in {:g} s; is it "
                                      "another baud rate, or another program?",
                                      damaged_frames, seconds)};
}

}  // namespace fantail::hil
