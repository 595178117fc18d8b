// SPDX-License-Identifier: MIT
#include "table_file/mat_writer.hpp"

#include <cstdint>
#include <limits>

#include "table_file/little_endian.hpp"
#include "table_file/mat_format.hpp"
#include "table_file/utf16.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"

namespace fantail::table_file::mat {
namespace {

std::uint32_t size_of(std::string_view bytes) {
  if (bytes.size() > std::numeric_limits<std::int32_t>::max()) {
    throw text::Error{text::ErrorKind::bad_data,
                      "a MAT-file of version 5 has no room for more than 2 GB in a variable"};
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

}  // namespace fantail::table_file::mat
