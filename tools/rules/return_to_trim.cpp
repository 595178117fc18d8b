// SPDX-License-Identifier: MIT
#include "rules/return_to_trim.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "flight/trim.hpp"
#include "rules/departure.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

Finding tilt_off_trim(const flight::Flight& flight, std::span<const flight::Row> ascent,
                      const std::vector<Hole>& missing) {
  double largest_deg = 0.0;
  std::string when = "no canard is commanded away from trim";
  for (const flight::Row& row : ascent) {
    if (row.time_s < 0.0 || !is_commanded_away(row, flight.plan)) {
      continue;
    }
    const std::optional<double>& tilt_rad = row.truth ? row.truth->tilt_from_guide_rad : row.tilt_from_guide_rad;
    if (!tilt_rad) {
      return {{},
              row.truth ? "the simulated motion is straight and cannot tilt; allowed: flight.motion = \"six_dof\", or "
                          "a trajectory that tilts"
                        : fmt::format("the record has no attitude at {} s", text::fixed(row.time_s, 2))};
    }
    if (const double tilt_deg = text::degrees(*tilt_rad); tilt_deg >= largest_deg) {
      largest_deg = tilt_deg;
      when = fmt::format("at {} s, {}", text::fixed(row.time_s, 2),
                         row.truth ? "the true tilt" : "as the avionics estimated it");
    }
  }
  return {Number{largest_deg, missing.empty() ? largest_deg : infinity},
          when + (missing.empty() ? "" : "; ") + missing_text(missing)};
}

Finding off_trim_after_abort(const flight::Flight& flight, std::span<const flight::Row> ascent,
                             const std::vector<Hole>& missing) {
  const auto abort = std::ranges::find_if(flight.phase_changes, [](const flight::PhaseChange& change) {
    return change.phase == core::Phase::finished && change.reason == core::PhaseReason::aborted;
  });
  if (abort == flight.phase_changes.end()) {
    return missing.empty() ? Finding{false, "no abort in the flight"}
                           : Finding{{}, "no abort in the flight, as far as it is on record; " + missing_text(missing)};
  }
  const std::string aborted = fmt::format("abort at {} s; ", text::fixed(abort->time_s, 2));
  const double from_s = abort->time_s + flight::longest_return_s;
  const Departure found = departure(ascent, flight.plan, from_s);
  if (found.time_s) {
    return {true, fmt::format("{}{} is away from trim at {} s", aborted, found.what, text::fixed(*found.time_s, 2))};
  }
  if (found.until_s < from_s) {
    return {{}, aborted + "no row of the ascent is half a second after it"};
  }
  std::vector<Hole> hidden = missing;
  std::erase_if(hidden, [from_s](const Hole& hole) { return hole.to_s <= from_s; });
  return {found.hidden_from_s || !hidden.empty() ? std::nullopt : std::optional<Known>{false},
          aborted + departure_text(found) + (hidden.empty() ? "" : "; ") + missing_text(hidden)};
}

}  // namespace

Findings return_to_trim(const flight::Flight& flight, std::span<const flight::Row> ascent,
                        const std::vector<Hole>& missing) {
  return {{"flight.tilt_off_trim_deg", tilt_off_trim(flight, ascent, missing)},
          {"flight.off_trim_after_abort", off_trim_after_abort(flight, ascent, missing)}};
}

}  // namespace fantail::rules
