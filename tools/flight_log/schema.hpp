// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::flight_log {

enum class FieldType : std::uint8_t { unsigned_number, signed_number, real_number };

/// One value of a record, as a log's own schema describes it (protocol/log_schema.hpp).
struct SchemaField {
  std::string name;
  std::string unit;  ///< empty: none
  FieldType type = FieldType::unsigned_number;
  std::size_t offset = 0;
  std::size_t bytes = 0;   ///< 1, 2, 4 or 8
  unsigned first_bit = 0;  ///< of an unsigned number that shares its bytes with others
  unsigned bits = 0;       ///< 0: all of them
};

struct SchemaRecord {
  std::string name;
  std::size_t size = 0;
  std::vector<SchemaField> fields;

  [[nodiscard]] const SchemaField* find(std::string_view field) const;
};

/// The records of a schema. Lines that this version does not understand are left out: a later one may know more types.
[[nodiscard]] std::vector<SchemaRecord> parse_schema(std::string_view text);

/// Null when the schema has no such record.
[[nodiscard]] const SchemaRecord* find_record(std::span<const SchemaRecord> schema, std::string_view name);

/// What a payload holds there; empty when it is too short. Every type but a number of 64 bits keeps all its digits.
[[nodiscard]] std::optional<double> value(const SchemaField& field, std::span<const std::byte> payload);

}  // namespace fantail::flight_log
