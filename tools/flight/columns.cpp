// SPDX-License-Identifier: MIT
#include "flight/columns.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

constexpr double millionths = 1e6;
// Below it a double still holds halves.
constexpr double most_millionths = 4e15;

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

SixDecimals::SixDecimals(double value) {
  // Written so that not-a-number goes the slow way.
  if (std::abs(value) * millionths < most_millionths) {
    const double product = value * millionths;
    const double lost = std::fma(value, millionths, -product);  // product + lost is exact
    double nearest = std::nearbyint(product);
    const double rest = (product - nearest) + lost;
    if (std::abs(rest) != 0.5) {  // std::to_chars below decides a tie
      nearest += rest > 0.5 ? 1.0 : rest < -0.5 ? -1.0 : 0.0;
      const auto whole = static_cast<std::int64_t>(nearest);
      auto digits = static_cast<std::uint64_t>(whole < 0 ? -whole : whole);
      for (int place = 0; place < 7 || digits > 0; ++place) {
        if (place == 6) {
          text_[--begin_] = '.';
        }
        text_[--begin_] = static_cast<char>('0' + digits % 10);
        digits /= 10;
      }
      if (whole < 0) {
        text_[--begin_] = '-';
      }
      return;
    }
  }
  std::array<char, longest> out{};
  const auto end = std::to_chars(out.data(), out.data() + out.size(), std::abs(value) < 0.5e-6 ? 0.0 : value,
                                 std::chars_format::fixed, 6);
  begin_ = longest - static_cast<std::size_t>(end.ptr - out.data());
  std::copy(out.data(), end.ptr, text_.begin() + static_cast<std::ptrdiff_t>(begin_));
}

std::string_view SixDecimals::brief() const {
  std::string_view digits = text();
  if (const std::size_t last = digits.find_last_not_of('0');
      last != std::string_view::npos && digits.find('.') < digits.size()) {
    digits = digits.substr(0, digits[last] == '.' ? last : last + 1);
  }
  return digits;
}

}  // namespace fantail::flight
