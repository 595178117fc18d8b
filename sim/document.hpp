// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/toml_tree.hpp"

namespace fantail::sim {

/// One `--set section.key=value`.
struct Override {
  std::string section;
  std::string key;
  std::string value;
  [[nodiscard]] std::string text() const { return "--set " + section + "." + key + "=" + value; }
};

/// Throws InputError (bad_configuration) unless it reads section.key=value.
[[nodiscard]] Override parse_override(std::string_view text);

/// A TOML file in which every value remembers where it came from: its line, or the --set that replaced it.
class Document {
 public:
  /// Throws InputError: no_such_input, or bad_data with file:line:column.
  [[nodiscard]] static Document load(const std::string& file);

  /// Replaces or adds one value. The value is read as TOML; what is not TOML is a string.
  void apply(const Override& change);

  [[nodiscard]] TomlNode root() const { return tree_.root(); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// Was this value given by a --set?
  [[nodiscard]] bool is_replaced(std::string_view section, std::string_view key) const;

  /// "file:line" of a value, "--set ..." when it was replaced, or the file alone.
  [[nodiscard]] std::string where(std::string_view section, std::string_view key, TomlNode node) const;

 private:
  std::string file_;
  TomlTree tree_;
  std::map<std::string, std::string, std::less<>> replaced_;
};

/// The one of `known` that a person most likely meant; empty when none is near.
[[nodiscard]] std::optional<std::string> suggestion(std::string_view wrong, std::span<const std::string> known);

struct Limits {
  double minimum;
  double maximum;
};

/// Reads one table (a section, or the top level with an empty name) key by key. Every key that is asked for counts as
/// known; finish() refuses the others, with a suggestion. All errors are InputError, bad_configuration.
class Section {
 public:
  /// A section that is absent reads as empty.
  Section(const Document& document, std::string name);
  /// One table of an array of tables.
  Section(const Document& document, std::string name, TomlNode table);

  [[nodiscard]] bool has(std::string_view key);
  [[nodiscard]] double number(std::string_view key, Limits limits, std::optional<double> otherwise = {});
  [[nodiscard]] std::int64_t integer(std::string_view key, Limits limits, std::optional<std::int64_t> otherwise = {});
  [[nodiscard]] bool flag(std::string_view key, std::optional<bool> otherwise = {});
  [[nodiscard]] std::string text(std::string_view key, std::optional<std::string> otherwise = {});
  /// The index of the word found.
  [[nodiscard]] std::size_t choice(std::string_view key, std::span<const std::string_view> words,
                                   std::optional<std::size_t> otherwise = {});
  [[nodiscard]] std::vector<double> numbers(std::string_view key, Limits limits, std::size_t most);
  [[nodiscard]] std::vector<std::size_t> choices(std::string_view key, std::span<const std::string_view> words,
                                                 std::size_t most);
  [[nodiscard]] std::vector<std::string> texts(std::string_view key, std::size_t most);

  /// Refuses every key that nobody asked for.
  void finish() const;

  [[nodiscard]] std::string where(std::string_view key) const;
  [[nodiscard]] bool is_replaced(std::string_view key) const { return document_.is_replaced(name_, key); }

  /// For rules that span several keys.
  [[noreturn]] void refuse(std::string_view key, const std::string& complaint) const;

 private:
  TomlNode find(std::string_view key);
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

}  // namespace fantail::sim
