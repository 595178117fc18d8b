// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <sstream>

#include "sim/document.hpp"
#include "sim/input_error.hpp"
#include "sim/shown.hpp"

namespace fantail::sim {
namespace {

// On one line, whatever it is, and not longer than a message can bear.
std::string shown(const toml::node& node) {
  std::ostringstream toml;
  node.visit([&](const auto& concrete) { toml << concrete; });
  std::istringstream words{toml.str()};
  std::string text;
  for (std::string word; words >> word;) {
    text += (text.empty() ? "" : " ") + word;
  }
  constexpr std::size_t longest = 60;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace

Section::Section(const Document& document, std::string name)
    : document_{document}, name_{std::move(name)}, table_{nullptr} {
  if (name_.empty()) {
    table_ = &document.root();
    return;
  }
  if (const toml::node* node = document.root().get(name_)) {
    table_ = node->as_table();
    if (table_ == nullptr) {
      throw InputError{InputFault::bad_configuration,
                       document.where("", name_, node) + ": [" + name_ + "] must be a section"};
    }
  }
}

Section::Section(const Document& document, std::string name, const toml::table& table)
    : document_{document}, name_{std::move(name)}, table_{&table} {}

std::string Section::label(std::string_view key) const {
  return name_.empty() ? std::string{key} : name_ + "." + std::string{key};
}

const toml::node* Section::find(std::string_view key) {
  known_.emplace_back(key);
  return table_ == nullptr ? nullptr : table_->get(key);
}

std::string Section::where(std::string_view key) const {
  const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
  return document_.where(name_, key, node != nullptr ? node : table_);
}

void Section::refuse(std::string_view key, const std::string& complaint) const {
  throw InputError{InputFault::bad_configuration, where(key) + ": " + label(key) + " " + complaint};
}

bool Section::has(std::string_view key) { return find(key) != nullptr; }

double Section::checked_number(std::string_view key, const toml::node& node, Limits limits) const {
  const std::string allowed = "; allowed: " + shown(limits.minimum) + " to " + shown(limits.maximum);
  if (!node.is_number()) {
    refuse(key, "= " + shown(node) + " is not a number" + allowed);
  }
  const double value = node.is_integer() ? static_cast<double>(**node.as_integer()) : **node.as_floating_point();
  if (!std::isfinite(value) || value < limits.minimum || value > limits.maximum) {
    refuse(key, "= " + shown(value) + " is out of range" + allowed);
  }
  return value;
}

double Section::number(std::string_view key, Limits limits, std::optional<double> otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!otherwise) {
      refuse(key, "is missing; allowed: " + shown(limits.minimum) + " to " + shown(limits.maximum));
    }
    return *otherwise;
  }
  return checked_number(key, *node, limits);
}

std::int64_t Section::integer(std::string_view key, Limits limits, std::optional<std::int64_t> otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr && otherwise) {
    return *otherwise;
  }
  if (node != nullptr && !node->is_integer()) {
    refuse(key, "= " + shown(*node) + " is not a whole number");
  }
  return static_cast<std::int64_t>(number(key, limits));
}

bool Section::flag(std::string_view key, std::optional<bool> otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!otherwise) {
      refuse(key, "is missing; allowed: true or false");
    }
    return *otherwise;
  }
  const std::optional<bool> value = node->is_boolean() ? node->value<bool>() : std::nullopt;
  if (!value) {
    refuse(key, "= " + shown(*node) + "; allowed: true or false");
  }
  return *value;
}

std::string Section::checked_text(std::string_view key, const toml::node& node) const {
  if (!node.is_string()) {
    refuse(key, "= " + shown(node) + " is not a text");
  }
  return **node.as_string();
}

std::string Section::text(std::string_view key, std::optional<std::string> otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!otherwise) {
      refuse(key, "is missing");
    }
    return *otherwise;
  }
  return checked_text(key, *node);
}

std::size_t Section::checked_choice(std::string_view key, const toml::node& node,
                                    std::span<const std::string_view> words) const {
  if (node.is_string()) {
    const auto found = std::ranges::find(words, std::string_view{**node.as_string()});
    if (found != words.end()) {
      return static_cast<std::size_t>(found - words.begin());
    }
  }
  std::string allowed;
  for (const std::string_view word : words) {
    allowed += (allowed.empty() ? "" : ", ") + std::string{word};
  }
  refuse(key, "= " + shown(node) + "; allowed: " + allowed);
}

std::size_t Section::choice(std::string_view key, std::span<const std::string_view> words,
                            std::optional<std::size_t> otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) {
    if (!otherwise) {
      refuse(key, "is missing");
    }
    return *otherwise;
  }
  return checked_choice(key, *node, words);
}

namespace {

template <typename Value, typename Read>
std::vector<Value> read_list(const Section& section, std::string_view key, const toml::node* node, std::size_t most,
                             Read read) {
  std::vector<Value> values;
  if (node == nullptr) {
    return values;
  }
  const toml::array* array = node->as_array();
  if (array == nullptr) {
    section.refuse(key, "must be a list, as in [1, 2]");
  }
  if (array->size() > most) {
    section.refuse(key, "has " + std::to_string(array->size()) + " values; allowed: at most " + std::to_string(most));
  }
  for (const toml::node& element : *array) {
    values.push_back(read(element));
  }
  return values;
}

}  // namespace

std::vector<double> Section::numbers(std::string_view key, Limits limits, std::size_t most) {
  return read_list<double>(*this, key, find(key), most,
                           [&](const toml::node& node) { return checked_number(key, node, limits); });
}

std::vector<std::size_t> Section::choices(std::string_view key, std::span<const std::string_view> words,
                                          std::size_t most) {
  return read_list<std::size_t>(*this, key, find(key), most,
                                [&](const toml::node& node) { return checked_choice(key, node, words); });
}

std::vector<std::string> Section::texts(std::string_view key, std::size_t most) {
  return read_list<std::string>(*this, key, find(key), most,
                                [&](const toml::node& node) { return checked_text(key, node); });
}

void Section::finish() const {
  if (table_ == nullptr) {
    return;
  }
  for (const auto& [key, node] : *table_) {
    const std::string name{key.str()};
    if (std::ranges::find(known_, name) != known_.end()) {
      continue;
    }
    std::string message = document_.where(name_, name, &node) + ": unknown key " + label(name);
    if (const auto meant = suggestion(name, known_)) {
      message += "; did you mean " + label(*meant) + "?";
    }
    throw InputError{InputFault::bad_configuration, message};
  }
}

}  // namespace fantail::sim
