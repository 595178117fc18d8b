// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fantail::hal {

/// In bytes: `size` is that of all. A sector is a whole number of pages, the flash a whole number of sectors.
struct FlashGeometry {
  std::uint32_t size = 0;
  std::uint32_t sector_size = 0;  ///< what one erase turns to ones
  std::uint32_t page_size = 0;    ///< what one program may touch
};

/// What became of a call.
enum class FlashResult : std::uint8_t {
  ok,            ///< read: done. program, erase: begun
  busy,          ///< an operation is still under way; nothing was begun
  out_of_range,  ///< beyond the end, across a page, or not the start of a sector; nothing was begun
  failed,        ///< the device does not answer
};

/// NOR flash: an erased byte is 0xFF, programming only turns ones into zeros, and only erasing turns them back. Program
/// and erase take milliseconds, so they are begun here and go on by themselves; nothing ever waits.
class Flash {
 public:
  virtual ~Flash() = default;
  /// All zeros where there is no device that can be used; known only after it was found.
  [[nodiscard]] virtual FlashGeometry geometry() const = 0;
  /// Fills all of `out`, from anywhere to anywhere within the flash, or says why not.
  virtual FlashResult read(std::uint32_t address, std::span<std::byte> out) = 0;
  /// Within one page. A byte that was not erased becomes the AND of old and new.
  virtual FlashResult program(std::uint32_t address, std::span<const std::byte> bytes) = 0;
  /// `address`: where the sector begins. All its bytes become 0xFF.
  virtual FlashResult erase_sector(std::uint32_t address) = 0;
  /// Is a program or an erase still under way?
  [[nodiscard]] virtual bool busy() = 0;
};

}  // namespace fantail::hal
