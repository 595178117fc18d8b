// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace fantail::table_file {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

/// Puts a number at the end of some bytes, as all of these formats have it.
template <typename T>
  requires std::is_arithmetic_v<T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The number at a place; empty when the bytes end before it does.
template <typename T>
  requires std::is_arithmetic_v<T>
[[nodiscard]] std::optional<T> get(std::string_view bytes, std::size_t at = 0) {
  if (at > bytes.size() || bytes.size() - at < sizeof(T)) {
    return {};
  }
  T value{};
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace fantail::table_file
