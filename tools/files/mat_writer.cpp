// SPDX-License-Identifier: MIT
#include "files/mat_writer.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include "text/deflate.hpp"
#include "text/error.hpp"

namespace fantail::files::mat {
namespace {

/// How an element of a file is stored, of those that are written.
enum class Stored : std::uint8_t {
  int8 = 1,
  uint16 = 4,
  int32 = 5,
  uint32 = 6,
  float64 = 9,
  matrix = 14,
  compressed = 15
};

/// What an array is for MATLAB.
enum class Class : std::uint8_t { cell = 1, structure = 2, text = 4, float64 = 6 };

constexpr std::string_view beginning = "MATLAB 5.0 MAT-file";
constexpr std::uint16_t version = 0x0100;
constexpr std::uint16_t byte_order = 0x4D49;  // "IM" where the file is little-endian

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");

template <typename T>
  requires std::is_arithmetic_v<T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

constexpr std::size_t padded(std::size_t size) { return (size + 7) / 8 * 8; }

constexpr char32_t replacement = 0xFFFD;
constexpr char32_t beyond_one_unit = 0x10000;

bool is_half(char32_t code) { return code >= 0xD800 && code < 0xE000; }

// The character at the front and how many bytes it has; none of it: the replacement, and one.
std::pair<char32_t, std::size_t> first_of(std::string_view utf8) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(utf8[i]); };
  const auto length = static_cast<std::size_t>(std::countl_one(byte(0)));
  if (length == 0) {
    return {byte(0), 1};
  }
  if (length < 2 || length > 4 || utf8.size() < length) {
    return {replacement, 1};
  }
  char32_t code = byte(0) & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (std::countl_one(byte(i)) != 1) {
      return {replacement, 1};
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr char32_t least[] = {0x80, 0x800, beyond_one_unit};
  const bool ok = code >= least[length - 2] && code < 0x110000 && !is_half(code);
  return ok ? std::pair{code, length} : std::pair{replacement, std::size_t{1}};
}

// Bytes that are no UTF-8 become U+FFFD, one each.
std::u16string utf16(std::string_view utf8) {
  std::u16string out;
  while (!utf8.empty()) {
    const auto [code, size] = first_of(utf8);
    if (code < beyond_one_unit) {
      out += static_cast<char16_t>(code);
    } else {
      out += static_cast<char16_t>(0xD800 + ((code - beyond_one_unit) >> 10U));
      out += static_cast<char16_t>(0xDC00 + ((code - beyond_one_unit) & 0x3FFU));
    }
    utf8.remove_prefix(size);
  }
  return out;
}

std::uint32_t size_of(std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<std::int32_t>::max()) {
    throw text::Error{text::ErrorKind::bad_data, "a MAT-file of version 5 cannot contain more than 2 GB in a variable"};
  }
  return static_cast<std::uint32_t>(bytes.size());
}

void add(std::string& out, Stored stored, std::string_view bytes) {
  put(out, static_cast<std::uint32_t>(stored));
  put(out, size_of(bytes));
  out += bytes;
  out.resize(padded(out.size()));
}

std::string_view bytes_of(const auto& list) {
  return {reinterpret_cast<const char*>(list.data()), list.size() * sizeof *list.data()};
}

// Everything of an array but its values.
std::string head(Class kind, std::size_t rows, std::size_t columns, std::string_view name) {
  std::string out;
  std::string flags;
  put(flags, static_cast<std::uint32_t>(kind));
  put(flags, std::uint32_t{0});
  add(out, Stored::uint32, flags);
  std::string dimensions;
  put(dimensions, static_cast<std::int32_t>(rows));
  put(dimensions, static_cast<std::int32_t>(columns));
  add(out, Stored::int32, dimensions);
  add(out, Stored::int8, name);
  return out;
}

std::string matrix(std::string_view content) {
  std::string out;
  add(out, Stored::matrix, content);
  return out;
}

}  // namespace

std::string column(std::span<const double> values, std::string_view name) {
  std::string content = head(Class::float64, values.size(), 1, name);
  add(content, Stored::float64, bytes_of(values));
  return matrix(content);
}

std::string text(std::string_view utf8, std::string_view name) {
  const std::u16string units = utf16(utf8);
  std::string content = head(Class::text, units.empty() ? 0 : 1, units.size(), name);
  add(content, Stored::uint16, bytes_of(units));
  return matrix(content);
}

std::string cell(std::span<const std::string> elements, std::string_view name) {
  std::string content = head(Class::cell, elements.size(), 1, name);
  for (const std::string& element : elements) {
    content += element;
  }
  return matrix(content);
}

std::string structs(std::size_t count, std::span<const Member> members, std::string_view name) {
  std::string content = head(Class::structure, count, 1, name);
  constexpr std::uint32_t name_size = longest_name + 1;
  // The one element that readers want in its short form: size and type in one word.
  put(content, static_cast<std::uint32_t>(Stored::int32) | std::uint32_t{sizeof name_size} << 16U);
  put(content, name_size);
  std::string names;
  for (const Member& member : members) {
    names += member.name;
    names.resize((names.size() + name_size - 1) / name_size * name_size);
  }
  add(content, Stored::int8, names);
  for (std::size_t i = 0; i < count; ++i) {
    for (const Member& member : members) {
      content += member.elements[i];
    }
  }
  return matrix(content);
}

std::string file(std::span<const std::string> variables) {
  constexpr std::size_t text_size = 116;
  std::string out = std::string{beginning} + ", written by Fantail";
  out.resize(text_size, ' ');
  out.resize(text_size + 8, '\0');  // where the data of MATLAB's own classes would be: there are none
  put(out, version);
  put(out, byte_order);
  for (const std::string& variable : variables) {
    const std::string packed = text::zlib_packed(variable);
    put(out, static_cast<std::uint32_t>(Stored::compressed));
    put(out, size_of(packed));
    out += packed;  // of all elements these alone are not padded
  }
  return out;
}

}  // namespace fantail::files::mat
