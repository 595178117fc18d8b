// SPDX-License-Identifier: MIT
#include "protocol/hil_frame.hpp"

#include <algorithm>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

std::span<const std::byte> HilFrameOut::seal(HilType type, std::uint32_t sequence, std::size_t payload_size,
                                             core::Microseconds time) {
  const std::size_t tail = log_head_size + std::min(payload_size, largest_hil_payload);
  const auto head = encode(LogFrameHead{.type = static_cast<std::uint8_t>(type),
                                        .length = static_cast<std::uint16_t>(tail - log_head_size),
                                        .sequence = sequence,
                                        .time = time});
  std::ranges::copy(head, bytes_.begin());
  put<4>(bytes_, tail, crc32c(std::span{bytes_}.first(tail)));
  size_ = tail + 4;
  return sealed();
}

std::span<std::byte> HilFrameIn::room() {
  std::copy(bytes_.begin() + static_cast<std::ptrdiff_t>(begin_), bytes_.begin() + static_cast<std::ptrdiff_t>(end_),
            bytes_.begin());
  end_ -= begin_;
  begin_ = 0;
  return std::span{bytes_}.subspan(end_);
}

std::optional<LogFrame> HilFrameIn::next() {
  while (begin_ < end_) {
    const auto rest = std::span<const std::byte>{bytes_}.subspan(begin_, end_ - begin_);
    if (rest[0] != log_sync) {
      begin_ += 1;
      continue;
    }
    if (rest.size() < log_head_size) {
      return std::nullopt;
    }
    const auto length = static_cast<std::size_t>(get<2>(rest, 2));
    if (length <= largest_hil_payload) {
      if (rest.size() < log_frame_overhead + length) {
        return std::nullopt;
      }
      const auto whole = rest.first(log_frame_overhead + length);
      if (const auto frame = LogFrameReader{whole}.next(); frame && frame->position == 0) {
        begin_ += whole.size();
        return frame;
      }
    }
    damaged_ += 1;
    begin_ += 1;  // its first byte was none, or was damaged: a frame may begin at any of the others
  }
  return std::nullopt;
}

}  // namespace fantail::protocol
