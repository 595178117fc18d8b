// SPDX-License-Identifier: MIT
#include "input/number_field.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "core/flight_plan_fields.hpp"
#include "input/messages.hpp"
#include "input/plan_file.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::input {
namespace {

[[noreturn]] void refuse(const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_configuration, complaint};
}

/// What is known of a key, whatever file it is in.
struct Known {
  bool is_number = false;
  std::string unit{};
  Limits range{};
  std::vector<double> usual{};  ///< in the file's unit; empty: none is
};

template <typename Thing>
std::optional<Known> find(std::span<const Field<Thing>> fields, std::string_view section, std::string_view key,
                          std::vector<std::string>& keys) {
  for (const Field<Thing>& field : fields) {
    if (field.section != section) {
      continue;
    }
    keys.emplace_back(field.key);
    if (field.key != key) {
      continue;
    }
    const Allowed& allowed = field.allowed;
    Known known{
        .is_number = allowed.kind == FieldKind::number, .unit = std::string{allowed.unit.name}, .range = allowed.range};
    if (known.is_number && !allowed.is_list && field.place.get != nullptr) {
      for (std::size_t slot = 0; slot < allowed.most; ++slot) {
        const double inside = field.place.get(Thing{}, slot);
        if (!std::isnan(inside)) {
          known.usual.push_back(allowed.unit.in_file(inside));
        }
      }
    }
    return known;
  }
  return std::nullopt;
}

std::optional<Known> find_in_plan(std::string_view section, std::string_view key, std::vector<std::string>& keys) {
  for (const core::PlanField& field : core::flight_plan_fields()) {
    if (field.section != section) {
      continue;
    }
    keys.emplace_back(field.key);
    if (field.key == key) {
      return Known{.is_number = field.kind == core::FieldKind::number,
                   .unit = std::string{field.unit},
                   .range = allowed_in_plan(field),
                   .usual = field.is_list() ? std::vector<double>{} : std::vector{usual_in_plan(field)}};
    }
  }
  return std::nullopt;
}

std::vector<double> values_in(const Document& document, const std::string& section, const std::string& key) {
  const TomlNode node = document.root()[section][key];
  std::vector<double> values;
  if (const auto number = node.number()) {
    values.push_back(*number);
  } else if (const auto elements = node.elements()) {
    for (const TomlNode element : *elements) {
      values.push_back(element.number().value_or(0.0));  // what is no number is refused when the file is read
    }
  }
  return values;
}

}  // namespace

Override NumberField::with(const std::vector<double>& new_values) const {
  const std::string text = fmt::format("{}", fmt::join(new_values, ", "));
  return {.section = section, .key = key, .value = new_values.size() == 1 && !is_list ? text : '[' + text + ']'};
}

NumberField number_field(const ScenarioFiles& files, const std::string& name) {
  const std::size_t dot = name.find('.');
  if (dot == std::string::npos || dot == 0 || dot + 1 == name.size()) {
    refuse("\"" + name + "\" is not a field; allowed: section.key, as in body.mass_kg");
  }
  NumberField field{.section = name.substr(0, dot), .key = name.substr(dot + 1), .unit = {}, .values = {}};
  const Document* document = files.with_section(field.section);
  if (document == nullptr) {
    refuse(unknown_section(field.section));
  }
  std::vector<std::string> keys;
  std::optional<Known> known = find(scenario_fields(), field.section, field.key, keys);
  if (!known) {
    known = find(vehicle_fields(), field.section, field.key, keys);
  }
  if (!known) {
    known = find_in_plan(field.section, field.key, keys);
  }
  if (!known) {
    const auto meant = suggestion(field.key, keys);
    refuse("unknown key " + name + (meant ? "; did you mean " + field.section + "." + *meant + "?" : ""));
  }
  if (!known->is_number) {
    refuse(name + " is not a number that can be spread; allowed: a number that need not be whole");
  }
  field.unit = known->unit;
  field.range = known->range;
  field.values = values_in(*document, field.section, field.key);
  if (field.values.empty()) {
    field.values = known->usual;
  }
  field.is_list = field.values.size() > 1 || document->root()[field.section][field.key].elements().has_value();
  if (field.values.empty()) {
    refuse(name + " has no value in " + document->file() + ", and there is no default");
  }
  return field;
}

}  // namespace fantail::input
