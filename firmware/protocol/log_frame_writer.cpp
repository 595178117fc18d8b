// SPDX-License-Identifier: MIT
#include "protocol/log_frame_writer.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

std::size_t LogFrameWriter::frame_size(const Parts& payload) {
  return log_frame_overhead + payload[0].size() + payload[1].size() + payload[2].size();
}

void LogFrameWriter::begin(LogFrameHead head, const Parts& payload) {
  head.length = static_cast<std::uint16_t>(frame_size(payload) - log_frame_overhead);
  head_ = encode(head);
  parts_ = {head_, payload[0], payload[1], payload[2], tail_};
  part_ = 0;
  crc_ = 0;
  untouched_ = true;
}

// Three of four frames fit into what is left of a page.
std::size_t LogFrameWriter::write_whole(std::span<std::byte> out) {
  std::size_t size = 0;
  for (const std::span<const std::byte> part : std::span{parts_}.first<tail>()) {
    if (!part.empty()) {
      std::memcpy(out.data() + size, part.data(), part.size());
      size += part.size();
    }
  }
  put<4>(out, size, crc32c(out.first(size)));
  abandon();
  return size + tail_.size();
}

std::size_t LogFrameWriter::write(std::span<std::byte> out) {
  if (std::exchange(untouched_, false) && out.size() >= frame_size({parts_[1], parts_[2], parts_[3]})) {
    return write_whole(out);
  }
  std::size_t size = 0;
  std::size_t summed = 0;
  while (!done() && size < out.size()) {
    std::span<const std::byte>& part = parts_[part_];
    const std::size_t count = std::min(part.size(), out.size() - size);
    std::memcpy(out.data() + size, part.data(), count);  // not std::copy_n, which may mean memmove, byte by byte
    size += count;
    part = part.subspan(count);
    while (!done() && parts_[part_].empty()) {
      part_ += 1;
      if (part_ == tail) {
        // Over what lies together, because a word need not end where a part does.
        crc_ = crc32c(crc_, out.subspan(summed, size - summed));
        summed = size;
        put<4>(tail_, 0, crc_);
      }
    }
  }
  if (part_ < tail) {
    crc_ = crc32c(crc_, out.subspan(summed, size - summed));
  }
  return size;
}

}  // namespace fantail::protocol
