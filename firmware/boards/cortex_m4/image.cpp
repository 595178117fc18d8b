// SPDX-License-Identifier: MIT
#include "boards/cortex_m4/image.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

#include "protocol/crc32c.hpp"

extern "C" {
extern const std::byte image_begin[];           // of the linker script
extern const volatile std::uint32_t image_crc;  // written when the image was sealed, so the compiler must not know it
}

namespace fantail::boards {

bool image_is_intact() {
  const auto* const end = reinterpret_cast<const std::byte*>(const_cast<const std::uint32_t*>(&image_crc));
  return protocol::crc32c({image_begin, end}) == image_crc;
}

}  // namespace fantail::boards
