// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_phase.hpp"
#include "core/flight_plan.hpp"
#include "faults/fault_table.hpp"
#include "faults/shaft.hpp"

// Judges a flight with a fault by what truly was: roll angle, canard shafts and pulses as the world has them, and the
// phase. Shares nothing with the flight report, and uses no estimate of the avionics.
namespace fantail::faults {

/// One millisecond of a flight.
struct Moment {
  double time_s = 0.0;  ///< after ignition
  core::Phase phase = core::Phase::safe;
  bool ticked = true;     ///< the processor had a tick; else phase and commands are those of the last one
  bool completed = true;  ///< and that tick came to its end
  /// Shaft angles that the pulses on the servo lines ask for; empty: no pulse.
  std::array<std::optional<double>, core::canard_count> commanded_rad{};
  std::array<double, core::canard_count> true_shaft_rad{};
  double true_roll_rad = 0.0;
};

/// What every command and every shaft is held to.
struct Limits {
  std::array<double, core::canard_count> trim_rad{};
  std::array<double, core::canard_count> limit_rad{};  ///< smallest of plan, hard limit and mechanical stop
  ShaftLimits shafts{};
  bool any_turn = false;   ///< with capture a roll that is whole turns away is the same
  double capture_s = 0.0;  ///< so long after the twin's control began its roll is only on the way, and not compared
  /// Control may end so long before the twin's. A twin with a barometer notices apogee a little later than the
  /// accelerometer alone.
  double early_s = 0.1;
};
[[nodiscard]] Limits limits_of(const sim::Scenario& scenario);

/// The same flight without the fault, moment by moment.
struct Twin {
  std::vector<double> true_roll_rad{};
  std::vector<core::Phase> phases{};
  /// The first and the last moment under control; empty: it never was.
  std::optional<std::size_t> control_begin{};
  std::optional<std::size_t> control_end{};

  void add(const Moment& moment);
};

/// When the fault was there, in seconds after ignition, and what it allows the shafts meanwhile.
struct FaultTime {
  double begin_s = 0.0;
  double end_s = 0.0;  ///< after the flight: it stayed
  Shafts shafts{};
};

/// What a flight came to.
struct Findings {
  bool armed = false;
  bool controlled = false;
  bool lasted = false;     ///< control went on until at most Limits::early_s before the twin's ended
  double apart_deg = 0.0;  ///< largest difference from the twin's roll, from the fault on while the twin controls
  double apart_with_turns_deg = 0.0;  ///< likewise, whole turns counted whatever Limits::any_turn says
  double apart_meanwhile_deg = 0.0;   ///< likewise, while this one controls, too
  double apart_settled_deg = 0.0;     ///< likewise, from settle_s after the end of the fault on
  double apart_at_end_deg = 0.0;      ///< likewise, in the last moment that the twin controls
  double trim_after_s = 0.0;          ///< from the begin of the fault to the last command off trim; 0: none was
  double stands_after_s = 0.0;        ///< likewise, to when the last shaft that obeys truly stood off trim
  double travel_s = 0.0;              ///< ShaftLimits, which an outcome allows beside its own time
  core::Phase last_phase = core::Phase::safe;
  std::string breach{};   ///< of what holds for every flight; empty: none
  double breach_s = 0.0;  ///< after ignition

  /// In the end the roll was within what is allowed all the time.
  [[nodiscard]] bool came_back(const Expected& expected) const {
    return lasted && breach.empty() && apart_at_end_deg <= expected.within_deg;
  }
  [[nodiscard]] bool is(Outcome outcome, const Expected& expected) const;
  /// The first allowed one that it is; empty: none, or a breach.
  [[nodiscard]] std::optional<Outcome> outcome(const Expected& expected) const;
  /// Of a flight that is none of the allowed: what it was, in a clause.
  [[nodiscard]] std::string what_it_was() const;
};

/// Is given a flight, moment after moment. The breaches it looks for:
///   - a command beyond its limit, or one that is no angle;
///   - a command off trim in Armed, Launched, Dormant or Finished, or, after ignition, one in Safe that moves away from
///   trim;
///   - a shaft that truly stands beyond its limit, stands off trim in Armed, Launched, Dormant or Finished for longer
///   than it
///     takes to get there, or, in Safe after ignition, moves away from trim; what a failed servo may do is Shaft's;
///   - a tick that did not come to its end;
///   - Controlling that came from another phase than Launched or Dormant, or after a reset, from another than those or
///     Controlling; anything but a reset after Finished.
class Judge {
 public:
  /// `tunnel`: control may begin from Armed.
  Judge(const Limits& limits, const Twin& twin, const FaultTime& fault, double settle_s, bool tunnel = false)
      : limits_{limits}, twin_{twin}, fault_{fault}, settle_s_{settle_s}, tunnel_{tunnel} {}

  void add(const Moment& moment);
  [[nodiscard]] Findings findings() const;

 private:
  void breach(const Moment& moment, const std::string& what);
  void look_at_commands(const Moment& moment);
  void look_at_shafts(const Moment& moment);
  void look_at_phase(const Moment& moment);
  void look_at_roll(const Moment& moment);

  const Limits& limits_;
  const Twin& twin_;
  FaultTime fault_;
  double settle_s_;
  bool tunnel_;
  Findings findings_{};
  std::size_t moments_ = 0;
  std::optional<std::size_t> control_end_{};
  core::Phase phase_ = core::Phase::safe;       ///< of the last tick
  core::Phase before_gap_ = core::Phase::safe;  ///< the last one before the processor was down
  bool last_ticked_ = false;
  bool after_gap_ = false;                                 ///< since then, only Safe
  std::array<double, core::canard_count> off_trim_rad_{};  ///< of commands, in the moment before
  std::optional<double> rests_from_s_{};                   ///< the shafts have been asked to be at trim since then
  std::optional<std::array<double, core::canard_count>> least_off_rad_{};  ///< of shafts, since Safe began
};

}  // namespace fantail::faults
