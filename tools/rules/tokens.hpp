// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::rules {

struct Token {
  enum class Kind : std::uint8_t { number, text, name, sign, end };
  Kind kind = Kind::end;
  std::string text{};  ///< of a text without its quotes; `and`, `or`, `not`, `true` and `false` are signs
  double number = 0.0;
  std::size_t position = 1;
};

/// The parts of an expression, and the end. Throws ExpressionError.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view text);

}  // namespace fantail::rules
