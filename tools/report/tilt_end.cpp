// SPDX-License-Identifier: MIT
#include <algorithm>

#include <fmt/core.h>

#include "report/verdict.hpp"
#include "report/verdict_parts.hpp"
#include "text/number.hpp"

// An end of control at the plan's tilt limit that only the scenario keeps from being an early one.
namespace fantail::report {

std::optional<double> allowed_tilt_end_s(const flight::Flight& flight, const Figures& f) {
  const bool by_tilt =
      !flight.phase_changes.empty() && flight.phase_changes.back().reason == core::PhaseReason::tilted_too_far;
  return by_tilt && f.ended_before_apogee_s.value_or(0.0) > near_apogee_s ? f.ended_before_apogee_s : std::nullopt;
}

void AllowedTiltEnds::add(const std::optional<double>& before_apogee_s) {
  count_ += before_apogee_s ? 1 : 0;
  earliest_s_ = std::max(earliest_s_, before_apogee_s.value_or(0.0));
}

std::string AllowedTiltEnds::sentence(std::size_t held, std::string_view flights) const {
  return count_ == 0 ? ""
                     : fmt::format(
                           "In {} of {} the tilt limit ended control up to {} s before apogee, which "
                           "verdict.tilt_end_before_apogee_s allows",
                           count_, text::counted(held, fmt::format("held {}", flights)), text::fixed(earliest_s_, 2));
}

}  // namespace fantail::report
