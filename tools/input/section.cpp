// SPDX-License-Identifier: MIT
#include "input/section.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/field.hpp"
#include "input/messages.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

// "; did you mean x?", or all that may stand there.
std::string help(const std::string& wrong, std::span<const std::string> known, const std::string& prefix) {
  if (const auto meant = suggestion(wrong, known)) {
    return "; did you mean " + prefix + *meant + "?";
  }
  std::vector<std::string> listed;
  std::string list;
  for (const std::string& word : known) {
    if (std::ranges::find(listed, word) == listed.end()) {
      listed.push_back(word);
      list += (list.empty() ? "" : ", ") + word;
    }
  }
  return list.empty() ? list : "; allowed: " + list;
}

std::string range(Limits limits) { return plain_number(limits.minimum) + " to " + plain_number(limits.maximum); }

}  // namespace

Section::Section(const Document& document, std::string name) : document_{document}, name_{std::move(name)} {
  if (name_.empty()) {
    table_ = document.root();
    return;
  }
  table_ = document.root()[name_];
  if (table_ && !table_.is_table()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      document.where("", name_, table_) + ": [" + name_ + "] must be a section"};
  }
}

Section::Section(const Document& document, std::string name, TomlNode table)
    : document_{document}, name_{std::move(name)}, table_{table} {}

std::string Section::label(std::string_view key) const {
  return name_.empty() ? std::string{key} : name_ + "." + std::string{key};
}

TomlNode Section::find(std::string_view key) {
  known_.emplace_back(key);
  return table_[key];
}

std::string Section::where(std::string_view key) const {
  const TomlNode node = table_[key];
  return document_.where(name_, key, node ? node : table_);
}

void Section::refuse(std::string_view key, const std::string& complaint) const {
  throw text::Error{text::ErrorKind::bad_configuration, where(key) + ": " + label(key) + " " + complaint};
}

bool Section::has(std::string_view key) { return static_cast<bool>(find(key)); }

TomlNode Section::require(std::string_view key, const std::string& allowed) {
  const TomlNode node = find(key);
  if (!node) {
    const std::vector<std::string> there = table_.keys();
    const auto meant = suggestion(key, there);
    refuse(key, "is missing" + (meant ? " (is " + label(*meant) + " a misspelling of it?)" : "") +
                    (allowed.empty() ? "" : "; allowed: " + allowed));
  }
  return node;
}

double Section::checked_number(std::string_view key, TomlNode node, Limits limits) const {
  const std::string allowed = "; allowed: " + range(limits);
  const std::optional<double> value = node.number();
  if (!value) {
    refuse(key, "= " + node.as_text() + " is not a number" + allowed);
  }
  if (!std::isfinite(*value) || *value < limits.minimum || *value > limits.maximum) {
    refuse(key, "= " + plain_number(*value) + " is out of range" + allowed);
  }
  return *value;
}

double Section::number(std::string_view key, Limits limits) {
  return checked_number(key, require(key, range(limits)), limits);
}

std::int64_t Section::integer(std::string_view key, Limits limits) {
  const TomlNode node = require(key, range(limits));
  if (!node.integer()) {
    refuse(key, "= " + node.as_text() + " is not a whole number");
  }
  return static_cast<std::int64_t>(checked_number(key, node, limits));
}

bool Section::flag(std::string_view key) {
  const TomlNode node = require(key, "true or false");
  const std::optional<bool> value = node.flag();
  if (!value) {
    refuse(key, "= " + node.as_text() + "; allowed: true or false");
  }
  return *value;
}

std::string Section::checked_text(std::string_view key, TomlNode node) const {
  const std::optional<std::string> text = node.text();
  if (!text) {
    refuse(key, "= " + node.as_text() + " is not a text");
  }
  return *text;
}

std::string Section::text(std::string_view key) { return checked_text(key, require(key)); }

