// SPDX-License-Identifier: MIT
#include "boards/cortex_m4/image.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/crc32c.hpp"

extern "C" {
extern const std::byte image_begin[];           // of the linker script
extern const volatile std::uint32_t image_crc;  // written when the image was sealed, so the compiler must not know it
}

namespace fantail::boards {

void ImageCheck::go_on(std::size_t bytes) {
  const auto* const end = reinterpret_cast<const std::byte*>(const_cast<const std::uint32_t*>(&image_crc));
  const std::span<const std::byte> left{image_begin + looked_at_, end};
  if (left.empty()) {
    return;
  }
  const auto part = left.first(std::min(bytes, left.size()));
  crc_ = protocol::crc32c(crc_, part);
  looked_at_ += part.size();
  failed_ = part.size() == left.size() && crc_ != image_crc;
}

}  // namespace fantail::boards
