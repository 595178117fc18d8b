// SPDX-License-Identifier: MIT
#include "link/log_download.hpp"

#include <algorithm>

namespace fantail::link {
namespace {

bool same(LogReader& reader, const LogStretch& stretch, const LogPart& part, std::uint32_t offset, std::uint32_t size) {
  while (size > 0) {
    const std::vector<std::byte> there = reader.read(stretch.offset + offset, size);
    const auto count = static_cast<std::uint32_t>(there.size());
    if (there != part.read(offset, count)) {
      return false;
    }
    offset += count;
    size -= count;
  }
  return true;
}

bool same_record(LogReader& reader, const LogStretch& stretch, const LogPart& part) {
  const std::uint32_t look = std::min<std::uint32_t>(part.size(), protocol::largest_log_chunk);
  return part.size() <= stretch.size && same(reader, stretch, part, 0, look) &&
         same(reader, stretch, part, part.size() - look, look);
}

}  // namespace

std::uint32_t download(LogReader& reader, const LogStretch& stretch, LogPart& part,
                       const std::function<void(std::uint32_t)>& progress) {
  if (part.size() > 0 && !same_record(reader, stretch, part)) {
    part.start_anew();
  }
  const std::uint32_t before = part.size();
  while (part.size() < stretch.size) {
    part.append(reader.read(stretch.offset + part.size(), stretch.size - part.size()));
    progress(part.size());
  }
  return before;
}

}  // namespace fantail::link
