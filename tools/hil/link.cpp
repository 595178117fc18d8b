// SPDX-License-Identifier: MIT
#include "hil/link.hpp"

#include <fmt/format.h>

namespace fantail::hil {

using Clock = std::chrono::steady_clock;

protocol::LogFrame Link::ask(protocol::HilType type, std::size_t payload_size, core::Microseconds time) {
  sequence_ += 1;
  const auto question = out_.seal(type, sequence_, payload_size, time);
  wire_->write(question);
  const std::uint32_t damaged_before = damaged();
  Clock::time_point begin{};
  for (;;) {
    while (const auto frame = in_.next()) {
      if (frame->head.sequence == sequence_) {  // else the answer to a question that was asked twice
        return *frame;
      }
    }
    const std::size_t count = wire_->read(in_.room(), send_again_after);
    in_.arrived(count);
    if (count != 0) {
      continue;
    }
    if (waiting_) {
      waiting_();
    }
    const auto now = Clock::now();
    begin = begin == Clock::time_point{} ? now - send_again_after : begin;
    if (now - begin >= patience) {
      const std::uint32_t damaged_now = damaged() - damaged_before;
      throw TargetError{
          damaged_now == 0
              ? fmt::format("the flight computer has said nothing for {} s", patience / std::chrono::seconds{1})
              : fmt::format("the flight computer's frames arrive damaged: {} in the last {} s", damaged_now,
                            patience / std::chrono::seconds{1})};
    }
    asked_again_ += 1;
    wire_->write(question);
  }
}

}  // namespace fantail::hil
