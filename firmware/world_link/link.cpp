// SPDX-License-Identifier: MIT
#include "world_link/link.hpp"

#include <utility>

namespace fantail::world_link {

using protocol::HilType;
using protocol::LogFrame;

LogFrame Link::receive() {
  if (begins_anew_) {
    return *std::exchange(begins_anew_, std::nullopt);
  }
  for (;;) {
    while (const auto frame = in_.next()) {
      if (is_news(*frame)) {
        return *frame;
      }
    }
    in_.arrived(channel_.read(in_.room()));
  }
}

bool Link::is_news(const LogFrame& frame) {
  const bool hello = frame.head.type == static_cast<std::uint8_t>(HilType::hello);
  if (last_ && frame.head.sequence == last_->sequence && frame.head.type == last_->type) {
    channel_.write(out_.sealed());
    return false;
  }
  if (!hello && (!last_ || frame.head.sequence != last_->sequence + 1)) {
    return false;  // of a world that this side has not met, or long gone
  }
  last_ = frame.head;
  return true;
}

void Link::answer(HilType type, std::size_t payload_size, hal::Microseconds time) {
  if (!begins_anew_) {
    channel_.write(out_.seal(type, last_ ? last_->sequence : 0, payload_size, time));
  }
}

std::optional<LogFrame> Link::ask(HilType type, std::size_t payload_size) {
  answer(type, payload_size);
  const LogFrame frame = receive();
  if (frame.head.type == static_cast<std::uint8_t>(HilType::hello)) {
    begins_anew_ = frame;
    return std::nullopt;
  }
  return frame;
}

}  // namespace fantail::world_link
