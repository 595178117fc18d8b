// SPDX-License-Identifier: MIT
#include "input/field.hpp"

namespace fantail::input {

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
