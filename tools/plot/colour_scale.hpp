// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::plot {

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;

  bool operator==(const Colour&) const = default;
};

/// From dark violet at 0 over green to bright yellow at 1. Lightness grows evenly, so that the order can be read
/// without colour vision, in grey print, on white and on black. Values outside 0..1 get the end colours.
[[nodiscard]] Colour colour_at(double part);

}  // namespace fantail::plot
