// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Thrift's compact protocol, in which Parquet describes itself: structs of numbered fields.
namespace fantail::table_file::thrift {

enum class Type : std::uint8_t {
  yes = 1,
  no = 2,
  int8 = 3,
  int16 = 4,
  int32 = 5,
  int64 = 6,
  binary = 8,
  list = 9,
  structure = 12
};

/// Writes one struct, fields in rising order.
class Writer {
 public:
  void integer(int field, std::int64_t value, Type type);
  void int32(int field, std::int64_t value) { integer(field, value, Type::int32); }
  void int64(int field, std::int64_t value) { integer(field, value, Type::int64); }
  void binary(int field, std::string_view bytes);
  void structure(int field, const Writer& inner);
  void structures(int field, const std::vector<Writer>& list);
  void binaries(int field, const std::vector<std::string>& list);
  void int32s(int field, const std::vector<std::int32_t>& list);

  /// With its end.
  [[nodiscard]] std::string bytes() const { return bytes_ + '\0'; }

 private:
  void head(int field, Type type);
  void list(int field, Type type, std::size_t count);
  void unsigned_number(std::uint64_t value);
  void number(std::int64_t value);

  std::string bytes_;
  int last_field_ = 0;
};

/// One value that was read. A struct has `members`, a list `elements`.
struct Value {
  Type type = Type::structure;
  std::int64_t number = 0;
  std::string_view bytes{};  ///< of what was read from
  std::vector<Value> elements{};
  std::vector<std::pair<int, Value>> members{};

  /// Null: it has no such field, or one of another type.
  [[nodiscard]] const Value* find(int field, Type wanted) const;
  [[nodiscard]] std::optional<std::int64_t> integer(int field) const;  ///< of 32 or 64 bits
};

/// The struct at the front of `rest`, which it is taken off. Empty for what is none.
[[nodiscard]] std::optional<Value> read(std::string_view& rest);

}  // namespace fantail::table_file::thrift
