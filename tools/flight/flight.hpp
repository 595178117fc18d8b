// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "core/tick_record.hpp"
#include "flight/before_burnout.hpp"
#include "flight/model_end.hpp"
#include "flight/path.hpp"

namespace fantail::flight {

/// What only a simulator knows.
struct Truth {
  double roll_angle_rad = 0.0;
  double roll_rate_rad_s = 0.0;
  double canard_rad = 0.0;  ///< mean of the four, as the air sees them
  double height_m = 0.0;
  double speed_m_s = 0.0;
  double disturbance_rad = 0.0;                 ///< equivalent fin offset u_d
  std::optional<double> geometric_roll_rad{};   ///< as a camera sees it; in six degrees of freedom only
  std::optional<double> tilt_from_guide_rad{};  ///< as Row has it; empty along a straight line; no file has it
  std::optional<std::array<double, core::canard_count>> shafts_rad{};  ///< where each canard stands; no file has it
};

/// One tick as it stands in flight.csv, in SI and radians. Empty, or not a number: nobody knew it at that tick.
struct Row {
  double time_s = 0.0;  ///< 0 at lift-off (tunnel: at control start); pad rows are negative
  core::Phase phase = core::Phase::safe;
  double roll_angle_rad = 0.0;
  double roll_rate_rad_s = 0.0;
  double reference_rad = 0.0;
  double excitation_rad = 0.0;
  double offset_estimate_rad = 0.0;  ///< of the fin offset; the law takes it off the command
  double command_rad = 0.0;
  std::optional<bool> saturated = false;
  std::array<std::optional<double>, core::canard_count> commands_rad{};  ///< shaft angles; empty: servo output off
  std::array<std::optional<double>, core::canard_count> encoders_rad{};
  std::optional<double> canard_rad{};  ///< encoder mean
  double specific_force_m_s2 = 0.0;    ///< axial
  double height_m = 0.0;
  double speed_m_s = 0.0;
  std::optional<Truth> truth{};
  std::optional<double> tilt_from_guide_rad{};  ///< of the long axis, from where it pointed at rest; no file has it
  std::optional<double> height_error_m{};       ///< of height_m by an accelerometer alone, at most; no file has it
  bool replayed = true;  ///< false: of a logged tick to which no replay leads; only what the log itself holds is known
};

/// The truth where it is known.
[[nodiscard]] inline double best_known(const Row& row, double Truth::* truth, double estimate) {
  return row.truth && std::isfinite((*row.truth).*truth) ? (*row.truth).*truth : estimate;
}

/// From the clock on which a flight was flown to that of its rows: lift-off is known only after the pad rows.
struct Clock {
  std::optional<double> zero_s{};  ///< what becomes 0, to the microsecond; empty: the two are one
  [[nodiscard]] double operator()(double time_s) const {
    return zero_s ? std::round((time_s - *zero_s) * 1e6) / 1e6 : time_s;
  }
};

/// What the instruments of a wind tunnel read.
struct TunnelReading {
  double time_s = 0.0;  ///< on the rows' clock
  double fan_rpm = 0.0;
  double wind_speed_m_s = 0.0;
};

/// Times on the rows' clock. Empty: it did not happen, or nobody could see it.
struct Events {
  std::optional<double> liftoff_s{};
  std::optional<double> detected_s{};
  std::optional<double> guide_clear_s{};  ///< the rocket truly left the guide; control starts some way above it
  std::optional<double> dormant_s{};      ///< the plan's gate was still closed beyond the guide
  std::optional<double> control_start_s{};
  std::optional<double> control_end_s{};
  std::optional<double> burnout_s{};
  std::optional<double> apogee_s{};
  std::optional<double> parachute_s{};  ///< it truly began to open
};

/// The events by the names that files give them.
struct NamedEvent {
  const char* name;
  std::optional<double> Events::* time_s;
};
inline constexpr std::array named_events{NamedEvent{"liftoff_s", &Events::liftoff_s},
                                         NamedEvent{"detected_s", &Events::detected_s},
                                         NamedEvent{"guide_clear_s", &Events::guide_clear_s},
                                         NamedEvent{"dormant_s", &Events::dormant_s},
                                         NamedEvent{"control_start_s", &Events::control_start_s},
                                         NamedEvent{"burnout_s", &Events::burnout_s},
                                         NamedEvent{"control_end_s", &Events::control_end_s},
                                         NamedEvent{"apogee_s", &Events::apogee_s},
                                         NamedEvent{"parachute_s", &Events::parachute_s}};

/// Of those that begin a phase; null for a phase that no event begins.
[[nodiscard]] std::optional<double>* event_of(Events& events, core::Phase phase);

/// Notes the event that a change of phase is. Control that a gate interrupts has ended, unless it goes on.
void note_phase_event(Events& events, core::Phase from, core::Phase to, double time_s);

/// A roll state that the scenario set by hand, because no model explains it.
struct ImposedRoll {
  double time_s = 0.0;
  double angle_rad = 0.0;
  double rate_rad_s = 0.0;
};

struct PhaseChange {
  double time_s = 0.0;
  core::Phase phase = core::Phase::safe;
  std::optional<core::PhaseReason> reason = core::PhaseReason::power_on;  ///< empty: a table does not tell
};

/// What the barometer was good for in flight, tick after tick alike.
struct BarometerSpell {
  core::BarometerState state = core::BarometerState::silent;
  double from_s = 0.0;
  double to_s = 0.0;  ///< its last tick
};

/// What the sensors could not measure of a flight. Times are the first of each; empty: it did not happen.
struct Unmeasured {
  std::optional<double> spin_from_s{};         ///< after detection the rocket turned faster than the gyro's range
  double spin_for_s = 0.0;                     ///< in all
  double spin_rad_s = 0.0;                     ///< the end of the range, with the sense of the turn
  std::optional<double> silent_from_s{};       ///< under control, canards at trim because no rate was known
  double silent_for_s = 0.0;                   ///< in all
  std::optional<double> speed_bound_from_s{};  ///< from here on the estimates of height and speed are lower bounds
};

/// How far the roll loop is from oscillating at one air speed; see stability::Margins.
struct LoopMargin {
  double speed_m_s = 0.0;
  double phase_margin_rad = 0.0;
  std::optional<double> gain_margin{};
  std::optional<double> crossover_rad_s{};  ///< the highest frequency that the loop can follow; empty: not in the file
};

/// How far the canards deflect together, as the air sees them, at the largest roll commands; see sim::DeflectionRange.
struct CanardReach {
  double lowest_rad = 0.0;
  double highest_rad = 0.0;
};

/// The processor was reset or stood still in flight: no tick is on record between these two.
struct Outage {
  double from_s = 0.0;           ///< of the last tick before it
  std::optional<double> to_s{};  ///< of the first after it; empty: there is none
  std::string cause;             ///< hal::ResetCause, by its name; empty: it was not reset
  bool resumed = false;          ///< the flight went on after it
};

struct CanardVerdictChange {
  double time_s = 0.0;
  std::size_t canard = 0;  ///< 0 to 3; people count from 1
  core::CanardVerdict verdict = core::CanardVerdict::healthy;
};

/// What a table from elsewhere may leave out. Whoever flies or replays a flight knows all of it.
struct Known {
  bool plan = true;
  bool phase = true;
  bool saturation = true;
};

/// What a roll model of the flight is identified with: of the vehicle as it flew, every --set included.
struct FlownAirframe {
  std::string vehicle;       ///< its name
  std::string vehicle_file;  ///< as the scenario names it: a shipped name or a path
  double roll_inertia_kg_m2 = 0.0;
  double reference_area_m2 = 0.0;
  std::vector<std::string> changes{};  ///< of the scenario, on the command line
  /// kg m2 over time on the rows' clock, straight in between. Empty: it was the same throughout.
  std::map<double, double> roll_inertia_course{};
  bool grows_with_mach = false;  ///< damping and torque were simulated to grow by Prandtl and Glauert's rule
};

/// The wind of a simulated flight in six degrees of freedom, without gusts and turbulence.
struct MeanWind {
  double speed_m_s = 0.0;  ///< at `height_m` above ground
  double from_rad = 0.0;   ///< where it comes from: 0 north, a quarter of a turn east
  double height_m = 0.0;
};

/// One flown flight: all that flight.csv, summary.json and report.html are made from.
struct Flight {
  std::string scenario;
  std::string vehicle;
  std::optional<FlownAirframe> airframe;  ///< of a simulated one
  std::string plan_name;
  std::string version;                ///< of the program that flew it
  std::string command;                ///< that makes its files again, as it is typed; empty: nobody knows
  std::optional<std::uint64_t> seed;  ///< of a simulated one
  std::vector<std::string> changes;   ///< of the scenario, on the command line: "controller.canard_limit_deg=9"
  bool tunnel = false;
  core::FlightPlan plan{};
  std::optional<ImposedRoll> imposed_roll;
  std::string why_not_armed;        ///< a clause; empty: it was armed, or nobody knows
  std::size_t differing_ticks = 0;  ///< of a log: its replay does not give what was recorded
  std::vector<std::string> notes;   ///< faults and assumptions, a sentence each
  Events events;
  std::vector<PhaseChange> phase_changes;
  std::optional<core::Vector3> gyro_bias_rad_s;  ///< that the law took off; empty: it never flew, or a table
  std::vector<CanardVerdictChange> canard_verdict_changes;
  std::vector<BarometerSpell> barometer_spells;  ///< since launch detection; empty: the plan asks for none, or a table
  Unmeasured unmeasured;
  std::optional<BeforeBurnout> before_burnout;  ///< of a simulated flight; empty: nothing of it happened
  std::vector<Outage> outages;
  std::vector<LoopMargin> loop_margins;     ///< at some speeds under control, the worst among them; empty: not computed
  std::optional<CanardReach> canard_reach;  ///< of the simulated canards; empty: nobody knows
  std::string why_uncontrollable;           ///< as stability has it; empty: the canards obey the law, or nobody knows
  double left_by_fins = 1.0;                ///< of a roll torque of the canards: stability::left_in_the_end()
  /// Of one canard turned by a radian: moment about the burnt-out centre of gravity over 1/2 rho v^2; empty: unknown.
  std::optional<double> side_moment_m3;
  /// Over the air speed, in the air at the ground: the least and the largest roll rate in resonance with the pitch.
  /// Empty: not a simulated launch, or nothing is known of the pitch.
  std::optional<std::array<double, 2>> resonance_1_m;
  double rest_limit_rad = 10.0 * std::numbers::pi / 180.0;  ///< farther from R than this the roll may not rest
  double tilt_end_before_apogee_s = 0.5;                    ///< sooner before apogee the tilt limit is an early end
  Extremes extremes{};                                      ///< of a simulated one, not in the tunnel
  std::vector<Row> rows;
  Clock clock{};                               ///< that set_time_zero() has put all times by
  std::optional<double> last_tick_s{};         ///< that note_tick() was given
  std::size_t rows_per_line = 1;               ///< flight.csv has the first of so many rows
  std::vector<TunnelReading> tunnel_readings;  ///< empty in flight
  std::vector<PathPoint> path;                 ///< empty along a straight line, in the tunnel, and of real flights
  PathFrame path_frame = PathFrame::compass;
  std::optional<MeanWind> wind;
  std::optional<double> trajectory_end_s;      ///< of the trajectory that was flown on, where it ends before apogee
  std::vector<TurnPoint> turning;              ///< of a simulated run on the gimbal or on pins; else empty
  std::vector<FreeRollPoint> without_control;  ///< of a simulated flight with control, or empty; the rows' clock
  std::vector<std::byte> log;                  ///< what the avionics recorded itself; empty: nothing
  Known known;
};

/// A tick as a row, without truth. An encoder angle that is not finite counts as missing.
[[nodiscard]] Row row(const core::TickRecord& record, double time_s);

/// Notes what can be seen from records alone: phase changes, canard verdicts, what was not measured, the outage by
/// which a timing fault ended a flight, and the events detected, control start and control end. The other events and
/// everything else are the caller's to fill in.
void note_tick(Flight& flight, const core::TickRecord& record, double time_s);

/// Notes a tick and appends its row.
void add_tick(Flight& flight, const core::TickRecord& record, double time_s, const std::optional<Truth>& truth);

/// Control that an outage has ended, because nothing was resumed after it, ended when it came.
void end_control_with_outage(Flight& flight);

/// Puts every time of the flight on the rows' clock, and notes the clock.
void set_time_zero(Flight& flight, double zero_s);

/// Slower, the canards have next to no air, and nothing is asked of the roll.
inline constexpr double slowest_held_m_s = 20.0;

/// The largest roll command this plan allows: the plan limit, or the hard limit where that is smaller.
[[nodiscard]] double canard_limit_rad(const core::FlightPlan& plan);

/// Where the plan counts the tilt of its limit from: "the vertical" or "the launch guide".
[[nodiscard]] std::string_view tilt_origin(const core::FlightPlan& plan);

/// How far the canards can deflect in one sense of roll (the sign of `sense`), mean of the four: what the simulation
/// says, or else each as far as the smallest of plan limit, hard limit and its mechanical stop in the plan lets it,
/// from its trim. Below zero: not even at the largest command is it in that sense.
[[nodiscard]] double authority_rad(const Flight& flight, double sense);

/// How much farther all canards could go, or come back, than the deflection that balances this offset; the smaller of
/// the two. Below zero: they cannot balance it. Canards that are broken or trimmed may reach to one side only.
[[nodiscard]] double authority_margin_rad(const Flight& flight, double offset_rad);

/// Does the law do anything about the roll?
[[nodiscard]] bool has_gains(const core::FlightPlan& plan);

/// Does the law take an estimate of the fin offset off its command, so that it comes to rest at its reference?
[[nodiscard]] bool rejects_offset(const core::FlightPlan& plan);

/// False where the plan's gains go by a speed that this row does not have.
[[nodiscard]] bool gains_are_known(const Row& row, const Flight& flight);

/// Where the loop comes to rest: R + u_d / kp as published, kp by the gain schedule; R where the plan rejects the
/// offset. Empty without truth, for a gain of zero, and where anything of that is not known.
[[nodiscard]] std::optional<double> settle_point_rad(const Row& row, const core::FlightPlan& plan);
/// Likewise, and empty for a flight whose plan is not known. Where the fins take back a part of the torque, the command
/// must be larger: R + u_d / (kp left_by_fins). Where they take back all of it or more, roll comes to rest nowhere, and
/// it is counted from where it should.
[[nodiscard]] std::optional<double> settle_point_rad(const Row& row, const Flight& flight);

}  // namespace fantail::flight
