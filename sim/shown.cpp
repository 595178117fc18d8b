// SPDX-License-Identifier: MIT
#include "sim/shown.hpp"

#include <array>
#include <charconv>

namespace fantail::sim {

std::string shown(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string about(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr};
}

}  // namespace fantail::sim
