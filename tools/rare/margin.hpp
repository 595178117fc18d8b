// SPDX-License-Identifier: MIT
#pragma once

#include "campaign/flown_run.hpp"
#include "campaign/question.hpp"

namespace fantail::rare {

/// Why a question cannot be searched, a clause; empty: it can. A question about another outcome than held has no
/// margin: nothing tells how far a flight is from it.
[[nodiscard]] std::string objection_to(const campaign::Question& question);

/// Of a flight that fails by something that no figure measures: never armed for want of a sensor, canards that
/// oscillate. Nothing leads there, and such flights are found by chance only.
inline constexpr double failed_by_an_event = -1.0;

/// How far a flight is from failing a question: below zero exactly where Question::is_failed_by() says so.
///
/// Of a figure it is its distance from the bound, in its unit. Of "outcome=held" it is the smallest of 1 - figure /
/// limit over the largest hold error, the rest error, the Mach number, and the gyro bias that the self-test refuses.
[[nodiscard]] double margin(const campaign::Question& question, const sim::Scenario& scenario,
                            const campaign::FlownRun& run, const campaign::JudgedFlight& judged);

}  // namespace fantail::rare
