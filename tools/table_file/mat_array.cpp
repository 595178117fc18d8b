// SPDX-License-Identifier: MIT
#include "table_file/mat_array.hpp"

#include <limits>
#include <optional>

#include <fmt/core.h>

#include "table_file/column.hpp"
#include "table_file/little_endian.hpp"
#include "table_file/mat_format.hpp"
#include "table_file/utf16.hpp"
#include "text/deflate.hpp"

namespace fantail::table_file::mat {
namespace {

struct Element {
  Stored stored;
  std::string_view bytes;
};

Element take(std::string_view& rest) {
  const auto type = get<std::uint32_t>(rest);
  if (!type || rest.size() < 8) {
    throw Damage{"it ends within a variable"};
  }
  constexpr std::uint32_t short_shift = 16;
  if (const std::uint32_t short_size = *type >> short_shift; short_size > 0) {  // four bytes at most, beside their type
    if (short_size > 4) {
      throw Damage{"a size in it cannot be"};
    }
    const std::string_view bytes = rest.substr(4, short_size);
    rest.remove_prefix(8);
    return {Stored{*type & 0xFFFFU}, bytes};
  }
  const std::size_t size = *get<std::uint32_t>(rest, 4);
  rest.remove_prefix(8);
  if (size > rest.size()) {
    throw Damage{"it ends within a variable"};
  }
  const std::string_view bytes = rest.substr(0, size);
  const std::size_t whole = Stored{*type} == Stored::compressed ? size : padded(size);
  rest.remove_prefix(std::min(whole, rest.size()));
  return {Stored{*type}, bytes};
}

Element take(std::string_view& rest, Stored wanted) {
  const Element element = take(rest);
  if (element.stored != wanted) {
    throw Damage{fmt::format("something of type {} stands where {} must", static_cast<unsigned>(element.stored),
                             static_cast<unsigned>(wanted))};
  }
  return element;
}

template <typename T>
std::vector<double> numbers_of(std::string_view bytes) {
  if (bytes.size() % sizeof(T) != 0) {
    throw Damage{"a list of numbers ends within a number"};
  }
  std::vector<double> list;
  list.reserve(bytes.size() / sizeof(T));
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(T)) {
    list.push_back(static_cast<double>(*get<T>(bytes, at)));
  }
  return list;
}

std::vector<double> numbers_of(const Element& element) {
  switch (element.stored) {
    case Stored::int8: return numbers_of<std::int8_t>(element.bytes);
    case Stored::uint8: return numbers_of<std::uint8_t>(element.bytes);
    case Stored::int16: return numbers_of<std::int16_t>(element.bytes);
    case Stored::uint16: return numbers_of<std::uint16_t>(element.bytes);
    case Stored::int32: return numbers_of<std::int32_t>(element.bytes);
    case Stored::uint32: return numbers_of<std::uint32_t>(element.bytes);
    case Stored::float32: return numbers_of<float>(element.bytes);
    case Stored::float64: return numbers_of<double>(element.bytes);
    case Stored::int64: return numbers_of<std::int64_t>(element.bytes);
    case Stored::uint64: return numbers_of<std::uint64_t>(element.bytes);
    default: throw Damage{fmt::format("numbers of type {} are none", static_cast<unsigned>(element.stored))};
  }
}

// In the order of the file, which is that of numbers: the first letter of each row, then the second of each.
std::u16string characters_of(const Element& element) {
  if (element.stored == Stored::utf8) {
    return utf16(element.bytes);
  }
  const Stored stored = element.stored == Stored::utf16 ? Stored::uint16 : element.stored;
  std::u16string all;
  for (const double code : numbers_of({stored, element.bytes})) {
    all += static_cast<char16_t>(static_cast<std::int64_t>(code));
  }
  return all;
}

class Parser {
 public:
  Array matrix(std::string_view bytes, int depth) {
    constexpr int deepest = 16;
    if (depth > deepest) {
      throw Damage{"its structs lie too deep in each other"};
    }
    const Element flags = take(bytes, Stored::uint32);
    const auto word = get<std::uint32_t>(flags.bytes);
    if (!word || flags.bytes.size() != 8) {
      throw Damage{"a variable has no class"};
    }
    const auto kind = static_cast<Class>(*word & 0xFFU);
    Array array = dimensioned(take(bytes, Stored::int32));
    array.name = take(bytes, Stored::int8).bytes;
    if (kind == Class::cell) {
      cell(array, bytes, depth);
    } else if (kind == Class::structure) {
      structure(array, bytes, depth);
    } else if (kind == Class::text) {
      text(array, bytes);
    } else if (kind >= Class::float64 && kind <= Class::uint64 && (*word & complex_flag) == 0) {
      array.content = Array::Content::numbers;
      array.numbers = numbers_of(take(bytes));
      require_count(array, array.numbers.size());
    } else {
      array.kind = kind == Class::sparse                             ? "a sparse matrix"
                   : kind >= Class::float64 && kind <= Class::uint64 ? "complex numbers"
                                                                     : "an object or a function";
    }
    return array;
  }

