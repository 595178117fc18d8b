// SPDX-License-Identifier: MIT
#include "table_file/parquet_page.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "table_file/little_endian.hpp"
#include "table_file/thrift.hpp"
#include "text/deflate.hpp"

namespace fantail::table_file::parquet {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_rows = most_bytes / 8;

bool bit(std::string_view bytes, std::size_t at) {
  return (static_cast<unsigned char>(bytes[at / 8]) >> at % 8 & 1U) != 0;
}

std::optional<std::uint32_t> run_head(std::string_view& runs) {
  std::uint32_t head = 0;
  for (unsigned shift = 0; shift < 32 && !runs.empty(); shift += 7) {
    const auto part = static_cast<unsigned char>(runs.front());
    runs.remove_prefix(1);
    head |= (part & 0x7FU) << shift;
    if (part < 0x80) {
      return head;
    }
  }
  return {};
}

// Which of `count` values are there, from runs of the same and runs of bits. Empty: damaged.
std::optional<std::vector<bool>> known_values(std::string_view runs, std::size_t count) {
  std::vector<bool> known;
  while (known.size() < count) {
    const auto head = run_head(runs);
    if (!head || *head < 2 || runs.empty()) {
      return {};
    }
    const std::size_t size = *head >> 1U;
    if ((*head & 1U) == 0) {
      if (size > count - known.size() || static_cast<unsigned char>(runs.front()) > 1) {
        return {};
      }
      known.insert(known.end(), size, runs.front() != 0);
      runs.remove_prefix(1);
    } else {  // eight to the byte, of which the last may be filled up
      if (size > runs.size()) {
        return {};
      }
      for (std::size_t i = 0; i < 8 * size && known.size() < count; ++i) {
        known.push_back(bit(runs, i));
      }
      runs.remove_prefix(size);
    }
  }
  return known;
}

template <typename T>
std::optional<double> number(std::string_view& rest) {
  const auto value = get<T>(rest);
  if (!value) {
    return {};
  }
  rest.remove_prefix(sizeof(T));
  return static_cast<double>(*value);
}

// The place of a text among those of its column.
std::optional<double> word(std::string_view& rest, Column& column) {
  const auto size = get<std::uint32_t>(rest);
  if (!size || *size > rest.size() - sizeof *size) {
    return {};
  }
  const std::string_view text = rest.substr(sizeof *size, *size);
  rest.remove_prefix(sizeof *size + *size);
  const auto found = std::ranges::find(column.words, text);
  const auto place = static_cast<double>(found - column.words.begin());
  if (found == column.words.end()) {
    column.words.emplace_back(text);
  }
  return place;
}

}  // namespace

PageFault PageReader::read(std::string_view& rest, Column& column, std::size_t& most) const {
  const auto header = thrift::read(rest);
  if (!header) {
    return {"a page has no header"};
  }
  if (header->integer(page_fields::type) != data_page) {
    return {.complaint = "written in pages of another version or with a dictionary", .is_damage = false};
  }
  const thrift::Value* const data = header->find(page_fields::data, thrift::Type::structure);
  const auto packed_size = header->integer(page_fields::bytes_packed);
  const auto unpacked_size = header->integer(page_fields::bytes_unpacked);
  if (data == nullptr || !packed_size || !unpacked_size || *packed_size < 0 || *unpacked_size < 0 ||
      static_cast<std::uint64_t>(*packed_size) > rest.size()) {
    return {"a page is longer than the file, or of no length"};
  }
  const std::string_view packed = rest.substr(0, static_cast<std::size_t>(*packed_size));
  rest.remove_prefix(packed.size());
  const auto crc = header->integer(page_fields::crc);
  if (crc && static_cast<std::uint32_t>(*crc) != text::crc32(packed)) {
    return {"the checksum of a page is wrong"};
  }
  const auto values = data->integer(data_page_fields::values);
  if (!values || *values <= 0 || static_cast<std::uint64_t>(*values) > most_rows) {
    return {"a page has no number of values that can be"};
  }
  if (data->integer(data_page_fields::encoding) != static_cast<int>(Encoding::plain) ||
      (form_.optional && data->integer(data_page_fields::definition_encoding) != static_cast<int>(Encoding::rle))) {
    return {.complaint = "not written as plain values", .is_damage = false};
  }
  const auto count = static_cast<std::size_t>(*values);
  const std::size_t size = std::max(static_cast<std::size_t>(*unpacked_size), count * sizeof(double));
  if (size > most) {
    return {"with it the file has more than the log of a flight"};
  }
  most -= size;
  if (form_.codec == Codec::none) {
    return add(packed, count, column);
  }
  const auto content = text::gunzip(packed, static_cast<std::size_t>(*unpacked_size));
  if (!content || content->size() != static_cast<std::size_t>(*unpacked_size)) {
    return {"a page cannot be unpacked"};
  }
  return add(*content, count, column);
}

PageFault PageReader::add(std::string_view content, std::size_t count, Column& column) const {
  std::vector<bool> known(count, true);
  if (form_.optional) {
    const auto size = get<std::uint32_t>(content);
    if (!size || *size > content.size() - sizeof *size) {
      return {"a page does not say which values it has"};
    }
    auto found = known_values(content.substr(sizeof *size, *size), count);
    if (!found) {
      return {"a page does not say which values it has"};
    }
    known = std::move(*found);
    content.remove_prefix(sizeof *size + *size);
  }
  std::size_t bits = 0;
  for (const bool is_known : known) {
    std::optional<double> value = unknown;
    if (is_known) {
      switch (form_.type) {
        case Type::boolean:
          value = bits / 8 < content.size() ? std::optional{bit(content, bits) ? 1.0 : 0.0} : std::nullopt;
          ++bits;
          break;
        case Type::int32:
          value = form_.without_sign ? number<std::uint32_t>(content) : number<std::int32_t>(content);
          break;
        case Type::int64:
          value = form_.without_sign ? number<std::uint64_t>(content) : number<std::int64_t>(content);
          break;
        case Type::float32: value = number<float>(content); break;
        case Type::float64: value = number<double>(content); break;
        case Type::bytes: value = word(content, column); break;
      }
    }
    if (!value) {
      return {"a page has too few values"};
    }
    column.values.push_back(*value);
  }
  if (content.size() != (bits + 7) / 8) {
    return {"a page has too many values"};
  }
  return {};
}

}  // namespace fantail::table_file::parquet
