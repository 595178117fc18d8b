// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "sim/scenario.hpp"
#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"
#include "tune/flights.hpp"
#include "tune/request.hpp"
#include "tune/search.hpp"

namespace fantail::tune {

/// The linear loop at one speed, over the airframes of the spread. A loop whose gain never reaches one cannot swing: it
/// counts as a phase margin of half a turn.
struct LoopAtSpeed {
  double speed_m_s = 0.0;
  double least_phase_margin_rad = 0.0;
  std::optional<double> crossover_rad_s{};  ///< of the vehicle as it is; empty: its gain never reaches one
  stability::RollLoop open{};               ///< likewise
};

/// One plan: its loop, and the vehicle as it is flown by it without excitation.
struct Judged {
  core::FlightPlan plan{};
  std::vector<LoopAtSpeed> loop{};
  stability::MarginAtSpeed least{};    ///< over spread and speeds
  std::optional<double> settling_s{};  ///< the slowest of spread, at median and top speed; empty: longer than 10 s
  flight::Flight flight{};             ///< without excitation
  std::optional<double> noise_rad{};   ///< command_noise_rad() of it
};

/// What tuning came to.
struct Tuning {
  std::string scenario{};
  std::string vehicle{};
  Request request{};
  SpeedsFlown speeds{};
  double servo_lag_s = 0.0;
  double delay_s = 0.0;
  double rest_limit_rad = 0.0;
  double largest_offset_rad = 0.0;  ///< |u_d| of the scenario
  double reach_rad = 0.0;           ///< that the canards can balance
  std::string limit{};              ///< what ends it: "9 degree canard limit"
  std::string why_none{};           ///< a sentence; empty: there is a law
  Judged before{};
  std::optional<Judged> after{};  ///< empty as far as no law was found
  std::string bound_by{};         ///< bound_sentence() of its law
  bool is_measured = false;       ///< the scenario names a tunnel result
  std::vector<Pair> pairs{};
  std::optional<Sum> old_alone{};  ///< flights by the old plan over the spread, where no law was found
  std::string alternative{};       ///< a sentence with a command at its end: of another kind of law that was tried and
                                   ///< is better, or of lower demands that a law meets which loses no flight; or empty
  /// Where no law was found: the same with the demand that is missed lowered to what a law of its kind has, as far as
  /// that is worth asking for.
  std::optional<Request> within_reach{};

  [[nodiscard]] Sum flown_before() const { return sum(pairs, &Pair::before); }
  [[nodiscard]] Sum flown_after() const { return sum(pairs, &Pair::after); }
  /// No flight that the old plan holds, or keeps steady elsewhere, is lost in number, so the new plan may be handed
  /// out.
  [[nodiscard]] bool is_proposed() const;
  /// The worst of any flight.
  [[nodiscard]] flight::Extremes extremes() const;
  /// No law was found, and the old plan holds every rocket of the spread with a phase margin that a prediction
  /// requires, or that was asked for.
  [[nodiscard]] bool is_old_enough() const;
  /// The flights were nearer to their reference, by more than chance would make them.
  [[nodiscard]] bool is_better() const;
};

/// What goes on, for a line of progress.
enum class Stage : std::uint8_t { searching, choosing, flying };
using Look = std::function<void(Stage stage, std::size_t done)>;

/// Searches and flies. Where that gives no better plan, and a law could, tries the other kinds of law that a person
/// could ask for, too. Throws text::Error for a scenario without air, or in which control never begins. `look` may
/// throw to give up.
[[nodiscard]] Tuning tune(const sim::Scenario& scenario, const Request& request, const Look& look);

}  // namespace fantail::tune
