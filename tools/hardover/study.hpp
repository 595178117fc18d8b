// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "page/chart.hpp"
#include "result/document.hpp"
#include "runs/folder.hpp"
#include "runs/row_text.hpp"
#include "sim/scenario.hpp"

namespace fantail::hardover {

enum class Failure : std::uint8_t {
  hard_over,   ///< stands at a stop from one instant to the next, and stays there; both stops are flown
  cut_pulses,  ///< its pulses are cut short at random for cut_s, as a reset can do
};
inline constexpr double cut_s = 0.02;

/// What one canard that fails does to a flight in six degrees of freedom while the others go on controlling:
/// for the person who clears the range.
///
/// Side force of the canards: F = 1/2 rho v^2 A |sum of the four deflections as vectors across the axis|, with A of a
/// canard as in sim::CanardAerodynamics::side_area_m2. Bending moment at a station behind them: F times the distance,
/// and none in front of them; without the relief by the inertia of what lies in front of it and without the lift of the
/// nose at an angle of attack.
struct Options {
  Failure failure = Failure::hard_over;
  double step_s = 0.25;                ///< between the instants at which the canard fails, above zero
  std::optional<double> coupler_m{};   ///< where the bending moment is wanted, from the tip of the nose
  unsigned threads = 0;                ///< 0: as many as the machine has
  const runs::Folder* kept = nullptr;  ///< of finished flights; null: none are kept
};

/// Of one flight, from the instant of the failure on.
struct Effect {
  std::size_t canard;                           ///< 0 to 3
  double stop_rad;                              ///< at which it stands, with its sign; 0 with cut pulses
  double from_s;                                ///< after ignition
  double side_force_n = 0.0;                    ///< largest, of the canards
  double pressure_pa = 0.0;                     ///< dynamic pressure at that instant
  std::optional<double> angle_of_attack_rad{};  ///< largest, while the rocket is faster than slowest_m_s; empty: never
  double roll_rate_rad_s = 0.0;                 ///< largest, either way
  double rolled_rad = 0.0;  ///< largest difference from the healthy rocket's roll angle at the same time
  double turned_rad = 0.0;  ///< largest angle between the two velocities at the same time, both that fast
  double apogee_m = 0.0;
  double away_m = 0.0;                 ///< horizontal distance of its apogee from the healthy rocket's
  std::optional<double> moment_n_m{};  ///< at the coupler
  double apogee_east_m = 0.0;          ///< over ground, from the foot of the guide, as the next
  double apogee_north_m = 0.0;
  std::optional<double> landing_east_m{};  ///< likewise; empty: not known, as without a parachute
  std::optional<double> landing_north_m{};
  std::optional<double> landing_away_m{};        ///< horizontal distance from where the healthy rocket lands
  std::optional<double> landing_from_guide_m{};  ///< likewise from the foot of the guide; follows from the row
  double fall_from_guide_m = 0.0;                ///< see Study::sound_fall_from_guide_m
};
inline void fields(runs::RowText& text, Effect& effect) {
  text(effect.canard, effect.stop_rad, effect.from_s, effect.side_force_n, effect.pressure_pa,
       effect.angle_of_attack_rad, effect.roll_rate_rad_s, effect.rolled_rad, effect.turned_rad, effect.apogee_m,
       effect.away_m, effect.moment_n_m, effect.apogee_east_m, effect.apogee_north_m, effect.landing_east_m,
       effect.landing_north_m, effect.landing_away_m, effect.fall_from_guide_m);
}

/// Slower, an angle in the flow says little.
inline constexpr double slowest_m_s = 20.0;

struct Study {
  std::string scenario;
  std::string vehicle;
  std::string plan;
  std::uint64_t seed;
  core::CanardFaultPolicy policy;
  bool has_gate;  ///< the plan lets the canards wait for more than the guide
  double side_area_m2;
  double position_m;  ///< of the canards
  double stop_rad;
  std::optional<double> stall_rad;  ///< as the vehicle states it
  double first_s;                   ///< the instants: from the end of the guide ...
  double last_s;                    ///< ... to apogee
  double sound_apogee_m;
  double sound_apogee_east_m;  ///< over ground, from the foot of the guide, as the next
  double sound_apogee_north_m;
  std::optional<double> sound_landing_east_m;  ///< likewise
  std::optional<double> sound_landing_north_m;
  bool has_parachute;  ///< else nothing is known of the landing
  /// Where a fall without parachute, drag, lift and wind ends that begins at apogee, or at burn-out where that is
  /// later: horizontal distance from the foot of the guide. Drag makes it shorter; lift and wind can make it longer.
  double sound_fall_from_guide_m;
  std::optional<double> sound_angle_of_attack_rad;  ///< likewise
  double sound_roll_rate_rad_s;                     ///< largest, either way, from the end of the guide to apogee
  std::string beyond_model;  ///< how far the healthy rocket is beyond the roll model (flight/model_end.hpp); empty: not
  Options options;
  std::size_t instants = 0;
  std::vector<Effect> effects{};  ///< by canard, then by stop, the positive one first, then by time
  result::Made made{};            ///< the caller's

  /// The largest of each figure, wherever it stands.
  [[nodiscard]] Effect worst() const;
};

/// Throws text::Error for a scenario that does not launch a rocket.
void require_free_flight(const sim::Scenario& scenario);

/// Flies the scenario in six degrees of freedom: once as it is and once for each canard, stop and instant. Where the
/// vehicle does not say canard_side_area_m2 and canard_position_m they come from its shape and its roll torque. `look`:
/// how many of how many flights are done. Throws text::Error when the vehicle says neither, has no airframe, does not
/// lift off, or does not reach as far as the coupler.
[[nodiscard]] Study fly(sim::Scenario scenario, const Options& options,
                        const std::function<void(std::size_t done, std::size_t of)>& look);

/// As a plan has it: "share".
[[nodiscard]] std::string_view name_of(core::CanardFaultPolicy policy);

/// Where the apogees of all flights lie over ground.
[[nodiscard]] page::Chart apogee_map(const Study& study);
/// Where those land whose landing is known; empty: none.
[[nodiscard]] std::optional<page::Chart> landing_map(const Study& study);
/// Answers nothing with yes or no: it measures.
[[nodiscard]] result::Document answer(const Study& study);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_fields();

}  // namespace fantail::hardover
