// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "result/document.hpp"
#include "rules/pack.hpp"
#include "sim/scenario.hpp"

namespace fantail::rules {

enum class Outcome : std::uint8_t { pass, fail, blank, not_applicable, not_known, not_judged };
/// "PASS", "NOT KNOWN"
[[nodiscard]] std::string_view name(Outcome outcome);

/// What a pack is held against.
struct Subject {
  std::string what;         ///< "tasha3_launch2, one simulated flight"
  Findings found{};         ///< of every name that is known or for which a reason is known that it is not
  std::string why_missing;  ///< of every other name, a clause
  bool plan_alone = false;  ///< clauses that name a figure of a rocket or a flight are not judged
  std::string no_rocket{};  ///< why nothing is known of the rocket, and how to name it; empty: it is known
};

/// A launch and a flight of it.
[[nodiscard]] Subject subject_of(const sim::Scenario& scenario, const flight::Flight& flight);

struct Judged {
  Clause clause;
  Outcome outcome = Outcome::not_judged;
  std::vector<std::string> evidence{};  ///< "flight.burnout_s = 3.19 s", one for each name
};

/// Clause by clause. One of which a needed name is unknown is NOT KNOWN, unless the others decide it.
[[nodiscard]] std::vector<Judged> judge(const Pack& pack, const Subject& subject);

/// "3 of 9 clauses fail: ... Not judged: ..."; yes where some clause passes, none fails and none is not known.
[[nodiscard]] result::Verdict verdict(const std::vector<Judged>& judged);
/// And how to name a rocket that a clause needs: "The rocket is not known: ..."
[[nodiscard]] result::Verdict verdict(const std::vector<Judged>& judged, const Subject& subject);

/// Words that stand on everything that a pack says: what counts, and what it was compared with.
[[nodiscard]] std::string caution(const Pack& pack);

[[nodiscard]] result::Document answer(const Pack& pack, const Subject& subject, const std::vector<Judged>& judged,
                                      const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::rules
