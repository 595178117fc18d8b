// SPDX-License-Identifier: MIT
#include "protocol/log_frame_writer.hpp"

#include <algorithm>
#include <cstring>

#include "protocol/crc32c.hpp"
#include "protocol/little_endian.hpp"

namespace fantail::protocol {

namespace {

std::size_t write_whole(const LogFrameHead& head, const LogFrameWriter::Parts& payload, std::span<std::byte> out) {
  encode(head, out);
  std::size_t size = log_head_size;
  for (const std::span<const std::byte> part : payload) {
    if (!part.empty()) {
      std::memcpy(out.data() + size, part.data(), part.size());
      size += part.size();
    }
  }
  const std::uint32_t crc = crc32c(out.first(size));
  put<4>(out, size, crc);
  return size + sizeof crc;
}

}  // namespace

std::size_t LogFrameWriter::begin(LogFrameHead head, const Parts& payload, std::span<std::byte> out) {
  const std::size_t size = frame_size(payload);
  head.length = static_cast<std::uint16_t>(size - log_frame_overhead);
  if (size <= out.size()) {  // three of four frames fit into what is left of a page
    return write_whole(head, payload, out);
  }
  encode(head, head_);
  parts_ = {head_, payload[0], payload[1], payload[2], payload[3], tail_};
  part_ = 0;
  crc_ = 0;
  return write(out);
}

std::size_t LogFrameWriter::write(std::span<std::byte> out) {
  std::size_t size = 0;
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
        crc_ = crc32c(crc_, out.first(size));
        put<4>(tail_, 0, crc_);
      }
    }
  }
  if (part_ < tail) {
    crc_ = crc32c(crc_, out.first(size));
  }
  return size;
}

}  // namespace fantail::protocol
