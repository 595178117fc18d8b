// SPDX-License-Identifier: MIT
#include "rules/departure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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

struct Watch {
  Departure found{};
  std::array<std::optional<double>, core::canard_count> seen_s{};
  double last_height_m = 0.0;

  void look_for_silence(const flight::Row& row) {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const double since_s = std::max(0.0, seen_s[i].value_or(0.0));
      const bool is_silent = !seen_s[i] || row.time_s - *seen_s[i] > longest_silence_s;
      if (row.time_s >= 0.0 && is_silent && !found.hidden_from_s) {
        found.hidden_from_s = since_s;
        found.hidden_height_m = last_height_m;
      }
      if (row.encoders_rad[i]) {
        seen_s[i] = row.time_s;
      }
    }
    last_height_m = height_m(row);
  }

  void keep_largest(const flight::Row& row, const core::FlightPlan& plan) {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const core::CanardPlan& canard = plan.canards.each[i];
      found.largest_command_deg =
          std::max(found.largest_command_deg, from_trim_deg(row.commands_rad[i], canard).value_or(0.0));
      found.largest_encoder_deg =
          std::max(found.largest_encoder_deg, from_trim_deg(row.encoders_rad[i], canard).value_or(0.0));
    }
  }
};

bool command_is_away(const flight::Row& row, const core::FlightPlan& plan, std::size_t canard) {
  return from_trim_deg(row.commands_rad[canard], plan.canards.each[canard]).value_or(0.0) > command_tolerance_deg;
}

}  // namespace

double height_m(const flight::Row& row) { return row.truth ? row.truth->height_m : row.height_m; }
double speed_m_s(const flight::Row& row) { return row.truth ? row.truth->speed_m_s : row.speed_m_s; }

std::string who_is_away(const flight::Row& row, const core::FlightPlan& plan) {
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (command_is_away(row, plan, i)) {
      return fmt::format("command of canard {}", i + 1);
    }
    if (from_trim_deg(row.encoders_rad[i], plan.canards.each[i]).value_or(0.0) > flight::encoder_tolerance_deg) {
      return fmt::format("encoder of canard {}", i + 1);
    }
  }
  return {};
}

bool is_commanded_away(const flight::Row& row, const core::FlightPlan& plan) {
  return std::ranges::any_of(std::views::iota(std::size_t{0}, core::canard_count),
                             [&](std::size_t i) { return command_is_away(row, plan, i); });
}

Departure departure(std::span<const flight::Row> rows, const core::FlightPlan& plan) {
  Watch watch;
  bool begins = true;
  for (const flight::Row& row : rows) {
    watch.found.since_s = begins ? row.time_s : watch.found.since_s;
    watch.found.until_s = row.time_s;
    begins = false;
    watch.look_for_silence(row);
    const std::string away = who_is_away(row, plan);
    if (!away.empty() && row.time_s >= 0.0) {
      watch.found.time_s = row.time_s;
      watch.found.height_m = height_m(row);
      watch.found.what = away;
      break;
    }
    begins = !away.empty();
    if (row.time_s >= 0.0) {
      watch.keep_largest(row, plan);
    }
  }
  return watch.found;
}

std::string departure_text(const Departure& found) {
  const auto shown = [](double deg) { return text::brief(std::ceil(deg * 100.0) / 100.0, 2); };
  std::string said = fmt::format("from {} to {} s, commands within {} deg and encoders within {} deg of trim",
                                 text::fixed(found.since_s, 2), text::fixed(found.until_s, 2),
                                 shown(found.largest_command_deg), shown(found.largest_encoder_deg));
  if (found.hidden_from_s) {
    said += fmt::format("; from {} s on encoders or rows are missing", text::fixed(*found.hidden_from_s, 2));
  }
  return found.time_s ? said + "; then the " + found.what + " leaves it" : said;
}

}  // namespace fantail::rules
