// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

// libFuzzer calls it; every target defines it, and seeds().
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fantail::fuzz {

/// What the mutations begin from: sound input, made by the code that writes such files where there is one.
[[nodiscard]] std::vector<std::string> seeds();

/// A promise that is not kept ends the process, which is what a fuzzer looks for.
inline void require(bool promise) {
  if (!promise) {
    std::abort();
  }
}

[[nodiscard]] inline bool is_sentence(const std::string& text) {
  return !text.empty() && text.size() < 4000 &&
         std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
}

/// Says the text that breaks the promise.
inline void require_sentence(const std::string& text) {
  if (!is_sentence(text)) {
    std::fprintf(stderr, "this is no sentence: \"%s\"\n", text.c_str());
    std::abort();
  }
}

}  // namespace fantail::fuzz
