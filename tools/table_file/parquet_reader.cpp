// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include <fmt/core.h>

#include "table_file/little_endian.hpp"
#include "table_file/parquet_format.hpp"
#include "table_file/parquet_page.hpp"
#include "table_file/read.hpp"
#include "table_file/thrift.hpp"
#include "text/error.hpp"

namespace fantail::table_file {
namespace {

using namespace parquet;
using thrift::Value;

constexpr std::string_view how_to_write =
    "Fantail reads plain values, packed with gzip or not at all: pandas and pyarrow write them with "
    "compression=\"gzip\", "
    "use_dictionary=False";

class ParquetReader {
 public:
  ParquetReader(std::string_view file, const std::string& name) : file_{file}, name_{name} {}

  Columns read() {
    const Value footer = this->footer();
    const Value& schema = list(footer, file_fields::schema);
    const std::int64_t rows = number(footer, file_fields::rows);
    if (schema.elements.empty() ||
        number(schema.elements[0], schema_fields::children) != static_cast<std::int64_t>(schema.elements.size()) - 1) {
      refuse("its columns lie in each other; only flat tables are read");
    }
    Columns columns;
    for (std::size_t i = 1; i < schema.elements.size(); ++i) {
      add_column(columns, schema.elements[i]);
    }
    for (const Value& group : list(footer, file_fields::row_groups).elements) {
      const Value& chunks = list(group, row_group_fields::columns);
      if (chunks.elements.size() != columns.size()) {
        damaged("a group of rows has not all columns");
      }
      for (std::size_t i = 0; i < columns.size(); ++i) {
        read_chunk(columns[i], schema.elements[i + 1], chunks.elements[i], number(group, row_group_fields::rows));
      }
    }
    for (const Column& column : columns) {
      if (static_cast<std::int64_t>(column.values.size()) != rows) {
        damaged(fmt::format("{} has {} values where there are {} rows", column.name, column.values.size(), rows));
      }
    }
    return columns;
  }

 private:
  [[noreturn]] void refuse(const std::string& complaint) const {
    throw text::Error{text::ErrorKind::bad_data, fmt::format("{}: {}", name_, complaint)};
  }
  [[noreturn]] void damaged(const std::string& complaint) const { refuse("is damaged: " + complaint); }
  [[noreturn]] void not_read(const Column& column, const std::string& complaint) const {
    refuse(fmt::format("{} is {}; {}", column.name, complaint, how_to_write));
  }

  [[nodiscard]] std::int64_t number(const Value& value, int field) const {
    const auto found = value.integer(field);
    return found ? *found : (damaged("its description lacks a number"), 0);
  }
  [[nodiscard]] const Value& list(const Value& value, int field) const {
    const Value* const found = value.find(field, thrift::Type::list);
    return found != nullptr ? *found : (damaged("its description lacks a list"), value);
  }

  [[nodiscard]] Value footer() const {
    constexpr std::size_t ends = 12;
    if (!file_.starts_with(magic)) {
      refuse("is no Parquet file");
    }
    if (file_.size() < ends || !file_.ends_with(magic)) {
      damaged("its end is missing");
    }
    const std::uint32_t size = *get<std::uint32_t>(file_, file_.size() - 8);
    if (size > file_.size() - ends) {
      damaged("its description is longer than the file");
    }
    const std::string_view description = file_.substr(file_.size() - 8 - size, size);
    std::string_view rest = description;
    auto footer = thrift::read(rest);
    if (!footer || !rest.empty()) {
      damaged("its description cannot be read");
    }
    require_checksum(*footer, description);
    return std::move(*footer);
  }

  // Other programs write none.
  void require_checksum(const Value& footer, std::string_view description) const {
    const Value* const pairs = footer.find(file_fields::key_values, thrift::Type::list);
    if (pairs == nullptr) {
      return;
    }
    for (const Value& pair : pairs->elements) {
      const Value* const key = pair.find(key_value_fields::key, thrift::Type::binary);
      const Value* const value = pair.find(key_value_fields::value, thrift::Type::binary);
      if (key != nullptr && key->bytes == checksum_key &&
          (value == nullptr || value->bytes != checksum_of(description, static_cast<std::size_t>(
                                                                            key->bytes.data() - description.data())))) {
        damaged("the checksum of its description is wrong");
      }
    }
  }

