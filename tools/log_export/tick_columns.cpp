// SPDX-License-Identifier: MIT
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "log_export/fields.hpp"

namespace fantail::log_export {
namespace {

using files::Column;
using files::Kind;

Kind kind_of(FieldType type) {
  switch (type) {
    case FieldType::number: return Kind::number;
    case FieldType::integer: return Kind::integer;
    case FieldType::flag: return Kind::flag;
    case FieldType::word: break;
  }
  return Kind::word;
}

struct ToNumber {
  std::map<std::uint8_t, std::string>& words;

  double operator()(std::monostate) const { return std::numeric_limits<double>::quiet_NaN(); }
  double operator()(double value) const { return value; }
  double operator()(std::int64_t value) const { return static_cast<double>(value); }
  double operator()(bool value) const { return value ? 1.0 : 0.0; }
  double operator()(const Word& word) const {
    words.try_emplace(word.number, word.text);
    return word.number;
  }
};

// The number of an enumeration's value becomes the place of its word among those that occur.
void place_words(Column& column, const std::map<std::uint8_t, std::string>& words) {
  if (column.kind != Kind::word) {
    return;
  }
  for (double& value : column.values) {
    if (!std::isnan(value)) {
      value = static_cast<double>(std::distance(words.begin(), words.find(static_cast<std::uint8_t>(value))));
    }
  }
  for (const auto& [number, word] : words) {
    column.words.push_back(word);
  }
}

}  // namespace

files::Columns tick_columns(const ReplayedFlight& source, const Selection& selection) {
  files::Columns columns;
  std::vector<std::map<std::uint8_t, std::string>> words(selection.size());
  for (const std::size_t i : selection) {
    columns.push_back({.name = fields()[i].name, .kind = kind_of(fields()[i].type)});
  }
  for_each_tick(source, [&](std::size_t, core::Microseconds, std::span<const Value> values) {
    for (std::size_t i = 0; i < selection.size(); ++i) {
      columns[i].values.push_back(std::visit(ToNumber{words[i]}, values[selection[i]]));
    }
  });
  for (std::size_t i = 0; i < selection.size(); ++i) {
    place_words(columns[i], words[i]);
  }
  return columns;
}

}  // namespace fantail::log_export
