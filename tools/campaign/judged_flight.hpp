// SPDX-License-Identifier: MIT
#pragma once

#include "flight/flight.hpp"
#include "fly/fly_scenario.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"
#include "sim/scenario.hpp"

namespace fantail::campaign {

/// What a flight report says of a flight, of which no row was kept.
struct JudgedFlight {
  flight::Flight flight;    ///< without rows
  report::Figures figures;  ///< but for Figures::side_deflection
  report::Verdict verdict;
};

/// Flies a scenario and judges it on the way. `take` gets each row, too.
[[nodiscard]] JudgedFlight fly_and_judge(const sim::Scenario& scenario, const fly::TakeRow& take = {});

}  // namespace fantail::campaign
