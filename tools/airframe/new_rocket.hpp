// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "airframe/model/build_up.hpp"
#include "core/flight_plan.hpp"
#include "sim/vehicle.hpp"
#include "stability/gain_choice.hpp"
#include "text/output_folder.hpp"

namespace fantail::airframe {

/// Gains for the first simulated flights of a rocket whose roll model is only computed from its shape.
struct FirstGains {
  stability::Gains gains;
  core::GainSchedulePlan
      schedule{};  ///< where it brings the roll back much faster at the speed at which that is slowest
  /// Where the roll would rest farther than two degrees from its reference without: as fast as leaves the phase margin.
  std::optional<double> observer_bandwidth_rad_s{};
  core::RollModelPlan roll_model{};  ///< of the observer
  double rest_rad = 0.0;             ///< how far these gains alone let the fin offset keep the roll from its reference
  /// With them the loop has a phase margin of 30 degrees at every speed of a straight ascent, with damping and torque
  /// anywhere in their ranges. If not, no gains that a plan may have do, and these are those of the plan.
  bool reach_phase_margin = false;
  double begin_speed_m_s = 0.0;   ///< where control may begin
  double lowest_speed_m_s = 0.0;  ///< of control, until apogee: 20 m/s, or where it begins
  double highest_speed_m_s = 0.0;
  double servo_lag_s = 0.0;
};

[[nodiscard]] stability::Gains gains_of(const core::FlightPlan& plan);

/// For `vehicle` with the roll model that its shape gives: the gains nearest to those of `plan`. With an observer
/// where such gains leave the roll more than two degrees from its reference, because of fins that are as crooked as
/// canards at this angle, and with a schedule where the speeds differ much. Empty without canards, and where
/// control never begins in a straight ascent.
[[nodiscard]] std::optional<FirstGains> first_gains(const sim::Vehicle& vehicle, const model::BuildUp& computed,
                                                    const core::FlightPlan& plan, double fin_offset_rad);

/// Why a rocket with canards has none, for a person.
[[nodiscard]] std::string why_none(const core::FlightPlan& plan);

/// What was asked of them, for a person.
[[nodiscard]] std::string sentence(const FirstGains& first);

/// The plan of a new rocket with these gains, or without them with those of `usual`.
[[nodiscard]] std::string plan_file(const std::optional<FirstGains>& first, const core::FlightPlan& usual);

/// To six digits: no formula of a new rocket knows more.
[[nodiscard]] std::string rounded(double value);

/// A rocket that nobody has flown yet.
struct NewRocket {
  std::string name;
  /// With a geometry, a mass, a drag area and a motor; its roll plant and airframe are not looked at.
  sim::Vehicle vehicle;
  std::string motor_file;  ///< as a vehicle file names it
  std::string source;      ///< what its shape was read from
  std::vector<std::string> assumed;
  std::optional<text::NamedFile> motor{};  ///< that lies beside the vehicle from now on; none: a shipped one
  /// Lines "key = value" of which the shape says nothing, in the order of a vehicle file.
  struct Kept {
    std::string section;
    std::string lines{};
  };
  std::vector<Kept> kept{};
};

/// The fin offset that a new scenario begins with: of fins that are canted, their cant.
struct FinOffset {
  double angle_deg;
  std::string sentence;
};
[[nodiscard]] FinOffset fin_offset(const model::BuildUp& computed);

/// The scenario of a new rocket: in six degrees of freedom and wind, or along a straight line. With a spread for each
/// number that the shape gives within a range, and for what nobody knows before a launch.
[[nodiscard]] std::string scenario_file(const FinOffset& offset, bool in_six_dof, bool has_canards);

/// What decides whether canards can hold this rocket, a sentence each: how crooked its fins may be, how fast the
/// canards turn it. Empty without canards, or where they never control it.
[[nodiscard]] std::vector<std::string> what_decides(const model::BuildUp& computed,
                                                    const std::optional<FirstGains>& first, double canard_limit_rad);

struct NewFiles {
  std::vector<text::NamedFile> files;
  std::string gains;                   ///< a sentence on where those of the plan come from; empty without canards
  std::vector<std::string> decides{};  ///< as what_decides()
};

/// vehicle.toml, plan.toml and scenario.toml: roll model, stability and inertia as the shape gives them, gains that
/// suit them, everything that was not measured listed as assumed. The vehicle has an [airframe] where masses and
/// propellant say the centre of gravity.
[[nodiscard]] NewFiles files_of(const NewRocket& rocket);

}  // namespace fantail::airframe
