// SPDX-License-Identifier: MIT
#include "rules/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/flight_plan_fields.hpp"
#include "input/plan_file.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

constexpr std::array texts{
    FigureText{"law.commands_roll_only", Type::flag, "", 0, "the flight law commands roll, and neither pitch nor yaw"},
    FigureText{"law.steers_to_place", Type::flag, "", 0, "the flight law steers towards a place"},

    FigureText{"flight.apogee_m", Type::number, "m", 0, "greatest height above the launch site"},
    FigureText{"flight.top_speed_m_s", Type::number, "m/s", 1, "greatest speed through the air; of a log, the log's"},
    FigureText{"flight.largest_mach", Type::number, "", 2, "greatest Mach number"},
    FigureText{"flight.max_q_s", Type::number, "s", 2, "time of the largest dynamic pressure"},
    FigureText{"flight.burnout_s", Type::number, "s", 2, "time of the last thrust"},
    FigureText{"flight.control_start_s", Type::number, "s", 2, "time at which control begins: the gate has opened"},
    FigureText{"flight.control_start_height_m", Type::number, "m", 1, "height at which control begins"},
    FigureText{"flight.left_trim", Type::flag, "", 0,
               "a canard leaves trim after lift-off, by its command or its angle"},
    FigureText{"flight.left_trim_s", Type::number, "s", 2, "time at which the first canard leaves trim"},
    FigureText{"flight.left_trim_height_m", Type::number, "m", 1, "height at which the first canard leaves trim"},
    FigureText{"flight.canard_before_control_deg", Type::number, "deg", 2,
               "largest angle of a canard from its trim between lift-off and control"},
    FigureText{"flight.tilt_off_trim_deg", Type::number, "deg", 1,
               "largest angle from the launch guide while a canard is commanded away from trim"},
    FigureText{"flight.off_trim_after_abort", Type::flag, "", 0,
               "half a second after an abort or later, a canard is away from trim"},
    FigureText{"flight.tilt_at_rest_deg", Type::number, "deg", 1, "angle of the launch guide from the vertical"},

    FigureText{"rocket.mass_kg", Type::number, "kg", 3, "mass at lift-off"},
    FigureText{"rocket.total_impulse_n_s", Type::number, "N s", 0, "total impulse of the motor"},
    FigureText{"rocket.margin_calibres", Type::number, "calibres", 2,
               "least static margin from lift-off to burn-out, canards at trim"},
    FigureText{"rocket.margin_at_stop_calibres", Type::number, "calibres", 2,
               "the same with one canard at its mechanical stop, attached or stalled"},
    FigureText{"rocket.attack_at_stop_deg", Type::number, "deg", 1,
               "angle of attack at which the rocket then comes to rest, after burn-out"},
    FigureText{"rocket.margin_at_launch_percent", Type::number, "%", 1,
               "static margin at lift-off, of the rocket's length"},
    FigureText{"rocket.least_margin_percent", Type::number, "%", 1,
               "least static margin from lift-off to burn-out, of the rocket's length"},
    FigureText{"rocket.largest_margin_percent", Type::number, "%", 1,
               "largest static margin from lift-off to burn-out, of the rocket's length"},
    FigureText{"rocket.damping_ratio", Type::number, "", 3,
               "damping ratio of pitch by the airframe alone, from lift-off to after burn-out"},
};

using core::FieldKind;
using core::PlanField;

std::string name_of(const PlanField& field) { return fmt::format("plan.{}.{}", field.section, field.key); }

Known value_of(const input::TomlNode& node) {
  if (const auto number = node.number()) {
    return Number{*number, *number};
  }
  if (const auto flag = node.flag()) {
    return *flag;
  }
  return node.text().value_or("");
}

/// Of a list.
std::optional<Known> together(const std::vector<input::TomlNode>& nodes) {
  std::optional<Known> all;
  for (const input::TomlNode& node : nodes) {
    const Known one = value_of(node);
    if (!all) {
      all = one;
    } else if (auto* range = std::get_if<Number>(&*all)) {
      const Number& number = std::get<Number>(one);
      *range = {std::min(range->low, number.low), std::max(range->high, number.high)};
    } else if (*all != one) {
      return std::nullopt;
    }
  }
  return all;
}

}  // namespace

std::span<const FigureText> figure_texts() { return texts; }

const FigureText* find_figure(std::string_view name) {
  const auto* found = std::ranges::find(texts, name, &FigureText::name);
  return found == texts.end() ? nullptr : found;
}

std::map<std::string, Meaning> plan_meanings() {
  std::map<std::string, Meaning> all;
  for (const PlanField& field : core::flight_plan_fields()) {
    const Type type = field.kind == FieldKind::choice ? Type::text
                      : field.kind == FieldKind::flag ? Type::flag
                                                      : Type::number;
    all[name_of(field)] = {.type = type, .words = {field.choices.begin(), field.choices.end()}};
  }
  return all;
}

Findings of_plan(const core::FlightPlan& plan) {
  Findings all;
  const input::Document document = input::plan_document(plan);
  for (const PlanField& field : core::flight_plan_fields()) {
    const input::TomlNode node = document.root()[field.section][field.key];
    const auto list = node.elements();
    const std::optional<Known> known = list ? together(*list) : value_of(node);
    all[name_of(field)] = {known, known ? "" : list->empty() ? "the list is empty" : "the canards differ"};
  }
  return all;
}

Findings of_law() {
  return {{"law.commands_roll_only", {true, "by design: all canards follow one roll command"}},
          {"law.steers_to_place",
           {false, "by design: neither plan nor flight law has a place or a direction to steer to"}}};
}

std::string value_text(std::string_view name, const std::optional<Known>& known) {
  if (!known) {
    return "not known";
  }
  if (const auto* is = std::get_if<bool>(&*known)) {
    return *is ? "yes" : "no";
  }
  if (const auto* words = std::get_if<std::string>(&*known)) {
    return "\"" + *words + "\"";
  }
  const FigureText* figure = find_figure(name);
  const auto& [low, high] = std::get<Number>(*known);
  const std::string unit = figure != nullptr && !figure->unit.empty() ? fmt::format(" {}", figure->unit) : "";
  const auto number = [&](double value) {
    return figure != nullptr ? text::fixed(value, figure->decimals) : text::brief(value, 6);
  };
  if (!std::isfinite(high)) {
    return number(low) + unit + " or more";
  }
  if (!std::isfinite(low)) {
    return number(high) + unit + " or less";
  }
  const std::string ends[]{number(low), number(high)};
  return (ends[0] == ends[1] ? ends[0] : ends[0] + " to " + ends[1]) + unit;
}

}  // namespace fantail::rules
