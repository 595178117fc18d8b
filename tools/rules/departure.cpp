// SPDX-License-Identifier: MIT
#include "rules/departure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <ranges>

#include <fmt/format.h>

#include "flight/trim.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

/// Longer than any encoder needs for its next answer.
constexpr double longest_silence_s = 0.05;

std::optional<double> from_trim_deg(const std::optional<double>& angle_rad, const core::CanardPlan& canard) {
  return angle_rad ? std::optional{std::abs(text::degrees(*angle_rad - static_cast<double>(canard.trim.radians())))}
                   : std::nullopt;
}

bool goes_by_truth(const flight::Row& row) { return row.truth && row.truth->shafts_rad; }

void keep_largest(Departure& found, const flight::Row& row, const core::FlightPlan& plan) {
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const core::CanardPlan& canard = plan.canards.each[i];
    found.largest_command_deg =
        std::max(found.largest_command_deg, from_trim_deg(row.commands_rad[i], canard).value_or(0.0));
    found.largest_angle_deg =
        std::max(found.largest_angle_deg, from_trim_deg(canard_rad(row, i), canard).value_or(0.0));
  }
}

bool command_is_away(const flight::Row& row, const core::FlightPlan& plan, std::size_t canard) {
  return from_trim_deg(row.commands_rad[canard], plan.canards.each[canard]).value_or(0.0) > command_tolerance_deg;
}

}  // namespace

double height_m(const flight::Row& row) { return row.truth ? row.truth->height_m : row.height_m; }
Number height_range_m(const flight::Row& row) {
  const double error_m = row.truth ? 0.0 : row.height_error_m.value_or(0.0);
  return {height_m(row) - error_m, height_m(row) + error_m};
}
double speed_m_s(const flight::Row& row) { return row.truth ? row.truth->speed_m_s : row.speed_m_s; }

std::optional<double> canard_rad(const flight::Row& row, std::size_t canard) {
  return goes_by_truth(row) ? std::optional{(*row.truth->shafts_rad)[canard]} : row.encoders_rad[canard];
}

std::string who_is_away(const flight::Row& row, const core::FlightPlan& plan) {
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (command_is_away(row, plan, i)) {
      return fmt::format("command of canard {}", i + 1);
    }
    if (from_trim_deg(canard_rad(row, i), plan.canards.each[i]).value_or(0.0) > flight::encoder_tolerance_deg) {
      return fmt::format("{} of canard {}", goes_by_truth(row) ? "shaft" : "encoder", i + 1);
    }
  }
  return {};
}

bool is_commanded_away(const flight::Row& row, const core::FlightPlan& plan) {
  return std::ranges::any_of(std::views::iota(std::size_t{0}, core::canard_count),
                             [&](std::size_t i) { return command_is_away(row, plan, i); });
}

std::optional<double> silent_from_s(std::span<const flight::Row> rows, double from_s, double to_s) {
  std::array<double, core::canard_count> seen_s{};
  seen_s.fill(-infinity);
  for (const flight::Row& row : rows) {
    if (row.time_s > to_s) {
      break;
    }
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      if (row.time_s >= from_s && row.time_s - seen_s[i] > longest_silence_s) {
        return std::max(from_s, seen_s[i]);
      }
      if (canard_rad(row, i)) {
        seen_s[i] = row.time_s;
      }
    }
  }
  return std::nullopt;
}

Departure departure(std::span<const flight::Row> rows, const core::FlightPlan& plan, double from_s) {
  Departure found;
  bool begins = true;
  for (const flight::Row& row : rows) {
    if (begins) {
      found = {.since_s = row.time_s};
    }
    found.until_s = row.time_s;
    found.by_truth = goes_by_truth(row);
    const std::string away = who_is_away(row, plan);
    if (!away.empty() && row.time_s >= from_s) {
      found.time_s = row.time_s;
      found.row = row;
      found.what = away;
      break;
    }
    begins = !away.empty();
    keep_largest(found, row, plan);
  }
  found.hidden_from_s = silent_from_s(rows, from_s, found.until_s);
  if (found.hidden_from_s) {
    const auto after = std::ranges::upper_bound(rows, *found.hidden_from_s, {}, &flight::Row::time_s);
    found.hidden_row = after == rows.begin() ? *after : *std::prev(after);
  }
  return found;
}

std::string departure_text(const Departure& found) {
  const auto shown = [](double deg) { return text::brief(std::ceil(deg * 100.0) / 100.0, 2); };
  std::string said =
      fmt::format("from {} to {} s, commands within {} deg and {} within {} deg of trim", text::fixed(found.since_s, 2),
                  text::fixed(found.until_s, 2), shown(found.largest_command_deg),
                  found.by_truth ? "shafts" : "encoders", shown(found.largest_angle_deg));
  if (found.hidden_from_s) {
    said += fmt::format("; from {} s on {}rows are missing", text::fixed(*found.hidden_from_s, 2),
                        found.by_truth ? "" : "encoders or ");
  }
  return found.time_s ? said + "; then the " + found.what + " leaves it" : said;
}

}  // namespace fantail::rules