  void add_column(Columns& columns, const Value& schema) const {
    const Value* const name = schema.find(schema_fields::name, thrift::Type::binary);
    if (name == nullptr) {
      damaged("a column has no name");
    }
    Column column{.name = std::string{name->bytes}};
    const auto repetition = Repetition{static_cast<std::int8_t>(number(schema, schema_fields::repetition))};
    if (schema.integer(schema_fields::children) ||
        (repetition != Repetition::required && repetition != Repetition::optional)) {
      refuse(fmt::format("{} has columns within it; only flat tables are read", column.name));
    }
    switch (Type{static_cast<std::int8_t>(number(schema, schema_fields::type))}) {
      case Type::boolean: column.kind = Kind::flag; break;
      case Type::int32:
      case Type::int64: column.kind = Kind::integer; break;
      case Type::float32:
      case Type::float64: column.kind = Kind::number; break;
      case Type::bytes: column.kind = Kind::word; break;
      default: refuse(fmt::format("{} holds neither numbers nor flags nor texts", column.name));
    }
    // Integers of 8 to 64 bits without and with a sign, and texts; the others are times, dates and decimal fractions.
    constexpr int unsigned_8_bits = 11;
    constexpr int signed_64_bits = 18;
    if (const auto converted = schema.integer(schema_fields::converted_type);
        converted && column.kind != Kind::word && (*converted < unsigned_8_bits || *converted > signed_64_bits)) {
      refuse(fmt::format("{} holds times, dates or decimal fractions, and must hold numbers", column.name));
    }
    const Value* const logical = schema.find(schema_fields::logical_type, thrift::Type::structure);
    constexpr int integers = 10;
    if (logical != nullptr && column.kind == Kind::integer &&
        logical->find(integers, thrift::Type::structure) == nullptr) {
      refuse(fmt::format("{} holds times, dates or decimal fractions, and must hold numbers", column.name));
    }
    columns.push_back(std::move(column));
  }

  void read_chunk(Column& column, const Value& schema, const Value& chunk, std::int64_t rows) {
    const Value* const about = chunk.find(chunk_fields::about, thrift::Type::structure);
    if (about == nullptr) {
      damaged("a column is not described");
    }
    // The type stands in two places: one that is damaged would turn numbers into others.
    const Value& path = list(*about, column_fields::path);
    if (number(*about, column_fields::type) != number(schema, schema_fields::type) || path.elements.size() != 1 ||
        path.elements[0].bytes != column.name) {
      damaged(column.name + " is described in two ways");
    }
    const auto codec = Codec{static_cast<std::int8_t>(number(*about, column_fields::codec))};
    if (codec != Codec::none && codec != Codec::gzip) {
      not_read(column, "packed by other means than gzip");
    }
    if (about->integer(column_fields::dictionary_offset)) {
      not_read(column, "encoded by a dictionary");
    }
    const std::int64_t offset = number(*about, column_fields::data_offset);
    if (offset < 0 || static_cast<std::uint64_t>(offset) > file_.size()) {
      damaged(column.name + " lies outside of the file");
    }
    std::string_view rest = file_.substr(static_cast<std::size_t>(offset));
    const bool optional = number(schema, schema_fields::repetition) == static_cast<int>(Repetition::optional);
    const PageReader reader{{.type = Type{static_cast<std::int8_t>(number(schema, schema_fields::type))},
                             .codec = codec,
                             .optional = optional,
                             .without_sign = has_no_sign(schema)}};
    const std::size_t before = column.values.size();
    const auto wanted = static_cast<std::uint64_t>(rows);
    while (column.values.size() - before < wanted) {
      if (const PageFault fault = reader.read(rest, column, unpacked_left_); !fault.complaint.empty()) {
        fault.is_damage ? damaged(fmt::format("{}: {}", column.name, fault.complaint))
                        : not_read(column, fault.complaint);
      }
    }
    if (column.values.size() - before != wanted) {
      damaged(column.name + " has more values than rows");
    }
  }

  static bool has_no_sign(const Value& schema) {
    const auto converted = schema.integer(schema_fields::converted_type);
    return converted && *converted >= 11 && *converted <= 14;
  }

  std::string_view file_;
  std::string name_;
  std::size_t unpacked_left_ = most_bytes;
};

}  // namespace

Columns read_parquet(std::string_view file, const std::string& name) { return ParquetReader{file, name}.read(); }

}  // namespace fantail::table_file