std::size_t Section::checked_choice(std::string_view key, TomlNode node,
                                    std::span<const std::string_view> words) const {
  if (const std::optional<std::string> text = node.text()) {
    const auto found = std::ranges::find(words, *text);
    if (found != words.end()) {
      return static_cast<std::size_t>(found - words.begin());
    }
  }
  std::string allowed;
  for (const std::string_view word : words) {
    allowed += (allowed.empty() ? "" : ", ") + std::string{word};
  }
  refuse(key, "= " + node.as_text() + "; allowed: " + allowed);
}

std::size_t Section::choice(std::string_view key, std::span<const std::string_view> words) {
  return checked_choice(key, require(key), words);
}

namespace {

template <typename Value, typename Read>
std::vector<Value> read_list(const Section& section, std::string_view key, TomlNode node, std::size_t most, Read read) {
  std::vector<Value> values;
  if (!node) {
    return values;
  }
  const auto elements = node.elements();
  if (!elements) {
    section.refuse(key, "must be a list, as in [1, 2]");
  }
  if (elements->size() > most) {
    section.refuse(key,
                   "has " + std::to_string(elements->size()) + " values; allowed: at most " + std::to_string(most));
  }
  for (const TomlNode element : *elements) {
    values.push_back(read(element));
  }
  return values;
}

}  // namespace

std::vector<double> Section::numbers(std::string_view key, Limits limits, std::size_t most) {
  return read_list<double>(*this, key, find(key), most,
                           [&](TomlNode node) { return checked_number(key, node, limits); });
}

std::vector<std::size_t> Section::choices(std::string_view key, std::span<const std::string_view> words,
                                          std::size_t most) {
  return read_list<std::size_t>(*this, key, find(key), most,
                                [&](TomlNode node) { return checked_choice(key, node, words); });
}

std::vector<std::string> Section::texts(std::string_view key, std::size_t most) {
  return read_list<std::string>(*this, key, find(key), most, [&](TomlNode node) { return checked_text(key, node); });
}

void Section::finish() const {
  for (const std::string& name : table_.keys()) {
    if (std::ranges::find(known_, name) != known_.end()) {
      continue;
    }
    throw text::Error{text::ErrorKind::bad_configuration, where(name) + ": unknown key " + label(name) +
                                                              help(name, known_, name_.empty() ? "" : name_ + ".")};
  }
}

void refuse_unknown_sections(const Document& document, std::span<const std::string> known) {
  for (const std::string& name : document.root().keys()) {
    if (std::ranges::find(known, name) != known.end()) {
      continue;
    }
    const TomlNode node = document.root()[name];
    throw text::Error{text::ErrorKind::bad_configuration,
                      document.where("", name, node) + ": unknown " +
                          (node.is_table() ? "section [" + name + "]" : "key " + name) + help(name, known, "")};
  }
}

std::vector<double> read_numbers(Section& section, std::string_view key, const Allowed& allowed) {
  if (allowed.most == 1) {
    switch (allowed.kind) {
      case FieldKind::integer: return {static_cast<double>(section.integer(key, allowed.range))};
      case FieldKind::choice: return {static_cast<double>(section.choice(key, allowed.words))};
      default: return {section.number(key, allowed.range)};
    }
  }
  std::vector<double> values;
  if (allowed.kind == FieldKind::choice) {
    const std::vector<std::size_t> chosen = section.choices(key, allowed.words, allowed.most);
    values.assign(chosen.begin(), chosen.end());
  } else {
    values = section.numbers(key, allowed.range, allowed.most);
  }
  if (!allowed.is_list && !values.empty() && values.size() != allowed.most) {
    section.refuse(key, "has " + std::to_string(values.size()) + " values; allowed: four");
  }
  return values;
}

std::vector<std::string> read_texts(Section& section, std::string_view key, const Allowed& allowed) {
  return allowed.is_list ? section.texts(key, allowed.most) : std::vector{section.text(key)};
}

}  // namespace fantail::input
