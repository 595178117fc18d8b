// SPDX-License-Identifier: MIT
#include "flight_log/schema.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>

#include "protocol/little_endian.hpp"
#include "text/quoting.hpp"

namespace fantail::flight_log {
namespace {

// Cuts off and returns what comes before `end`.
std::string_view take(std::string_view& text, char end) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string_view part = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return part;
}

template <typename Number>
std::optional<Number> number(std::string_view text) {
  Number result{};
  const char* const begin = text.data();
  const char* const end = begin + text.size();
  const auto [stopped, error] = std::from_chars(begin, end, result);
  return error == std::errc{} && stopped == end ? std::optional{result} : std::nullopt;
}

struct Type {
  std::string_view name;
  FieldType type;
  std::size_t bytes;
};
constexpr std::array types{
    Type{"u8", FieldType::unsigned_number, 1},  Type{"u16", FieldType::unsigned_number, 2},
    Type{"u32", FieldType::unsigned_number, 4}, Type{"u64", FieldType::unsigned_number, 8},
    Type{"i8", FieldType::signed_number, 1},    Type{"i16", FieldType::signed_number, 2},
    Type{"i32", FieldType::signed_number, 4},   Type{"i64", FieldType::signed_number, 8},
    Type{"f32", FieldType::real_number, 4},     Type{"f64", FieldType::real_number, 8},
};

// "u16:9.3"
bool read_type(std::string_view text, SchemaField& field) {
  const std::string_view name = take(text, ':');
  const auto* const type = std::ranges::find(types, name, &Type::name);
  if (type == types.end()) {
    return false;
  }
  field.type = type->type;
  field.bytes = type->bytes;
  if (text.empty()) {
    return true;
  }
  const auto first = number<unsigned>(take(text, '.'));
  const auto bits = number<unsigned>(text);
  if (!first || !bits || type->type != FieldType::unsigned_number || *bits == 0 || *first >= 8 * type->bytes ||
      *bits > 8 * type->bytes - *first) {
    return false;
  }
  field.first_bit = *first;
  field.bits = *bits;
  return true;
}

// "0 u16:9.3 name unit"
std::optional<SchemaField> read_field(std::string_view line, std::size_t record_size) {
  SchemaField field;
  const auto offset = number<std::size_t>(take(line, ' '));
  if (!offset || !read_type(take(line, ' '), field) || *offset > record_size || field.bytes > record_size - *offset) {
    return std::nullopt;
  }
  field.offset = *offset;
  field.name = text::printable(take(line, ' '));
  field.unit = text::printable(line);
  return field.name.empty() ? std::nullopt : std::optional{field};
}

std::uint64_t bytes_at(const SchemaField& field, std::span<const std::byte> payload) {
  switch (field.bytes) {
    case 1: return protocol::get<1>(payload, field.offset);
    case 2: return protocol::get<2>(payload, field.offset);
    case 4: return protocol::get<4>(payload, field.offset);
    default: return protocol::get<8>(payload, field.offset);
  }
}

double signed_value(std::uint64_t word, std::size_t bytes) {
  const auto unused = static_cast<unsigned>(64 - 8 * bytes);
  return static_cast<double>(static_cast<std::int64_t>(word << unused) >> unused);
}

}  // namespace

const SchemaField* SchemaRecord::find(std::string_view field) const {
  const auto found = std::ranges::find(fields, field, &SchemaField::name);
  return found == fields.end() ? nullptr : &*found;
}

std::vector<SchemaRecord> parse_schema(std::string_view text) {
  std::vector<SchemaRecord> records;
  bool known = false;  // whether the lines here belong to a record that was understood
  while (!text.empty()) {
    const std::string_view line = take(text, '\n');
    if (line.empty()) {
      continue;
    }
    if (line.front() >= '0' && line.front() <= '9') {
      if (const auto field = known ? read_field(line, records.back().size) : std::nullopt) {
        records.back().fields.push_back(*field);
      }
      continue;
    }
    std::string_view rest = line;
    const std::string_view name = take(rest, ' ');
    const auto size = number<std::size_t>(rest);
    known = size.has_value();
    if (known) {
      records.push_back({.name = text::printable(name), .size = *size, .fields = {}});
    }
  }
  return records;
}

const SchemaRecord* find_record(std::span<const SchemaRecord> schema, std::string_view name) {
  const auto found = std::ranges::find(schema, name, &SchemaRecord::name);
  return found == schema.end() ? nullptr : &*found;
}

std::optional<double> value(const SchemaField& field, std::span<const std::byte> payload) {
  if (field.offset > payload.size() || field.bytes > payload.size() - field.offset) {
    return std::nullopt;
  }
  const std::uint64_t word = bytes_at(field, payload);
  switch (field.type) {
    case FieldType::signed_number: return signed_value(word, field.bytes);
    case FieldType::real_number:
      return field.bytes == 8 ? std::bit_cast<double>(word)
                              : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(word)));
    case FieldType::unsigned_number: break;
  }
  const std::uint64_t mask =
      field.bits == 0 || field.bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << field.bits) - 1;
  return static_cast<double>((word >> field.first_bit) & mask);
}

}  // namespace fantail::flight_log
