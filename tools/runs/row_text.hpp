// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace fantail::runs {

/// Rows as text and back, bit for bit: numbers with every digit, a text behind its length, each with a space behind it.
/// What a row consists of is said once, for both ways, beside it:
///   void fields(runs::RowText& text, Row& row) { text(row.seed, row.margin_rad, row.notes); }
/// Fields are numbers, words, and lists, maps and optionals of them, and other rows.
class RowText {
 public:
  /// To write into.
  RowText() = default;
  /// To read from. What is no such text leaves the rest as it is.
  explicit RowText(std::string_view text) : reads_{true}, left_{text} {}

  template <typename... Fields>
  void operator()(Fields&... all) {
    (each(all), ...);
  }
  /// What was written.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// All was read, and well.
  [[nodiscard]] bool is_read() const { return is_well_ && left_.empty(); }

 private:
  template <typename Field>
  void each(Field& field) {
    if constexpr (std::is_enum_v<Field> || std::is_same_v<Field, bool>) {
      auto whole = static_cast<int>(field);
      number(whole);
      field = static_cast<Field>(whole);
    } else if constexpr (std::is_arithmetic_v<Field>) {
      number(field);
    } else {
      fields(*this, field);
    }
  }
  void each(std::string& text) {
    const std::size_t size = count(text.size());
    if (reads_) {
      text = left_.substr(0, size);
      left_.remove_prefix(std::min(left_.size(), size + 1));
    } else {
      text_ += text + ' ';
    }
  }
  template <typename Field>
  void each(std::optional<Field>& field) {
    bool is_there = field.has_value();
    each(is_there);
    if (reads_) {
      field = is_there ? std::optional{Field{}} : std::nullopt;
    }
    if (field) {
      each(*field);
    }
  }
  template <typename Field>
  void each(std::vector<Field>& list) {
    list.resize(count(list.size()));
    std::ranges::for_each(list, [this](Field& field) { each(field); });
  }
  template <typename Field, std::size_t size>
  void each(std::array<Field, size>& list) {
    std::ranges::for_each(list, [this](Field& field) { each(field); });
  }
  template <typename Field>
  void each(std::map<int, Field>& map) {
    std::vector<std::pair<int, Field>> pairs{map.begin(), map.end()};
    pairs.resize(count(pairs.size()));
    for (auto& [key, field] : pairs) {
      each(key);
      each(field);
    }
    map = {pairs.begin(), pairs.end()};
  }

  template <typename Number>
  void number(Number& value) {
    if (!reads_) {
      fmt::format_to(std::back_inserter(text_), "{} ", value);
      return;
    }
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), value);
    const auto length = static_cast<std::size_t>(end - left_.data());
    is_well_ = is_well_ && error == std::errc{} && length < left_.size() && left_[length] == ' ';
    left_.remove_prefix(is_well_ ? length + 1 : left_.size());
  }
  /// Of things that take a character each, at least: what has no room for them is refused.
  std::size_t count(std::size_t size) {
    number(size);
    is_well_ = is_well_ && (!reads_ || size <= left_.size());
    return is_well_ ? size : 0;
  }

  bool reads_ = false;
  bool is_well_ = true;
  std::string text_{};
  std::string_view left_{};
};

/// False when the text is not that of so many rows.
template <typename Row>
[[nodiscard]] bool read_rows(std::string_view text, std::vector<Row>& rows) {
  RowText reader{text};
  for (Row& row : rows) {
    reader(row);
  }
  return reader.is_read();
}

}  // namespace fantail::runs
