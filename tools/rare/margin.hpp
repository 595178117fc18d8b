// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "campaign/flown_run.hpp"
#include "campaign/question.hpp"
#include "runs/row_text.hpp"

namespace fantail::rare {

/// Why a question cannot be searched, a clause; empty: it can. A question about another outcome than held has no
/// margin: nothing tells how far a flight is from it.
[[nodiscard]] std::string objection_to(const campaign::Question& question);

/// What a search for flights that are not held follows, in words.
inline constexpr std::array<std::string_view, 10> followed{"hold error",
                                                           "rest error",
                                                           "fin offset against the canards",
                                                           "phase margin",
                                                           "end of control by tilt",
                                                           "Mach number",
                                                           "static margin",
                                                           "angle of attack",
                                                           "gyro bias",
                                                           "bias of the second gyro"};

/// How much is left to each limit, in the unit of its figure: below zero it is passed; empty: there is no such figure.
/// Of a question about a figure the first alone, its distance from the bound.
struct Left {
  std::array<std::optional<double>, followed.size()> of{};
};
inline void fields(runs::RowText& text, Left& left) { text(left.of); }
[[nodiscard]] Left left_of(const campaign::Question& question, const sim::Scenario& scenario,
                           const campaign::FlownRun& run, const campaign::JudgedFlight& judged);

/// The margin of a flight that fails by something that no figure measures: never armed for want of a sensor, canards
/// that oscillate, no such figure. Nothing leads there, so the levels of a search leave such flights out: how frequent
/// they are the plain flights say.
inline constexpr double failed_by_an_event = std::numeric_limits<double>::infinity();
/// Of one that noise has tipped over a limit which its gyro bias had all but reached.
inline constexpr double just_failed = -std::numeric_limits<double>::min();

/// Makes one number of all that is left. Figures of different units and spreads are comparable as so many of their own
/// standard deviations: a limit that no flight ever comes near must not hide the one that is reached first.
class Yardstick {
 public:
  /// Of flights that were drawn plainly. Of a question about a figure the unit stays that of the figure.
  Yardstick(const campaign::Question& question, std::span<const Left> plain);

  /// How far a flight is from failing: below zero exactly where it fails by a figure.
  [[nodiscard]] double margin(const Left& left, bool is_failed) const;
  /// Which of `followed` is nearest to its limit, or farthest beyond; empty: none has a figure.
  [[nodiscard]] std::optional<std::size_t> nearest(const Left& left) const;

 private:
  [[nodiscard]] double just_met_at(Left left) const;

  std::array<std::optional<double>, followed.size()> unit_{};  ///< empty: it is the same in all flights
};

}  // namespace fantail::rare