 private:
  static Array dimensioned(const Element& element) {
    const std::vector<double> sizes = numbers_of(element);
    constexpr double most = 1e12;  // far more than fit a file; a product of these is still exact
    double others = 1.0;
    for (std::size_t i = 1; i < sizes.size(); ++i) {
      others *= sizes[i];
    }
    if (sizes.size() < 2 || !(sizes[0] >= 0.0 && sizes[0] <= most && others >= 0.0 && others <= most)) {
      throw Damage{"a variable has no size"};
    }
    Array array;
    array.rows = static_cast<std::size_t>(sizes[0]);
    array.columns = static_cast<std::size_t>(others);
    return array;
  }

  static double count(const Array& array) {
    return static_cast<double>(array.rows) * static_cast<double>(array.columns);
  }

  static void require_count(const Array& array, std::size_t there) {
    if (count(array) != static_cast<double>(there)) {
      throw Damage{fmt::format("the variable \"{}\" has {} values where its size is {} x {}", array.name, there,
                               array.rows, array.columns)};
    }
  }

  void cell(Array& array, std::string_view bytes, int depth) {
    array.content = Array::Content::cell;
    while (!bytes.empty()) {
      array.elements.push_back(matrix_or_empty(take(bytes, Stored::matrix).bytes, depth));
    }
    require_count(array, array.elements.size());
  }

  // An empty array may be a bare tag.
  Array matrix_or_empty(std::string_view bytes, int depth) {
    return bytes.empty() ? Array{} : matrix(bytes, depth + 1);
  }

  void structure(Array& array, std::string_view bytes, int depth) {
    const auto name_size = get<std::int32_t>(take(bytes, Stored::int32).bytes);
    const std::string_view names = take(bytes, Stored::int8).bytes;
    if (!name_size || *name_size <= 0 || names.size() % static_cast<std::size_t>(*name_size) != 0) {
      throw Damage{"a struct has no names"};
    }
    const auto size = static_cast<std::size_t>(*name_size);
    std::vector<Array> members;
    while (!bytes.empty()) {
      members.push_back(matrix_or_empty(take(bytes, Stored::matrix).bytes, depth));
    }
    if (count(array) * static_cast<double>(names.size() / size) != static_cast<double>(members.size())) {
      throw Damage{fmt::format("the struct \"{}\" has not as many members as names", array.name)};
    }
    if (count(array) != 1.0) {
      array.kind = "an array of structs";  // events and the like: no table
      return;
    }
    array.content = Array::Content::structure;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::string_view name = names.substr(i * size, size);
      members[i].name = name.substr(0, name.find('\0'));
    }
    array.elements = std::move(members);
  }

  static void text(Array& array, std::string_view bytes) {
    const std::u16string all = characters_of(take(bytes));
    array.content = Array::Content::text;
    if (array.rows <= 1) {  // its size counts bytes or characters, as the writer likes
      array.lines.assign(array.rows, utf8(all));
      return;
    }
    require_count(array, all.size());
    for (std::size_t row = 0; row < array.rows; ++row) {
      std::u16string line;
      for (std::size_t at = row; at < all.size(); at += array.rows) {
        line += all[at];
      }
      line.resize(line.find_last_not_of(u' ') + 1);
      array.lines.push_back(utf8(line));
    }
  }
};

// What the file is instead, if it is known.
std::string other_kind(std::string_view file) {
  if (file.starts_with("MATLAB 7.3 MAT-file")) {
    return "it is of version 7.3 (HDF5), which Fantail does not read; save it with -v7";
  }
  if (file.starts_with("# Created by Octave")) {
    return "it is a text of Octave's; save it with -v7";
  }
  if (file.starts_with("Octave-1-")) {
    return "it is in Octave's own binary format; save it with -v7";
  }
  return "it is no MAT-file of version 5, which save -v7 and save -v6 write";
}

}  // namespace

std::vector<Array> read_arrays(std::string_view file) {
  if (file.empty()) {
    throw Damage{"it is empty"};
  }
  if (!file.starts_with(beginning)) {
    throw Damage{other_kind(file)};
  }
  const auto found_version = get<std::uint16_t>(file, header_size - 4);
  const auto found_order = get<std::uint16_t>(file, header_size - 2);
  if (!found_order) {
    throw Damage{"it ends within its header"};
  }
  if (*found_order != byte_order || *found_version != version) {
    throw Damage{"its header names another version, or a machine with the other order of bytes"};
  }
  std::vector<Array> arrays;
  std::size_t left = most_bytes;
  for (std::string_view rest = file.substr(header_size); !rest.empty();) {
    Element element = take(rest);
    std::optional<std::string> unpacked;
    if (element.stored == Stored::compressed) {
      unpacked = text::zlib_unpacked(element.bytes, left);
      if (!unpacked) {
        throw Damage{fmt::format("a packed variable is damaged, or has more than {} MB", most_bytes >> 20U)};
      }
      left -= unpacked->size();
      std::string_view inner = *unpacked;
      element = take(inner);
    }
    if (element.stored != Stored::matrix) {
      throw Damage{
          fmt::format("something of type {} stands where a variable must", static_cast<unsigned>(element.stored))};
    }
    arrays.push_back(Parser{}.matrix(element.bytes, 0));
  }
  return arrays;
}

}  // namespace fantail::table_file::mat
