// SPDX-License-Identifier: MIT
#include "input/field.hpp"

#include <fmt/format.h>

#include "input/messages.hpp"
#include "input/plan_file.hpp"
#include "input/scenario_file.hpp"
#include "input/shipped.hpp"
#include "input/vehicle_file.hpp"
#include "scratch_file.hpp"
#include "test.hpp"

namespace fantail::input {
namespace {

// A table of fields, and a document that has everything that must be there.
template <typename Thing>
struct Table {
  std::span<const Field<Thing>> fields;
  Document document;

  [[nodiscard]] Thing read(const Override& change) const {
    Document changed = Document::load(document.file());
    changed.apply(change);
    Thing thing;
    for (const std::string& section : sections_of(fields)) {
      read_section(changed, section, fields, thing);
    }
    return thing;
  }
};

Table<sim::Vehicle> vehicles() {
  return {vehicle_fields(), Document::load(find_input(Shipped::vehicle, "tasha3_launch2"))};
}

Table<sim::Scenario> scenarios() {
  return {scenario_fields(), Document::load(find_input(Shipped::scenario, "tasha3_launch1"))};
}

template <typename Thing>
Override given(const Field<Thing>& field, double file_value) {
  const Allowed& allowed = field.allowed;
  std::string text = allowed.kind == FieldKind::choice
                         ? '"' + std::string{allowed.words[static_cast<std::size_t>(file_value)]} + '"'
                         : fmt::format("{}", file_value);
  if (allowed.is_list) {
    text = "[" + text + "]";
  } else if (allowed.most == 4) {
    text = "[" + text + ", " + text + ", " + text + ", " + text + "]";
  }
  return {std::string{field.section}, std::string{field.key}, text};
}

// Not a number: there is none.
bool differ(double a, double b) { return a != b && !(std::isnan(a) && std::isnan(b)); }

// At both ends of its range and nowhere else, and no other field with it.
template <typename Thing>
void expect_each_field_in_its_place(const Table<Thing>& table) {
  for (const Field<Thing>& field : table.fields) {
    if (field.section.empty() || field.allowed.is_text()) {
      continue;
    }
    const bool is_choice = field.allowed.kind == FieldKind::choice;
    const Limits range =
        is_choice ? Limits{0.0, static_cast<double>(field.allowed.words.size() - 1)} : field.allowed.range;
    const Thing low = table.read(given(field, range.minimum));
    const Thing high = table.read(given(field, range.maximum));
    for (const Field<Thing>& other : table.fields) {
      if (other.place.get == nullptr || (other.allowed.is_list && other.key != field.key)) {
        continue;
      }
      const bool is_same = other.section == field.section && other.key == field.key;
      EXPECT_EQ(differ(other.place.get(low, 0), other.place.get(high, 0)), is_same)
          << field.key << " moves " << other.key;
    }
    EXPECT_EQ(field.place.get(low, 0), field.allowed.unit.inside(range.minimum)) << field.key;
    EXPECT_EQ(field.place.get(high, 0), field.allowed.unit.inside(range.maximum)) << field.key;
    const double beyond = 0.01 * (range.maximum - range.minimum);
    for (const double outside : {range.minimum - beyond, range.maximum + beyond}) {
      if (field.allowed.kind == FieldKind::number) {
        EXPECT_TRUE(complaint([&] { (void)table.read(given(field, outside)); })
                        .message.ends_with(" is out of range; allowed: " + plain_number(range.minimum) + " to " +
                                           plain_number(range.maximum)))
            << field.key;
      }
    }
  }
}

template <typename Thing>
void expect_usual_values_in_range(std::span<const Field<Thing>> fields) {
  const Thing usual;
  std::set<std::string> keys;
  for (const Field<Thing>& field : fields) {
    EXPECT_TRUE(keys.insert(std::string{field.section} + "." + std::string{field.key}).second) << field.key;
    EXPECT_FALSE(field.meaning.empty()) << field.key;
    if (field.presence == Presence::may && field.place.get != nullptr && !field.allowed.is_list &&
        field.allowed.kind != FieldKind::choice) {
      const double value = field.allowed.unit.in_file(field.place.get(usual, 0));
      if (std::isnan(value)) {
        continue;  // there is no default
      }
      EXPECT_GE(value, field.allowed.range.minimum) << field.key;
      EXPECT_LE(value, field.allowed.range.maximum) << field.key;
    }
  }
}

// --set names a section and not a file.
TEST(FieldTable, NoSectionIsInTwoKindsOfFile) {
  std::set<std::string> all;
  for (const auto& sections : {plan_sections(), sections_of(vehicle_fields()), sections_of(scenario_fields())}) {
    for (const std::string& section : sections) {
      EXPECT_TRUE(all.insert(section).second) << section;
    }
  }
}

TEST(FieldTable, HasEachKeyOnceWithItsMeaningAndADefaultInItsRange) {
  expect_usual_values_in_range(vehicle_fields());
  expect_usual_values_in_range(scenario_fields());
}

TEST(FieldTable, ReadsEachFieldOfAVehicleIntoItsOwnPlace) { expect_each_field_in_its_place(vehicles()); }

TEST(FieldTable, ReadsEachFieldOfAScenarioIntoItsOwnPlace) { expect_each_field_in_its_place(scenarios()); }

}  // namespace
}  // namespace fantail::input
