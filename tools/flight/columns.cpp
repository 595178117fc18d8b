// SPDX-License-Identifier: MIT
#include "flight/columns.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "text/degrees.hpp"

namespace fantail::flight {
namespace {

using Unit = Column::Unit;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

template <double Row::* member>
constexpr Column measured(std::string_view name, Unit unit) {
  return {name, unit, false, [](const Row& row) { return row.*member; },
          [](Row& row, double value) { row.*member = value; }};
}

template <std::array<std::optional<double>, core::canard_count> Row::* member, std::size_t canard>
constexpr Column of_canard(std::string_view name) {
  return {name, Unit::degrees, false, [](const Row& row) { return (row.*member)[canard].value_or(unknown); },
          [](Row& row, double value) { (row.*member)[canard] = value; }};
}

template <double Truth::* member>
constexpr Column truth(std::string_view name, Unit unit) {
  return {name, unit, true, [](const Row& row) { return row.truth ? (*row.truth).*member : unknown; },
          [](Row& row, double value) {
            if (!row.truth) {
              row.truth = Truth{unknown, unknown, unknown, unknown, unknown, unknown};
            }
            (*row.truth).*member = value;
          }};
}

constexpr std::array all{
    measured<&Row::time_s>("time_s", Unit::as_named),
    measured<&Row::roll_angle_rad>("roll_angle_deg", Unit::degrees),
    measured<&Row::roll_rate_rad_s>("roll_rate_deg_s", Unit::degrees),
    measured<&Row::reference_rad>("reference_deg", Unit::degrees),
    measured<&Row::excitation_rad>("excitation_deg", Unit::degrees),
    measured<&Row::offset_estimate_rad>("offset_estimate_deg", Unit::degrees),
    measured<&Row::command_rad>("command_deg", Unit::degrees),
    Column{"saturated", Unit::flag, false,
           [](const Row& row) { return row.saturated ? (*row.saturated ? 1.0 : 0.0) : unknown; },
           [](Row& row, double value) { row.saturated = value != 0.0; }},
    of_canard<&Row::commands_rad, 0>("command_1_deg"),
    of_canard<&Row::commands_rad, 1>("command_2_deg"),
    of_canard<&Row::commands_rad, 2>("command_3_deg"),
    of_canard<&Row::commands_rad, 3>("command_4_deg"),
    of_canard<&Row::encoders_rad, 0>("encoder_1_deg"),
    of_canard<&Row::encoders_rad, 1>("encoder_2_deg"),
    of_canard<&Row::encoders_rad, 2>("encoder_3_deg"),
    of_canard<&Row::encoders_rad, 3>("encoder_4_deg"),
    Column{"canard_deg", Unit::degrees, false, [](const Row& row) { return row.canard_rad.value_or(unknown); },
           [](Row& row, double value) { row.canard_rad = value; }},
    measured<&Row::specific_force_m_s2>("specific_force_m_s2", Unit::as_named),
    measured<&Row::height_m>("height_m", Unit::as_named),
    measured<&Row::speed_m_s>("speed_m_s", Unit::as_named),
    truth<&Truth::roll_angle_rad>("true_roll_angle_deg", Unit::degrees),
    truth<&Truth::roll_rate_rad_s>("true_roll_rate_deg_s", Unit::degrees),
    truth<&Truth::canard_rad>("true_canard_deg", Unit::degrees),
    truth<&Truth::height_m>("true_height_m", Unit::as_named),
    truth<&Truth::speed_m_s>("true_speed_m_s", Unit::as_named),
    truth<&Truth::disturbance_rad>("true_disturbance_deg", Unit::degrees),
    // In six degrees of freedom only: write_csv leaves it out elsewhere.
    Column{"true_geometric_roll_deg", Unit::degrees, true,
           [](const Row& row) { return row.truth ? row.truth->geometric_roll_rad.value_or(unknown) : unknown; },
           [](Row& row, double value) {
             row.truth = row.truth.value_or(Truth{unknown, unknown, unknown, unknown, unknown, unknown});
             row.truth->geometric_roll_rad = value;
           }},
};

}  // namespace

double Column::written(const Row& row) const { return unit == Unit::degrees ? text::degrees(get(row)) : get(row); }

std::span<const Column> columns() { return all; }

std::span<const Column> columns_of(const Flight& flight) {
  const auto any = [&flight](auto is_so) { return std::ranges::any_of(flight.rows, is_so); };
  if (!any([](const Row& row) { return row.truth.has_value(); })) {
    return std::span{all}.first(static_cast<std::size_t>(std::ranges::find(all, true, &Column::is_true) - all.begin()));
  }
  const bool is_geometric = any([](const Row& row) { return row.truth && row.truth->geometric_roll_rad; });
  return is_geometric ? std::span{all} : std::span{all}.first(all.size() - 1);
}

const Column* find_column(std::string_view name) {
  const auto found = std::ranges::find(all, name, &Column::name);
  return found == all.end() ? nullptr : &*found;
}

Row unknown_row() {
  Row row;
  row.roll_angle_rad = row.roll_rate_rad_s = row.reference_rad = row.excitation_rad = row.offset_estimate_rad =
      row.command_rad = unknown;
  row.specific_force_m_s2 = row.height_m = row.speed_m_s = unknown;
  row.saturated.reset();
  return row;
}

}  // namespace fantail::flight
