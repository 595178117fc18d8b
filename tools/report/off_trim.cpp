// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "flight/trim.hpp"
#include "report/verdict_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::report {

std::string commanded_to_trim(const flight::Flight& flight, double from_s) {
  std::string text = "canards commanded to trim";
  const auto first = std::ranges::lower_bound(flight.rows, from_s + flight::longest_return_s, {}, &flight::Row::time_s);
  const auto highest = std::ranges::max_element(first, flight.rows.end(), {}, [](const flight::Row& row) {
    return flight::best_known(row, &flight::Truth::height_m, row.height_m);
  });
  if (!flight.known.plan || highest == flight.rows.end()) {
    return text;
  }
  const double until_s = flight.events.apogee_s.value_or(highest->time_s);  // later a parachute shakes the canards
  std::array<double, core::canard_count> largest_deg{};
  for (auto row = first; row != flight.rows.end() && row->time_s <= until_s; ++row) {
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      const auto trim_rad = static_cast<double>(flight.plan.canards.each[i].trim.radians());
      largest_deg[i] =
          std::fmax(largest_deg[i], std::abs(text::degrees(row->encoders_rad[i].value_or(trim_rad) - trim_rad)));
    }
  }
  const char* before = "; by encoder, ";
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (largest_deg[i] > flight::encoder_tolerance_deg) {
      text += fmt::format("{}canard {} stood up to {} deg away", before, i + 1, text::fixed(largest_deg[i], 1));
      before = ", ";
    }
  }
  return text;
}

}  // namespace fantail::report
