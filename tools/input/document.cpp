// SPDX-License-Identifier: MIT
#include "input/document.hpp"

#include <optional>

#include "input/file_text.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::input {

Override parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.substr(0, equals).find('.');
  Override change;
  if (equals != std::string_view::npos && dot != std::string_view::npos) {
    change = {std::string{text::trimmed(text.substr(0, dot))},
              std::string{text::trimmed(text.substr(dot + 1, equals - dot - 1))},
              std::string{text::trimmed(text.substr(equals + 1))}};
  }
  if (change.section.empty() || change.key.empty() || change.value.empty()) {
    throw text::Error{
        text::ErrorKind::bad_configuration,
        "--set " + std::string{text} + ": expected section.key=value, as in controller.canard_limit_deg=6"};
  }
  return change;
}

Document Document::load(const std::string& file) {
  const std::optional<std::string> text = file_text(file);
  if (!text) {
    throw text::Error{text::ErrorKind::no_such_input, file + ": no such file"};
  }
  Document document;
  document.file_ = file;
  document.tree_ = TomlTree::parse(*text, file);
  return document;
}

void Document::apply(const Override& change) {
  const TomlNode section = root()[change.section];
  if (!section) {
    replaced_["." + change.section] = change.text();
  } else if (!section.is_table()) {
    throw text::Error{text::ErrorKind::bad_configuration, change.text() + ": " + change.section + " is not a section"};
  }
  tree_.put(change.section, change.key, change.value);
  replaced_[change.section + "." + change.key] = change.text();
}

bool Document::is_replaced(std::string_view section, std::string_view key) const {
  return replaced_.contains(std::string{section} + "." + std::string{key});
}

std::string Document::where(std::string_view section, std::string_view key, TomlNode node) const {
  const auto replaced = replaced_.find(std::string{section} + "." + std::string{key});
  if (replaced != replaced_.end()) {
    return replaced->second;
  }
  return node.line() > 0 ? file_ + ":" + std::to_string(node.line()) : file_;
}

}  // namespace fantail::input
