// SPDX-License-Identifier: MIT
#include "protocol/log_frame.hpp"

#include "protocol/crc32c.hpp"

namespace fantail::protocol {
namespace {

constexpr std::byte erased{0xFF};

}  // namespace

std::array<std::byte, log_head_size> encode(const LogFrameHead& head) {
  std::array<std::byte, log_head_size> out{};
  encode(head, out);
  return out;
}

std::optional<LogFrame> LogFrameReader::next() {
  while (position_ < bytes_.size()) {
    if (const auto frame = frame_here()) {
      position_ += log_frame_overhead + frame->payload.size();
      return frame;
    }
    pass_over_byte();
  }
  return std::nullopt;
}

std::optional<LogFrame> LogFrameReader::frame_here() const {
  const auto rest = bytes_.subspan(position_);
  if (rest[0] != log_sync || rest.size() < log_frame_overhead) {
    return std::nullopt;
  }
  const auto length = static_cast<std::size_t>(get<2>(rest, 2));
  if (length > largest_log_payload || rest.size() < log_frame_overhead + length) {
    return std::nullopt;
  }
  const std::size_t end = log_head_size + length;
  if (get<4>(rest, end) != crc32c(rest.first(end))) {
    return std::nullopt;
  }
  return LogFrame{.head = {.type = static_cast<std::uint8_t>(rest[1]),
                           .length = static_cast<std::uint16_t>(length),
                           .sequence = static_cast<std::uint32_t>(get<4>(rest, 4)),
                           .time = core::Microseconds{static_cast<std::int64_t>(get<6>(rest, 8))}},
                  .payload = rest.subspan(log_head_size, length),
                  .position = position_};
}

void LogFrameReader::pass_over_byte() {
  foreign_bytes_ += bytes_[position_] == erased ? 0 : 1;
  position_ += 1;
}

}  // namespace fantail::protocol
