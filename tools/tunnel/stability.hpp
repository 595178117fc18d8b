// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "result/answer.hpp"
#include "result/document.hpp"
#include "text/layout.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/swing.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// What must be known of the rocket to make a margin of a stiffness.
struct PitchAirframe {
  double transverse_inertia_kg_m2 = 0.0;
  double normal_force_slope_per_rad = 0.0;
  double cross_section_m2 = 0.0;
  double diameter_m = 0.0;
  double mass_kg = 0.0;
  /// Of the body's own lift: coefficient times area seen from the side, and how far in front of the centre of gravity.
  double body_lift_area_m2 = 0.0;
  double body_lift_arm_m = 0.0;
};

/// One push and what followed it.
struct StabilitySwing {
  double speed_m_s = 0.0;
  SwingResult result{};
  std::optional<Unsteadiness> air{};  ///< empty: nobody knows
};

/// Stiffness over inertia against the square of the speed: the slope is the air's, the intercept what holds the rocket
/// without wind.
struct StiffnessLine {
  Estimate slope_per_m2{};
  Estimate intercept_per_s2{};
  std::optional<double> chi_square{};  ///< of the distances from the line; from three speeds on
};

enum class StabilityVerdict : std::uint8_t {
  stable,    ///< the margin is above zero with all of its 95 % interval, even if the pins explain all that holds the
             ///< rocket without wind
  unstable,  ///< a swing grows, or the margin is below zero with all of it, likewise
  unsure,
};

struct Stability {
  std::vector<StabilitySwing> swings{};
  std::optional<StiffnessLine> line{};  ///< from two different speeds on
  /// From the pins back to the centre of pressure, and what holds the rocket without wind; with the line.
  std::optional<Estimate> margin_m{};
  double taken_by_body_lift_m = 0.0;  ///< of the margin, at most, at the angles of these swings
  std::optional<Estimate> without_wind_n_m_per_rad{};
  StabilityVerdict verdict = StabilityVerdict::unsure;
  std::string sentence{};
  std::vector<std::string> remarks{};
};

/// Of a 95 % interval, for an error that is normally distributed.
inline constexpr double reach_95 = 1.959964;

[[nodiscard]] Stability examine_stability(std::vector<StabilitySwing> swings, const PitchAirframe& airframe,
                                          double density_kg_m3);

struct StabilityHeading {
  std::vector<std::string> logs{};
  std::string signal{};
  std::string airframe_source{};
  PitchAirframe airframe{};
  double density_kg_m3 = 0.0;
};

/// Is it stable? What `fantail tunnel stability` says, with swings.csv.
[[nodiscard]] result::Document stability_answer(const StabilityHeading& heading, const Stability& stability,
                                                const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_stability_fields();

}  // namespace fantail::tunnel
