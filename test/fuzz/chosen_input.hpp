// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "target.hpp"
#include "text/error.hpp"

namespace fantail::fuzz {

/// For targets whose first byte chooses what the rest is: calls read(byte, rest). A refusal must be a sentence.
template <typename Read>
int read_chosen(const std::uint8_t* data, std::size_t size, const Read& read) {
  if (size > 0) {
    try {
      read(data[0], std::string(reinterpret_cast<const char*>(data) + 1, size - 1));
    } catch (const text::Error& error) {
      require_sentence(error.what());
    }
  }
  return 0;
}

}  // namespace fantail::fuzz
