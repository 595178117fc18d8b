// SPDX-License-Identifier: MIT
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "core/flight_plan_fields.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "json/value.hpp"
#include "protocol/plan_block.hpp"
#include "python/bindings/bind.hpp"
#include "python/bindings/scenario.hpp"

namespace nb = nanobind;

namespace fantail::python {
namespace {

using core::FieldKind;
using core::PlanField;

/// The number with the fewest digits that is this value of the plan.
double as_written(const PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  constexpr int most_digits = 9;
  core::FlightPlan copy = plan;
  double written = 0.0;
  for (int digits = 1; digits <= most_digits; ++digits) {
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), field.get(plan, slot), std::chars_format::general, digits)
            .ptr;
    std::from_chars(text.data(), end, written);
    field.set(copy, slot, static_cast<float>(written));
    if (field.get_bits(copy, slot) == field.get_bits(plan, slot)) {
      break;
    }
  }
  return written;
}

json::Value typed(const PlanField& field, double value) {
  switch (field.kind) {
    case FieldKind::flag: return value != 0.0;
    case FieldKind::choice: return field.choices[static_cast<std::size_t>(value)];
    case FieldKind::integer: return static_cast<std::int64_t>(value);
    case FieldKind::number: break;
  }
  return value;
}

json::Value value_of(const PlanField& field, const core::FlightPlan& plan, std::size_t slot) {
  if (field.is_time()) {
    return field.get_bits(plan, slot) / 1e6;
  }
  return field.kind == FieldKind::number ? as_written(field, plan, slot) : typed(field, double{field.get(plan, slot)});
}

std::string values_json(const core::FlightPlan& plan) {
  json::Value all;
  for (const PlanField& field : core::flight_plan_fields()) {
    json::Value& place = all[std::string{field.section} + "." + std::string{field.key}];
    if (field.slots == 1) {
      place = value_of(field, plan, 0);
      continue;
    }
    place = json::Value::array();
    for (std::size_t slot = 0; slot < field.used_slots(plan); ++slot) {
      place.push_back(value_of(field, plan, slot));
    }
  }
  return all.dump();
}

std::string fields_json() {
  constexpr std::array kinds{"number", "integer", "choice", "flag"};
  json::Value all = json::Value::array();
  for (const PlanField& field : core::flight_plan_fields()) {
    const bool has_range = field.kind == FieldKind::number || field.kind == FieldKind::integer;
    const input::Limits range = input::allowed_in_plan(field);
    json::Value choices = json::Value::array();
    for (const std::string_view choice : field.choices) {
      choices.push_back(choice);
    }
    all.push_back({{"section", field.section},
                   {"key", field.key},
                   {"kind", kinds[static_cast<std::size_t>(field.kind)]},
                   {"unit", field.unit},
                   {"minimum", has_range ? typed(field, range.minimum) : json::Value{}},
                   {"maximum", has_range ? typed(field, range.maximum) : json::Value{}},
                   {"choices", choices},
                   {"default", typed(field, input::usual_in_plan(field))},
                   {"slots", std::uint64_t{field.slots}},
                   {"is_list", field.is_list()},
                   {"meaning", field.meaning}});
  }
  return all.dump();
}

core::FlightPlan load(const std::string& name, const std::vector<std::string>& changes) {
  input::Document document = input::Document::load(input::find_input(input::Shipped::plan, name));
  for (const input::Override& change : input::parse_overrides(changes)) {
    document.apply(change);
  }
  return input::read_plan(document);
}

nb::bytes block(const core::FlightPlan& plan) {
  std::array<std::byte, protocol::largest_plan_block> bytes{};
  const std::size_t size = protocol::write_plan_block(plan, bytes);
  return nb::bytes{bytes.data(), size};
}

}  // namespace

void bind_plans(nb::module_& m) {
  auto bound_plan = nb::class_<core::FlightPlan>(m, "Plan")
                        .def_static("load", &load, nb::arg("name_or_path"), nb::arg("changes"))
                        .def_static("default", &core::default_plan)
                        .def(
                            "changed",
                            [](const core::FlightPlan& plan, const std::vector<std::string>& changes) {
                              return input::changed_plan(plan, input::parse_overrides(changes));
                            },
                            nb::arg("changes"))
                        .def_prop_ro("values_json", &values_json)
                        .def_prop_ro("table", &input::plan_table)
                        .def_prop_ro("block", &block);
  refuse_to_pickle(bound_plan, "Plan",
                   "pass name or path and set, and call Plan.load() there; dict(plan) has its values");
  m.def("plan_fields_json", &fields_json);
}

}  // namespace fantail::python
