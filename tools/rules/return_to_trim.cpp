// SPDX-License-Identifier: MIT
#include "rules/return_to_trim.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "flight/trim.hpp"
#include "rules/departure.hpp"
#include "rules/record.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

Finding tilt_off_trim(const flight::Flight& flight, std::span<const flight::Row> ascent, const std::string& missing) {
  double largest_deg = 0.0;
  std::string when = "no canard is commanded away from trim";
  for (const flight::Row& row : ascent) {
    if (row.time_s < 0.0 || !is_commanded_away(row, flight.plan)) {
      continue;
    }
    if (!row.tilt_from_guide_rad) {
      return {{}, "the record has no attitude at " + text::fixed(row.time_s, 2) + " s"};
    }
    if (const double tilt_deg = text::degrees(*row.tilt_from_guide_rad); tilt_deg >= largest_deg) {
      largest_deg = tilt_deg;
      when = fmt::format("at {} s, as the avionics estimated it", text::fixed(row.time_s, 2));
    }
  }
  return {Number{largest_deg, missing.empty() ? largest_deg : std::numeric_limits<double>::infinity()},
          when + (missing.empty() ? "" : "; ") + missing};
}

/// Up to the greatest height: later a parachute shakes the canards.
std::span<const flight::Row> rows_after(const flight::Flight& flight, double from_s) {
  const auto first = std::ranges::lower_bound(flight.rows, from_s, {}, &flight::Row::time_s);
  const auto highest = std::ranges::max_element(first, flight.rows.end(), {}, height_m);
  return {first, highest};
}

bool shows_every_canard(const flight::Row& row) {
  return std::ranges::all_of(row.encoders_rad, [](const auto& angle_rad) { return angle_rad.has_value(); });
}

Finding off_trim_after_abort(const flight::Flight& flight, const std::string& missing) {
  const auto abort = std::ranges::find_if(flight.phase_changes, [](const flight::PhaseChange& change) {
    return change.phase == core::Phase::finished && change.reason == core::PhaseReason::aborted;
  });
  if (abort == flight.phase_changes.end()) {
    return missing.empty() ? Finding{false, "no abort in the flight"}
                           : Finding{{}, "no abort in the flight, as far as it is on record; " + missing};
  }
  const std::string aborted = fmt::format("abort at {} s; ", text::fixed(abort->time_s, 2));
  const double from_s = abort->time_s + flight::longest_return_s;
  const auto rows = rows_after(flight, from_s);
  if (std::ranges::none_of(rows, shows_every_canard)) {
    return {{}, aborted + "no row of the ascent after it shows all canards"};
  }
  for (const flight::Row& row : rows) {
    if (const std::string away = who_is_away(row, flight.plan); !away.empty()) {
      return {true, fmt::format("{}{} is away from trim at {} s", aborted, away, text::fixed(row.time_s, 2))};
    }
  }
  const std::vector<Hole> hidden = holes(rows, from_s, rows.back().time_s);
  return {hidden.empty() ? std::optional<Known>{false} : std::nullopt,
          fmt::format("{}at trim from {} to {} s{}{}", aborted, text::fixed(from_s, 2),
                      text::fixed(rows.back().time_s, 2), hidden.empty() ? "" : "; ", missing_text(hidden))};
}

}  // namespace

Findings return_to_trim(const flight::Flight& flight, std::span<const flight::Row> ascent, const std::string& missing) {
  return {{"flight.tilt_off_trim_deg", tilt_off_trim(flight, ascent, missing)},
          {"flight.off_trim_after_abort", off_trim_after_abort(flight, missing)}};
}

}  // namespace fantail::rules
