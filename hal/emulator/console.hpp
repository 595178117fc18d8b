// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "hal/console.hpp"

namespace fantail::hal::emulator {

/// Keeps what was written in one tick for the message that ends it.
class Console final : public hal::Console {
 public:
  void write(std::string_view text) override {
    const std::size_t count = std::min(text.size(), text_.size() - size_);
    std::copy_n(text.begin(), count, text_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += count;
  }

  [[nodiscard]] std::string_view text() const { return {text_.data(), size_}; }
  void clear() { size_ = 0; }

 private:
  std::array<char, 512> text_{};
  std::size_t size_ = 0;
};

}  // namespace fantail::hal::emulator
