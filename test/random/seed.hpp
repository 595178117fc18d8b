// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

namespace fantail::test {

/// The seed of a random test: what FANTAIL_SEED says, else `usual`, else a new one at every call. Said on standard
/// output at once, because what is found may end the program.
[[nodiscard]] inline std::uint32_t seed(std::optional<std::uint32_t> usual = {}) {
  const char* const asked = std::getenv("FANTAIL_SEED");
  std::uint32_t result = usual ? *usual : std::random_device{}();
  if (asked != nullptr) {
    std::size_t used = 0;
    const unsigned long long number = std::stoull(asked, &used);
    if (asked[used] != '\0' || number > UINT32_MAX) {
      throw std::invalid_argument{"FANTAIL_SEED is no whole number from 0 to 4294967295: " + std::string{asked}};
    }
    result = static_cast<std::uint32_t>(number);
  }
  std::printf("seed %u; the same again with FANTAIL_SEED=%u\n", result, result);
  std::fflush(stdout);
  return result;
}

}  // namespace fantail::test
