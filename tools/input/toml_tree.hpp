// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::input {

// toml++ takes seconds to compile; toml_tree.cpp is the one file that sees it.

/// A value in a TomlTree, or none. It points into the tree, and is good for as long as that value is not replaced.
class TomlNode {
 public:
  TomlNode() = default;  ///< none
  [[nodiscard]] explicit operator bool() const { return node_ != nullptr; }

  /// What a table has by this name; none when it has nothing, or when this is no table.
  [[nodiscard]] TomlNode operator[](std::string_view key) const;
  [[nodiscard]] bool is_table() const;
  [[nodiscard]] std::vector<std::string> keys() const;  ///< of a table, sorted; of all else there are none

  // Empty when there is none, or it is of another kind. A date is of none of these kinds.
  [[nodiscard]] std::optional<bool> flag() const;
  [[nodiscard]] std::optional<std::int64_t> integer() const;
  [[nodiscard]] std::optional<double> number() const;  ///< an integer is one, too
  [[nodiscard]] std::optional<std::string> text() const;
  [[nodiscard]] std::optional<std::vector<TomlNode>> elements() const;

  /// Where it begins; zero when that is in no file.
  [[nodiscard]] std::size_t line() const;

  /// As TOML, on one line whatever it is, and not longer than a message can bear. There must be a value.
  [[nodiscard]] std::string as_text() const;

 private:
  friend class TomlTree;
  explicit TomlNode(const void* node) : node_{node} {}

  const void* node_ = nullptr;  // toml::node
};

/// Everything that one TOML file says.
class TomlTree {
 public:
  TomlTree();  ///< nothing
  /// Of the text of a file, whose name is for messages. Throws text::Error (bad_data) with file:line:column.
  [[nodiscard]] static TomlTree parse(const std::string& text, const std::string& file);

  [[nodiscard]] TomlNode root() const;

  /// Replaces or adds one value. `table` is a table at the root, or is not there yet. The value is read as TOML; what
  /// is not TOML is a string.
  void put(const std::string& table, const std::string& key, const std::string& value);

 private:
  struct Root;
  struct Destroy {
    void operator()(Root* root) const;
  };
  std::unique_ptr<Root, Destroy> root_;
};

}  // namespace fantail::input
