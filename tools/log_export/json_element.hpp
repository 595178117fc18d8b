// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include "flight/six_decimals.hpp"
#include "log_export/fields.hpp"

namespace fantail::log_export {

/// Puts one value of a tick into JSON.
struct JsonElement {
  fmt::memory_buffer& out;

  void operator()(std::monostate) const { out.append(std::string_view{"null"}); }
  void operator()(double value) const { out.append(flight::SixDecimals{value}.brief()); }
  void operator()(std::int64_t value) const {
    const fmt::format_int digits{value};
    out.append(digits.data(), digits.data() + digits.size());
  }
  void operator()(bool value) const { out.append(std::string_view{value ? "true" : "false"}); }
  void operator()(const Word& word) const {
    out.push_back('"');
    out.append(word.text);
    out.push_back('"');
  }
};

}  // namespace fantail::log_export
