// SPDX-License-Identifier: MIT
#include "sim/document.hpp"

#include <algorithm>
#include <filesystem>

#include "sim/input_error.hpp"

namespace fantail::sim {
namespace {

// Number of single-letter edits between two words.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string_view::npos ? std::string{}
                                         : std::string{text.substr(first, text.find_last_not_of(" \t") + 1 - first)};
}

}  // namespace

Override parse_override(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::size_t dot = text.substr(0, equals).find('.');
  Override change;
  if (equals != std::string_view::npos && dot != std::string_view::npos) {
    change = {trimmed(text.substr(0, dot)), trimmed(text.substr(dot + 1, equals - dot - 1)),
              trimmed(text.substr(equals + 1))};
  }
  if (change.section.empty() || change.key.empty() || change.value.empty()) {
    throw InputError{
        InputFault::bad_configuration,
        "--set " + std::string{text} + ": expected section.key=value, as in controller.canard_limit_deg=6"};
  }
  return change;
}

std::optional<std::string> suggestion(std::string_view wrong, std::span<const std::string> known) {
  std::optional<std::string> best;
  std::size_t nearest = std::max<std::size_t>(2, wrong.size() / 3) + 1;
  for (const std::string& word : known) {
    const bool part = wrong.size() >= 3 && (word.find(wrong) != std::string::npos);
    const std::size_t d = part ? std::min<std::size_t>(2, distance(wrong, word)) : distance(wrong, word);
    if (d < nearest) {
      nearest = d;
      best = word;
    }
  }
  return best;
}

Document Document::load(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw InputError{InputFault::no_such_input, file + ": no such file"};
  }
  Document document;
  document.file_ = file;
  document.tree_ = TomlTree::read(file);
  return document;
}

void Document::apply(const Override& change) {
  const TomlNode section = root()[change.section];
  if (!section) {
    replaced_["." + change.section] = change.text();
  } else if (!section.is_table()) {
    throw InputError{InputFault::bad_configuration, change.text() + ": " + change.section + " is not a section"};
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

}  // namespace fantail::sim
