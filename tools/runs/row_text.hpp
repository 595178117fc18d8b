// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

namespace fantail::runs {

// A row as text and back, bit for bit. What a row consists of is said once, beside it, for both ways:
//   template <typename Text> void fields(Text& text, Row& row) { text(row.seed, row.margin_rad, row.notes); }
// Fields are numbers, words, and lists, maps or optionals of them, and other rows.

/// Makes the text: numbers with every digit, a text behind its length, each with a space behind it.
class RowText {
 public:
  template <typename... Fields>
  void operator()(Fields&... all) {
    (put(all), ...);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  template <typename Row>
  void put(Row& row) {
    if constexpr (std::is_enum_v<Row>) {
      put_number(static_cast<int>(row));
    } else if constexpr (std::is_same_v<Row, bool>) {
      put_number(row ? 1 : 0);
    } else if constexpr (std::is_arithmetic_v<Row>) {
      put_number(row);
    } else {
      fields(*this, row);
    }
  }
  void put(std::string& text) {
    put_number(text.size());
    text_ += text + ' ';
  }
  template <typename Value>
  void put(std::optional<Value>& value) {
    put_number(value ? 1 : 0);
    if (value) {
      put(*value);
    }
  }
  template <typename Value>
  void put(std::vector<Value>& values) {
    put_number(values.size());
    for (Value& value : values) {
      put(value);
    }
  }
  template <typename Value, std::size_t count>
  void put(std::array<Value, count>& values) {
    for (Value& value : values) {
      put(value);
    }
  }
  template <typename Value>
  void put(std::map<int, Value>& values) {
    put_number(values.size());
    for (auto& [key, value] : values) {
      put_number(key);
      put(value);
    }
  }
  template <typename Number>
  void put_number(Number number) {
    fmt::format_to(std::back_inserter(text_), "{} ", number);
  }

  std::string text_;
};

/// The other way. What is no such text leaves the rest as it is, and the reader not well.
class RowReader {
 public:
  explicit RowReader(std::string_view text) : left_{text} {}

  template <typename... Fields>
  void operator()(Fields&... all) {
    (take(all), ...);
  }
  /// All of it was read.
  [[nodiscard]] bool is_done() const { return is_well_ && left_.empty(); }

 private:
  template <typename Row>
  void take(Row& row) {
    if constexpr (std::is_enum_v<Row>) {
      row = static_cast<Row>(number<int>());
    } else if constexpr (std::is_same_v<Row, bool>) {
      row = number<int>() != 0;
    } else if constexpr (std::is_arithmetic_v<Row>) {
      row = number<Row>();
    } else {
      fields(*this, row);
    }
  }
  void take(std::string& text) {
    const std::size_t size = count();
    text = left_.substr(0, size);
    left_.remove_prefix(std::min(left_.size(), size + 1));
  }
  template <typename Value>
  void take(std::optional<Value>& value) {
    value.reset();
    if (number<int>() != 0) {
      take(value.emplace());
    }
  }
  template <typename Value>
  void take(std::vector<Value>& values) {
    values.assign(count(), Value{});
    for (Value& value : values) {
      take(value);
    }
  }
  template <typename Value, std::size_t size>
  void take(std::array<Value, size>& values) {
    for (Value& value : values) {
      take(value);
    }
  }
  template <typename Value>
  void take(std::map<int, Value>& values) {
    values.clear();
    for (std::size_t left = count(); left > 0 && is_well_; --left) {
      const int key = number<int>();
      take(values[key]);
    }
  }

  template <typename Number>
  Number number() {
    Number value{};
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    const auto length = static_cast<std::size_t>(end - left_.data());
    is_well_ = is_well_ && error == std::errc{} && length < left_.size() && left_[length] == ' ';
    left_.remove_prefix(is_well_ ? length + 1 : left_.size());
    return value;
  }
  /// Of things that take a character each, at least: what has no room for them is not believed.
  std::size_t count() {
    const auto wanted = number<std::size_t>();
    is_well_ = is_well_ && wanted <= left_.size();
    return is_well_ ? wanted : 0;
  }

  std::string_view left_;
  bool is_well_ = true;
};

/// False when the text is not that of so many rows.
template <typename Row>
[[nodiscard]] bool read_rows(std::string_view text, Row* rows, std::size_t count) {
  RowReader reader{text};
  for (std::size_t i = 0; i < count; ++i) {
    reader(rows[i]);
  }
  return reader.is_done();
}

}  // namespace fantail::runs
