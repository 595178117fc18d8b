// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "input/toml_tree.hpp"

namespace fantail::input {

/// One `--set section.key=value`.
struct Override {
  std::string section;
  std::string key;
  std::string value;
  [[nodiscard]] std::string text() const { return "--set " + section + "." + key + "=" + value; }
};

/// Throws text::Error (bad_configuration) unless it reads section.key=value.
[[nodiscard]] Override parse_override(std::string_view text);

/// A TOML file in which every value remembers where it came from: its line, or the --set that replaced it.
class Document {
 public:
  /// Throws text::Error: no_such_input, or bad_data with file:line:column.
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

}  // namespace fantail::input
