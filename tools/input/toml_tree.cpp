// SPDX-License-Identifier: MIT
#include "input/toml_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/core.h>

// A result says what is wrong; the parser has no need to throw it.
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

#include "text/error.hpp"

namespace fantail::input {
namespace {

const toml::node* node_of(const void* node) { return static_cast<const toml::node*>(node); }

template <typename Kind>
const auto* as(const void* node) {
  return node == nullptr ? nullptr : node_of(node)->as<Kind>();
}

template <typename Value>
std::optional<Value> value_of(const void* node) {
  const auto* value = as<Value>(node);
  return value == nullptr ? std::nullopt : std::optional<Value>{value->get()};
}

// Where a string ends that begins at `at`; the place of what may not be in it, or the end of the text, ends it too.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool is_long = text.substr(at).starts_with(std::string(3, quote));
  for (std::size_t i = at + (is_long ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
      if (i < text.size() && static_cast<unsigned char>(text[i]) >= 0x80) {
        return i;
      }
    } else if (text[i] == quote && (!is_long || text.substr(i).starts_with(std::string(3, quote)))) {
      i += is_long ? 3 : 1;
      while (is_long && i < text.size() && text[i] == quote) {  // up to two more are its last characters
        ++i;
      }
      return i;
    } else if (text[i] == '\n' && !is_long) {
      return i;
    }
  }
  return text.size();
}

// The first character that is not ASCII outside of strings and comments, where TOML has none. To toml++ 3.3 one of
// U+00A1 to U+0499 there is undefined behaviour: it asks whether that is white space. A quote begins a string where a
// key or a value may begin; anywhere else toml++ reads on over it.
std::optional<std::size_t> foreign_character(std::string_view text) {
  char before = '\n';       // the last one that is no blank
  bool has_equals = false;  // in this line
  std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (i < text.size()) {
    const char now = text[i];
    const bool may_begin =
        std::string_view{"\n=[,{"}.find(before) != std::string_view::npos || (before == '.' && !has_equals);
    if (static_cast<unsigned char>(now) >= 0x80) {
      return i;
    }
    if (now == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    has_equals = now != '\n' && (has_equals || now == '=');
    i = (now == '"' || now == '\'') && may_begin ? end_of_string(text, i) : i + 1;
    before = now == ' ' || now == '\t' || now == '\r' ? before : now;
  }
  return std::nullopt;
}

void refuse_foreign_characters(const std::string& text, const std::string& file) {
  if (const auto at = foreign_character(text)) {
    const auto before = std::string_view{text}.substr(0, *at);
    const std::size_t line_begin = before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
    throw text::Error{
        text::ErrorKind::bad_data,
        fmt::format("{}:{}:{}: not valid TOML: a character that is not ASCII, outside of quotes and comments", file,
                    std::ranges::count(before, '\n') + 1, *at - line_begin + 1)};
  }
}

std::string describe(const toml::parse_error& error, const std::string& file) {
  std::ostringstream text;
  text << file << ':' << error.source().begin.line << ':' << error.source().begin.column
       << ": not valid TOML: " << error.description();
  return text.str();
}

}  // namespace

TomlNode TomlNode::operator[](std::string_view key) const {
  const auto* table = as<toml::table>(node_);
  return TomlNode{table == nullptr ? nullptr : table->get(key)};
}

bool TomlNode::is_table() const { return as<toml::table>(node_) != nullptr; }

std::vector<std::string> TomlNode::keys() const {
  std::vector<std::string> keys;
  if (const auto* table = as<toml::table>(node_)) {
    for (const auto& [key, node] : *table) {
      keys.emplace_back(key.str());
    }
  }
  return keys;
}

std::optional<bool> TomlNode::flag() const { return value_of<bool>(node_); }

std::optional<std::int64_t> TomlNode::integer() const { return value_of<std::int64_t>(node_); }

std::optional<double> TomlNode::number() const {
  const std::optional<std::int64_t> whole = integer();
  return whole ? static_cast<double>(*whole) : value_of<double>(node_);
}

std::optional<std::string> TomlNode::text() const { return value_of<std::string>(node_); }

std::optional<std::vector<TomlNode>> TomlNode::elements() const {
  const auto* array = as<toml::array>(node_);
  if (array == nullptr) {
    return std::nullopt;
  }
  std::vector<TomlNode> elements;
  for (const toml::node& element : *array) {
    elements.push_back(TomlNode{&element});
  }
  return elements;
}

std::size_t TomlNode::line() const { return node_ == nullptr ? 0 : node_of(node_)->source().begin.line; }

std::string TomlNode::as_text() const {
  std::ostringstream toml;
  toml << toml::toml_formatter{*node_of(node_)};
  std::istringstream words{toml.str()};
  std::string text;
  for (std::string word; words >> word;) {
    text += (text.empty() ? "" : " ") + word;
  }
  constexpr std::size_t longest = 60;
  if (text.size() > longest) {
    text.replace(longest, std::string::npos, "...");
  }
  return text;
}

struct TomlTree::Root {
  toml::table table;
};

void TomlTree::Destroy::operator()(Root* root) const { delete root; }

TomlTree::TomlTree() : root_{new Root} {}

TomlTree TomlTree::parse(const std::string& text, const std::string& file) {
  refuse_foreign_characters(text, file);
  toml::parse_result result = toml::parse(text, file);
  if (!result) {
    throw text::Error{text::ErrorKind::bad_data, describe(result.error(), file)};
  }
  TomlTree tree;
  tree.root_->table = std::move(result).table();
  return tree;
}

TomlNode TomlTree::root() const { return TomlNode{static_cast<const toml::node*>(&root_->table)}; }

void TomlTree::put(const std::string& table, const std::string& key, const std::string& value) {
  toml::table parsed;
  if (!foreign_character(value)) {
    if (toml::parse_result result = toml::parse("value = " + value)) {
      parsed = std::move(result).table();
    }
  }
  if (parsed.size() != 1) {  // not TOML, or a whole document smuggled into one value
    parsed.insert_or_assign("value", value);
  }
  root_->table.insert(table, toml::table{});  // where there is none
  root_->table[table].as_table()->insert_or_assign(key, *parsed.get("value"));
}

}  // namespace fantail::input
