// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace fantail::test {

/// The seed of a random test: what FANTAIL_SEED says, else `usual`, else a new one at every call. Said on standard
/// output at once, because what is found may end the program.
[[nodiscard]] inline std::uint32_t seed(std::optional<std::uint32_t> usual = {}) {
  const char* const asked = std::getenv("FANTAIL_SEED");
  std::uint32_t result = usual ? *usual : std::random_device{}();
  if (asked != nullptr) {
    const std::string_view text{asked};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
    if (error != std::errc{} || end != text.data() + text.size()) {
      throw std::invalid_argument{"FANTAIL_SEED is no whole number from 0 to 4294967295: " + std::string{text}};
    }
  }
  std::printf("seed %u; the same again with FANTAIL_SEED=%u\n", result, result);
  std::fflush(stdout);
  return result;
}

/// How often a test repeats something: what this variable of the environment says, which ./dev soak sets, else `usual`.
[[nodiscard]] inline int how_many(const char* variable, int usual) {
  const char* const asked = std::getenv(variable);
  return asked != nullptr ? std::stoi(asked) : usual;
}

}  // namespace fantail::test
