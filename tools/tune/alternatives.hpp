// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "sim/scenario.hpp"
#include "tune/tuning.hpp"

namespace fantail::tune {

// Where a search has found no plan that is better than the old one: what else a person could ask for, tried before it
// is said, in Tuning::alternative.

/// Gives a tuning the law that its request asks for, and the flights with it.
using SearchAndFly = std::function<void(Tuning& tuning)>;

/// Says which of the other kinds of law flies best, if one is better than the old plan.
void try_other_kinds(Tuning& tuning, const sim::Scenario& scenario, const SearchAndFly& search_and_fly);

/// Asks a law of the same kind for what the search found: once, and where that misses the other demand, once more.
/// Names these demands if the new plan loses no flight.
void try_lower_demands(Tuning& tuning, const SearchAndFly& search_and_fly);

}  // namespace fantail::tune
