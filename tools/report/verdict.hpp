// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "result/answer.hpp"
#include "text/degrees.hpp"

namespace fantail::report {

/// Further from its settle point than this, a roll angle is not what anybody would call held.
inline constexpr double held_error_rad = text::radians(10.0);
/// A roll that was seen settled for less time than this is not judged to be held.
inline constexpr double least_judged_s = 1.0;

/// Nobody minds the last half second: near apogee there is no flow over the canards.
inline constexpr double near_apogee_s = 0.5;

enum class Outcome : std::uint8_t {
  held,  ///< the largest hold error is at most 10 deg, from first_settling_time_s() to apogee, and the roll rests
         ///< within the limit that is stated for it (Flight::rest_limit_rad) of its reference
  off_command,    ///< as steady, but resting farther from its reference than that
  outside_model,  ///< as steady, but the flight is beyond a flight::ModelEnd
  not_held,       ///< the hold error is more, before or after the end of control, or the canards ended at a limit
                  ///< smaller than the fin offset, or the rocket turned faster than the gyro's range
  oscillates,  ///< within 10 deg, but the canards keep swinging with nothing that excites them, or the linear loop is
               ///< unstable at some speed under control
  cut_short,   ///< control ended before apogee, or was not lost before the trajectory it was flown on ended
  not_judged,  ///< under control, but settled for less than a second, or without a known disturbance
  no_control,  ///< Controlling was never reached
  ascent_failed,  ///< whatever the roll: flight::BeforeBurnout::ascent_failed(), or unstable and tail first
};

/// All of them, for files and tables.
inline constexpr std::array outcomes{Outcome::held,        Outcome::not_held,      Outcome::oscillates,
                                     Outcome::cut_short,   Outcome::not_judged,    Outcome::no_control,
                                     Outcome::off_command, Outcome::outside_model, Outcome::ascent_failed};

/// Held as far as steadiness goes: wherever it rests, and whether or not the model holds.
[[nodiscard]] constexpr bool is_steady(Outcome outcome) {
  return outcome == Outcome::held || outcome == Outcome::off_command || outcome == Outcome::outside_model;
}

struct Verdict {
  Outcome outcome = Outcome::no_control;
  std::string text;                            ///< plain sentences
  bool ended_early = false;                    ///< whatever the outcome
  bool ended_by_tilt = false;                  ///< early, at the plan's tilt limit
  std::optional<double> allowed_tilt_end_s{};  ///< not early for Flight::tilt_end_before_apogee_s alone: the tilt limit
                                               ///< ended control so long before apogee
  std::optional<double> begun_on_guide_s{};    ///< control began so long before the rocket left its launch guide
  bool as_planned = false;      ///< no control, because the plan's gate stayed closed: nothing was asked of the roll
  bool roll_is_judged = false;  ///< there is a word about how well the roll was held, whatever became of it then
};

[[nodiscard]] Verdict verdict(const flight::Flight& flight, const Figures& figures);

/// Was the roll held as it was commanded? Undecided where that was not judged, or not within the model.
[[nodiscard]] result::Answer answer(const Verdict& verdict);

/// Of held flights, those that Verdict::allowed_tilt_end_s lets count as held.
class AllowedTiltEnds {
 public:
  void add(const std::optional<double>& before_apogee_s);
  /// "In 4 of 20 held runs the tilt limit ended control up to 7.35 s before apogee, which
  /// verdict.tilt_end_before_apogee_s allows", without a full stop; empty: in none. `flights`: what they are, "run".
  [[nodiscard]] std::string sentence(std::size_t held, std::string_view flights) const;

 private:
  std::size_t count_ = 0;
  double earliest_s_ = 0.0;
};

[[nodiscard]] std::string_view name(Outcome outcome);          ///< for files: "held"
[[nodiscard]] std::string_view display_name(Outcome outcome);  ///< for readers: "Held"

}  // namespace fantail::report
