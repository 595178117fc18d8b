// SPDX-License-Identifier: MIT
#include "fantail/number_option.hpp"

#include <string>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "text/number.hpp"

namespace fantail::tool {

Objection within(double low, double high) {
  return [low, high](const std::string& text) {
    const auto value = text::number(text);
    return value && *value >= low && *value <= high
               ? std::string{}
               : fmt::format("\"{}\": allowed: {} to {}", text, input::shown(low), input::shown(high));
  };
}

}  // namespace fantail::tool
