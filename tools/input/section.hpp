// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/document.hpp"

namespace fantail::input {

struct Limits {
  double minimum;
  double maximum;
};

/// Reads one table (a section, or the top level with an empty name) key by key. Every key that is asked for counts as
/// known; finish() refuses the others, with a suggestion. All errors are text::Error, bad_configuration.
class Section {
 public:
  /// A section that is absent reads as empty.
  Section(const Document& document, std::string name);
  /// One table of an array of tables.
  Section(const Document& document, std::string name, TomlNode table);

  [[nodiscard]] bool is_there() const { return static_cast<bool>(table_); }
  [[nodiscard]] bool has(std::string_view key);

  // Refused when it is missing.
  [[nodiscard]] double number(std::string_view key, Limits limits);
  [[nodiscard]] std::int64_t integer(std::string_view key, Limits limits);
  [[nodiscard]] bool flag(std::string_view key);
  [[nodiscard]] std::string text(std::string_view key);
  /// The place of the word found.
  [[nodiscard]] std::size_t choice(std::string_view key, std::span<const std::string_view> words);

  // Empty when it is missing.
  [[nodiscard]] std::vector<double> numbers(std::string_view key, Limits limits, std::size_t most);
  [[nodiscard]] std::vector<std::size_t> choices(std::string_view key, std::span<const std::string_view> words,
                                                 std::size_t most);
  [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::size_t most);

  /// Refuses every key that nobody asked for.
  void finish() const;

  [[nodiscard]] std::string where(std::string_view key) const;
  [[nodiscard]] bool is_replaced(std::string_view key) const { return document_.is_replaced(name_, key); }

  /// For rules that span several keys. Throws text::Error.
  [[noreturn]] void refuse(std::string_view key, const std::string& complaint) const;

 private:
  TomlNode find(std::string_view key);
  TomlNode require(std::string_view key, const std::string& allowed = {});
  std::string checked_text(std::string_view key, TomlNode node) const;
  double checked_number(std::string_view key, TomlNode node, Limits limits) const;
  std::size_t checked_choice(std::string_view key, TomlNode node, std::span<const std::string_view> words) const;
  [[nodiscard]] std::string label(std::string_view key) const;

  const Document& document_;
  std::string name_;
  TomlNode table_;
  std::vector<std::string> known_;
};

/// Refuses sections (and top-level keys) that are not in `known`.
void refuse_unknown_sections(const Document& document, std::span<const std::string> known);

}  // namespace fantail::input
