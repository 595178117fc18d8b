// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace fantail::boards {

/// Are the bytes of this program those that were built? Looked at in parts, because all of them together take 3 ms.
class ImageCheck {
 public:
  /// So many bytes more, at most.
  void go_on(std::size_t bytes);
  /// All of them have been looked at, and the CRC that was written when the image was sealed is another.
  [[nodiscard]] bool has_failed() const { return failed_; }

 private:
  std::size_t looked_at_ = 0;
  std::uint32_t crc_ = 0;
  bool failed_ = false;
};

}  // namespace fantail::boards
