// SPDX-License-Identifier: MIT
#include "listen/ulog_fields.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/core.h>

namespace fantail::listen {
namespace {

constexpr std::size_t most_elements = 16;

template <typename T>
double as(const char* bytes) {
  T value{};
  std::memcpy(&value, bytes, sizeof value);  // little-endian, as is every PC
  return static_cast<double>(value);
}

struct Type {
  std::string_view name;
  std::size_t size;
  double (*read)(const char* bytes);
};
constexpr std::array types{
    Type{"int8_t", 1, as<std::int8_t>},
    Type{"uint8_t", 1, as<std::uint8_t>},
    Type{"bool", 1, as<std::uint8_t>},
    Type{"char", 1, as<std::uint8_t>},
    Type{"int16_t", 2, as<std::int16_t>},
    Type{"uint16_t", 2, as<std::uint16_t>},
    Type{"int32_t", 4, as<std::int32_t>},
    Type{"uint32_t", 4, as<std::uint32_t>},
    Type{"float", 4, as<float>},
    Type{"int64_t", 8, as<std::int64_t>},
    Type{"uint64_t", 8, as<std::uint64_t>},
    Type{"double", 8, as<double>},
};

// "float[3] gyro_rad": its type and how many of them.
std::optional<std::pair<const Type*, std::size_t>> type_of(std::string_view text) {
  std::size_t count = 1;
  if (const std::size_t bracket = text.find('['); bracket != std::string_view::npos) {
    count = 0;
    for (const char digit : text.substr(bracket + 1)) {
      if (digit == ']') {
        break;
      }
      if (digit < '0' || digit > '9' || count > 10'000) {
        return std::nullopt;
      }
      count = count * 10 + static_cast<std::size_t>(digit - '0');
    }
    text = text.substr(0, bracket);
  }
  const auto found = std::ranges::find(types, text, &Type::name);
  return found == types.end() || count == 0 ? std::nullopt : std::optional{std::pair{&*found, count}};
}

}  // namespace

UlogFormat ulog_format(std::string_view format) {
  UlogFormat result;
  while (!format.empty()) {
    const std::size_t end = std::min(format.find(';'), format.size());
    const std::string_view text = format.substr(0, end);
    format.remove_prefix(std::min(end + 1, format.size()));
    const std::size_t space = text.find(' ');
    const auto type = type_of(text.substr(0, space));
    if (space == std::string_view::npos || !type) {
      result.whole = false;
      break;
    }
    const std::string name{text.substr(space + 1)};
    const bool is_padding = name.starts_with("_padding");
    for (std::size_t i = 0; i < type->second; ++i) {
      if (type->second <= most_elements && !is_padding) {
        result.fields.push_back({type->second == 1 ? name : fmt::format("{}[{}]", name, i), type->first->size,
                                 type->first->read, result.size});
      }
      result.size += type->first->size;
    }
    result.padding = is_padding ? type->second * type->first->size : 0;
  }
  return result;
}

}  // namespace fantail::listen
