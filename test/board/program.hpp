// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <exception>
#include <functional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "processor.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::board {

/// The frame of the measuring programs: `run` gets their words. 64 with the usage when there are too few or too many of
/// them or one is no number, 65 when the image or something else is not as it must be.
inline int run_program(int argc, char** argv, int fewest, int most, std::string_view usage,
                       const std::function<int()>& run) {
  try {
    if (argc - 1 < fewest || argc - 1 > most) {
      throw text::Error{text::ErrorKind::usage, fmt::format("usage: {}", usage)};
    }
    return run();
  } catch (const text::Error& error) {
    fmt::print(stderr, "{}: {}\n", argv[0], error.what());
    return error.kind() == text::ErrorKind::usage ? 64 : 65;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", argv[0], error.what());
    return 65;
  }
}

/// Throws text::Error.
inline int whole_word(std::string_view word, std::string_view name, int least) {
  const auto number = text::whole_number(word);
  if (!number || *number < static_cast<std::uint64_t>(least) || *number > INT32_MAX) {
    throw text::Error{text::ErrorKind::usage,
                      fmt::format("{} is \"{}\"; allowed: {} to {}", name, word, least, INT32_MAX)};
  }
  return static_cast<int>(*number);
}

/// Throws text::Error.
inline Pace pace_word(std::string_view word) {
  const auto number = text::decimal(word);
  if (!number || !(*number >= 1.0 && *number <= 20.0)) {
    throw text::Error{text::ErrorKind::usage, fmt::format("CYCLES_PER_INSTRUCTION is \"{}\"; allowed: 1 to 20", word)};
  }
  return {.cycles_per_instruction = *number};
}

}  // namespace fantail::board
