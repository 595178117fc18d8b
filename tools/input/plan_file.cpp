// SPDX-License-Identifier: MIT
#include "input/plan_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "core/flight_plan_fields.hpp"
#include "input/file_checks.hpp"
#include "input/section.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::input {
namespace {

using core::FieldKind;
using core::PlanField;

// The number a person wrote for this float: 0.1, where the float itself is a little more. Limits are compared with what
// stands in a file, so they must be what stands in the table of fields.
double as_written(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return text::decimal({text.data(), end}).value_or(0.0);
}

// Times go straight into microseconds: through a float, 300.001 s would be 7 us late and so a whole tick.
void set_value(const PlanField& field, core::FlightPlan& plan, std::size_t slot, double file_value) {
  if (field.is_time()) {
    field.set_bits(plan, slot, static_cast<std::uint32_t>(std::llround(file_value * 1e6)));
  } else {
    field.set(plan, slot, static_cast<float>(file_value));
  }
}

double get_value(const PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  return field.is_time() ? field.get_bits(plan, slot) * 1e-6 : static_cast<double>(field.get(plan, slot));
}

std::string number_text(double value, int digits) {
  std::ostringstream text;
  text << std::setprecision(digits) << value;
  return text.str();
}

std::string value_text(const PlanField& field, double value) {
  switch (field.kind) {
    case FieldKind::choice: return '"' + std::string{field.choices[static_cast<std::size_t>(value)]} + '"';
    case FieldKind::flag: return value != 0.0 ? "true" : "false";
    case FieldKind::number:
    case FieldKind::integer: break;
  }
  return number_text(value, field.kind == FieldKind::integer ? 9 : 6);
}

// With as many digits as it takes to read the same value back.
std::string value_text(const PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  const double value = get_value(field, plan, slot);
  std::string text = value_text(field, value);
  core::FlightPlan copy = plan;
  for (int digits = 6; field.kind == FieldKind::number && digits <= 9; ++digits) {
    text = number_text(value, digits);
    set_value(field, copy, slot, *text::number(text));
    if (field.get_bits(copy, slot) == field.get_bits(plan, slot)) {
      break;
    }
  }
  return text;
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
  return value_text(field, as_written(field.minimum)) + " to " + value_text(field, as_written(field.maximum));
}

// The values of one field as the file gives them, in file units.
std::vector<double> read_values(Section& section, const PlanField& field, bool as_list) {
  const Limits limits = allowed_in_plan(field);
  switch (field.kind) {
    case FieldKind::number:
      return as_list ? section.numbers(field.key, limits, field.slots) : std::vector{section.number(field.key, limits)};
    case FieldKind::integer: return {static_cast<double>(section.integer(field.key, limits))};
    case FieldKind::flag: return {section.flag(field.key) ? 1.0 : 0.0};
    case FieldKind::choice: break;
  }
  if (!as_list) {
    return {static_cast<double>(section.choice(field.key, field.choices))};
  }
  const std::vector<std::size_t> chosen = section.choices(field.key, field.choices, field.slots);
  return {chosen.begin(), chosen.end()};
}

void read_field(Section& section, const PlanField& field, TomlNode node, core::FlightPlan& plan) {
  const auto each = field.slots > 1 ? node.elements() : std::nullopt;
  if (each && !field.is_list() && each->size() != field.slots) {
    section.refuse(field.key, "has " + std::to_string(each->size()) + " values; allowed: one for all, or " +
                                  std::to_string(field.slots));
  }
  const std::vector<double> values = read_values(section, field, each || field.is_list());
  if (field.is_list()) {
    field.set_length(plan, values.size());
  }
  for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
    set_value(field, plan, slot, each ? values[slot] : values[0]);
  }
}

}  // namespace

Limits allowed_in_plan(const PlanField& field) { return {as_written(field.minimum), as_written(field.maximum)}; }

double usual_in_plan(const PlanField& field) {
  return as_written(static_cast<float>(get_value(field, core::default_plan(), 0)));
}

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
  refuse_other_kind(document, Shipped::plan);
  const std::vector<std::string> sections = plan_sections();
  refuse_unknown_sections(document, sections);
  core::FlightPlan plan = core::default_plan();
  for (const std::string& name : sections) {
    Section section{document, name};
    for (const PlanField& field : core::flight_plan_fields()) {
      if (field.section == name && section.has(field.key)) {
        read_field(section, field, document.root()[name][field.key], plan);
      }
    }
    section.finish();
  }
  if (const auto fault = core::validate(plan)) {
    const PlanField& field = core::flight_plan_fields()[fault->field];
    const Section section{document, std::string{field.section}};
    std::string complaint = "is refused: " + std::string{core::sentence(fault->rule)};
    if (!field.is_list() || fault->slot > 0) {  // the rules on a whole list name its first slot
      complaint = "= " + value_text(field, plan, fault->slot) + ' ' + complaint;
    }
    section.refuse(field.key, complaint);
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
    values.reserve(field.used_slots(plan));
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      values.push_back(value_text(field, plan, slot));
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

Document plan_document(const core::FlightPlan& plan) {
  Document document;
  std::istringstream lines{plan_table(plan)};
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) {
      section = line.substr(1, line.find(']') - 1);
    } else if (!line.empty()) {
      document.apply(parse_override(section + "." + line.substr(0, line.find('#'))));
    }
  }
  return document;
}

core::FlightPlan changed_plan(const core::FlightPlan& plan, std::span<const Override> changes) {
  Document document = plan_document(plan);
  for (const Override& change : changes) {
    document.apply(change);
  }
  const core::FlightPlan read = read_plan(document);
  core::FlightPlan result = plan;
  for (const core::PlanField& field : core::flight_plan_fields()) {
    const bool changed = std::ranges::any_of(
        changes, [&](const Override& c) { return c.section == field.section && c.key == field.key; });
    if (!changed) {
      continue;
    }
    if (field.is_list()) {
      field.set_length(result, field.used_slots(read));
    }
    for (std::size_t slot = 0; slot < field.used_slots(read); ++slot) {
      field.set_bits(result, slot, field.get_bits(read, slot));
    }
  }
  return result;
}

bool table_says_all(const core::FlightPlan& plan) {
  const core::FlightPlan read = read_plan(plan_document(plan));
  return std::ranges::all_of(core::flight_plan_fields(), [&](const PlanField& field) {
    bool same = field.used_slots(read) == field.used_slots(plan);
    for (std::size_t slot = 0; same && slot < field.used_slots(plan); ++slot) {
      same = field.get_bits(read, slot) == field.get_bits(plan, slot);
    }
    return same;
  });
}

}  // namespace fantail::input
