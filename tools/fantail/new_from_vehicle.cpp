// SPDX-License-Identifier: MIT
#include "fantail/new_from_vehicle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "input/vehicle_file.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

using input::Document;
using VehicleField = input::Field<sim::Vehicle>;

constexpr std::array<std::string_view, 9> kept_sections{"recovery",   "servo",         "imu",
                                                        "second_imu", "accelerometer", "barometer",
                                                        "vibration",  "encoder",       "canard_tolerances"};
constexpr std::array<std::string_view, 7> kept_keys{
    "drag_mach",           "drag_factor",       "canard_wash",       "canard_wash_distance_m",
    "canard_side_area_m2", "canard_position_m", "nozzle_position_m",
};
/// A plan must say the same, and the new plan has the usual values.
constexpr std::array<std::string_view, 4> planned_keys{"pulse_centre_us", "pulse_per_degree_us", "to_nose", "along_y"};

template <std::size_t Size>
bool is_one_of(const std::array<std::string_view, Size>& all, std::string_view word) {
  return std::ranges::find(all, word) != all.end();
}

input::TomlNode value_in(const Document& document, const VehicleField& field) {
  return document.root()[field.section][field.key];
}

bool is_kept(const VehicleField& field, bool same_motor) {
  return (is_one_of(kept_sections, field.section) && !is_one_of(planned_keys, field.key)) ||
         is_one_of(kept_keys, field.key) || (field.key == "thrust_factor" && same_motor);
}

std::string in_file(const VehicleField& field, const sim::Vehicle& vehicle, std::size_t slot, int digits) {
  const double inside = field.place.get(vehicle, slot);
  return field.allowed.kind == input::FieldKind::choice
             ? text::toml_text(std::string{field.allowed.words[static_cast<std::size_t>(inside)]})
             : fmt::format("{:.{}g}", field.allowed.unit.in_file(inside), digits);
}

std::string assignment(const VehicleField& field, const input::TomlNode& value, const sim::Vehicle& vehicle) {
  constexpr int all_digits = 12;  // that a person wrote
  const auto elements = value.elements();
  std::string values;
  for (std::size_t i = 0; i < (elements ? elements->size() : 1); ++i) {
    values += (i == 0 ? "" : ", ") + in_file(field, vehicle, i, all_digits);
  }
  return fmt::format("{} = {}\n", field.key, elements ? '[' + values + ']' : values);
}

}  // namespace

void add_computed_keys(Document& source, const std::optional<std::string>& motor) {
  const auto add = [&source](const char* section, const char* key, const std::string& value) {
    if (!source.root()[section][key]) {
      source.apply({section, key, value});
    }
  };
  add("body", "name", "\"rocket\"");
  if (source.root()["masses"]) {
    add("body", "roll_inertia_kg_m2", "1e-6");
  }
  add("aerodynamics", "reference_area_m2", "1");
  add("aerodynamics", "damping_m2", "1e4");
  add("aerodynamics", "torque_m", "0");
  if (motor) {
    add("motor", "file", text::toml_text(*motor));
  }
}

void keep_equipment(const Document& source, bool same_motor, airframe::NewRocket& rocket) {
  for (const VehicleField& field : input::vehicle_fields()) {
    const input::TomlNode value = value_in(source, field);
    if (!value || field.place.get == nullptr || !is_kept(field, same_motor)) {
      continue;
    }
    if (rocket.kept.empty() || rocket.kept.back().section != field.section) {
      rocket.kept.push_back({.section = std::string{field.section}});
    }
    rocket.kept.back().lines += assignment(field, value, rocket.vehicle);
  }
  std::string whole;
  for (const airframe::NewRocket::Kept& kept : rocket.kept) {
    if (is_one_of(kept_sections, kept.section)) {
      whole += fmt::format("{}[{}]", whole.empty() ? "" : ", ", kept.section);
    }
  }
  if (!whole.empty()) {
    rocket.assumed.push_back(fmt::format("{}: as in {}.", whole, rocket.source));
  }
}

std::vector<std::string> changes(const Document& source, const sim::Vehicle& vehicle, const Document& made_file,
                                 const sim::Vehicle& made) {
  // Of these other sentences say so.
  constexpr std::array<std::string_view, 4> told{"mass_kg", "reference_area_m2", "damping_m2", "torque_m"};
  constexpr double same_share = 1e-3;
  std::vector<std::string> all;
  std::string lost;
  for (const VehicleField& field : input::vehicle_fields()) {
    if (!value_in(source, field) || field.key == "assumed") {
      continue;
    }
    if (!value_in(made_file, field)) {
      lost += fmt::format("{}{}.{}", lost.empty() ? "" : ", ", field.section, field.key);
    } else if ((field.section == "body" || field.section == "aerodynamics") && field.place.get != nullptr &&
               !is_one_of(told, field.key)) {
      const double from = field.place.get(vehicle, 0);
      const double to = field.place.get(made, 0);
      if (std::abs(to - from) > same_share * std::abs(from)) {
        all.push_back(fmt::format("Changed: {}.{}, from {} to {}{}", field.section, field.key,
                                  in_file(field, vehicle, 0, 6), in_file(field, made, 0, 6),
                                  field.key == "roll_inertia_kg_m2" ? ", the sum of the parts" : ""));
      }
    }
  }
  if (source.root()["body"]["name"] && vehicle.name != made.name) {
    all.push_back(fmt::format("Changed: body.name, from \"{}\" to \"{}\"", vehicle.name, made.name));
  }
  if (!lost.empty()) {
    all.push_back(fmt::format("Not taken over: {}. Add to vehicle.toml what holds for this rocket.", lost));
  }
  return all;
}

}  // namespace fantail::tool
