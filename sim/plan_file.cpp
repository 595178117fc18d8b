// SPDX-License-Identifier: MIT
#include "sim/plan_file.hpp"

#include <algorithm>
#include <array>
#include <iomanip>
#include <sstream>

#include "core/flight_plan_fields.hpp"
#include "sim/input_error.hpp"

namespace fantail::sim {
namespace {

using core::FieldKind;
using core::PlanField;

std::string value_text(const PlanField& field, float value) {
  switch (field.kind) {
    case FieldKind::choice: return '"' + std::string{field.choices[static_cast<std::size_t>(value)]} + '"';
    case FieldKind::flag: return value != 0.0F ? "true" : "false";
    case FieldKind::number:
    case FieldKind::integer: break;
  }
  std::ostringstream text;
  text << std::setprecision(field.kind == FieldKind::integer ? 9 : 6) << static_cast<double>(value);
  return text.str();
}

std::string range_text(const PlanField& field) {
  if (field.kind == FieldKind::flag) {
    return "true, false";
  }
  if (field.kind == FieldKind::choice) {
    std::string words;
    for (const std::string_view word : field.choices) {
      words += (words.empty() ? "" : ", ") + std::string{word};
    }
    return words;
  }
  return value_text(field, field.minimum) + " to " + value_text(field, field.maximum);
}

// The values of one field as the file gives them, in file units; empty when the file does not mention it.
std::vector<float> read_values(Section& section, const PlanField& field, bool as_list) {
  const Limits limits{static_cast<double>(field.minimum), static_cast<double>(field.maximum)};
  std::vector<float> values;
  if (!section.has(field.key)) {
    return values;
  }
  switch (field.kind) {
    case FieldKind::number:
      if (as_list) {
        for (const double v : section.numbers(field.key, limits, field.slots)) {
          values.push_back(static_cast<float>(v));
        }
      } else {
        values.push_back(static_cast<float>(section.number(field.key, limits)));
      }
      break;
    case FieldKind::integer: values.push_back(static_cast<float>(section.integer(field.key, limits))); break;
    case FieldKind::flag: values.push_back(section.flag(field.key) ? 1.0F : 0.0F); break;
    case FieldKind::choice:
      if (as_list) {
        for (const std::size_t v : section.choices(field.key, field.choices, field.slots)) {
          values.push_back(static_cast<float>(v));
        }
      } else {
        values.push_back(static_cast<float>(section.choice(field.key, field.choices)));
      }
      break;
  }
  return values;
}

void read_field(Section& section, const PlanField& field, bool as_list, core::FlightPlan& plan) {
  const std::vector<float> values = read_values(section, field, as_list);
  if (field.is_list()) {
    field.set_length(plan, values.size());
  } else if (as_list && values.size() != field.slots) {
    section.refuse(field.key, "has " + std::to_string(values.size()) + " values; allowed: one for all, or " +
                                  std::to_string(field.slots));
  }
  for (std::size_t slot = 0; slot < field.slots && !values.empty(); ++slot) {
    if (as_list && slot >= values.size()) {
      break;
    }
    field.set(plan, slot, as_list ? values[slot] : values[0]);
  }
}

}  // namespace

std::vector<std::string> plan_sections() {
  std::vector<std::string> names;
  for (const PlanField& field : core::flight_plan_fields()) {
    if (names.empty() || names.back() != field.section) {
      names.emplace_back(field.section);
    }
  }
  return names;
}

core::FlightPlan read_plan(const Document& document) {
  const std::vector<std::string> sections = plan_sections();
  refuse_unknown_sections(document, sections);
  core::FlightPlan plan = core::default_plan();
  for (const std::string& name : sections) {
    Section section{document, name};
    const toml::node* table = document.root().get(name);
    for (const PlanField& field : core::flight_plan_fields()) {
      if (field.section == name && section.has(field.key)) {
        const bool as_list = field.is_list() || table->as_table()->get(field.key)->is_array();
        read_field(section, field, as_list, plan);
      }
    }
    section.finish();
  }
  if (const auto fault = core::validate(plan)) {
    const Section section{document, std::string{fault->field->section}};
    std::string complaint{fault->rule};
    if (fault->slot < fault->field->used_slots(plan)) {
      complaint = "= " + value_text(*fault->field, fault->field->get(plan, fault->slot)) + ": " + complaint;
    }
    section.refuse(fault->field->key, complaint);
  }
  return plan;
}

std::string plan_table(const core::FlightPlan& plan) {
  std::ostringstream text;
  std::string_view section;
  for (const PlanField& field : core::flight_plan_fields()) {
    if (field.section != section) {
      text << (section.empty() ? "" : "\n") << '[' << field.section << "]\n";
      section = field.section;
    }
    std::vector<std::string> values;
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      values.push_back(value_text(field, field.get(plan, slot)));
    }
    const bool all_equal = !field.is_list() && std::ranges::all_of(values, [&](auto& v) { return v == values[0]; });
    std::string shown = all_equal ? values[0] : "[";
    for (std::size_t i = 0; !all_equal && i < values.size(); ++i) {
      shown += (i == 0 ? "" : ", ") + values[i];
    }
    shown += all_equal ? "" : "]";
    std::ostringstream assignment;
    assignment << field.key << " = " << shown;
    text << std::left << std::setw(46) << assignment.str() << " # " << field.meaning << " ("
         << (field.unit.empty() ? "" : std::string{field.unit} + ", ") << range_text(field) << ")\n";
  }
  return text.str();
}

}  // namespace fantail::sim
