// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "flight/path.hpp"
#include "report/activity.hpp"
#include "report/figures.hpp"
#include "result/field.hpp"
#include "text/bearing.hpp"

// Every figure of a flight, with its key in summary.json.
namespace fantail::report::fields {

namespace u = result::units;
using result::Cell;
inline constexpr result::Unit turns{"", "turns"}, turns_of{"_turns", "turns"}, hertz{"_hz", "Hz"},
    calibres{"_calibres", "calibres"};

using F = Figures;
inline constexpr auto figures = result::fields<F>({
    {"apogee", "apogee", u::m, 1, &F::apogee_m, "greatest height above the site: true where the truth is known"},
    {"max_speed", "top speed", u::m_s, 1, &F::max_speed_m_s,
     "over ground where the flight has a path; else true speed through the air, or that of the log"},
    {"control_start_height", "height at control start", u::m, 2, &F::control_start_height_m, "likewise"},
    {"control_time", "time under control", u::s, 2, &F::control_time_s,
     "from its first tick to its last, without the time in which the plan's gate had closed again"},
    {"saturated_fraction", "canards at their limit", u::percent, 1, &F::saturated_fraction,
     "share of the time under control with the command at its limit"},
    {"largest_hold_error", "largest hold error", u::deg, 1, &F::largest_hold_error_rad,
     "largest distance of the roll from where this law settles, once it has settled"},
    {"mean_hold_error", "mean hold error", u::deg, 2, &F::mean_hold_error_rad, "mean of the same"},
    {"judged_time", "time judged", u::s, 2, &F::judged_time_s, "time over which the hold error is measured"},
    {"rest_error", "rests from its command", u::deg, 1, &F::rest_error_rad,
     "largest distance from the reference, of the mean roll over each settled step and of the settle points in it"},
    {"mean_reference_error", "mean distance from the command", u::deg, 1, &F::mean_reference_error_rad,
     "mean of |phi - R| over all time under control"},
    {"largest_disturbance", "largest fin offset", u::deg, 1, &F::largest_disturbance_rad,
     "true u_d of largest magnitude under control"},
    {"authority", "canards available", u::deg, 1, &F::authority_rad, "how far they can deflect against the offset"},
    {"authority_margin", "authority margin", u::deg, 1, &F::authority_margin_rad,
     "how much farther they can deflect than the offset needs, the least under control"},
    {"ended_before_apogee", "control ends before apogee", u::s, 3, &F::ended_before_apogee_s, "negative: after it"},
    {"roll_after_end", "turned after control", u::deg, 1, &F::roll_after_end_rad,
     "largest change of the roll angle from the end of control until apogee"},
    {"roll_turns", "net roll under control", turns, 2, &F::roll_turns,
     "in the time under control, without the time in which the plan's gate had closed again"},
    {"roll_turns_without_control", "net roll without control", turns, 2, &F::roll_turns_without_control,
     "of the same rocket in the same time, with its canards at trim"},
    {"at_limit_since", "at the limit since", u::s, 2, &F::at_limit_since_s,
     "first tick of a saturation that lasts to the end of control, for half a second or more"},
});

using X = flight::Extremes;
inline constexpr auto extremes = result::fields<X>({
    {"top_mach", "top Mach number", u::none, 2, &X::top_mach, "largest of the air along the axis"},
    {"static_margin", "least static margin", calibres, 2, &X::static_margin_calibres, "at lift-off or after burn-out"},
    {"angle_of_attack", "largest angle of attack", u::deg, 1, &X::angle_of_attack_rad, "under control"},
});

using E = flight::Events;
inline constexpr auto events = result::fields<E>({
    {"liftoff", "lift-off", u::s, 3, &E::liftoff_s, "first net upward acceleration"},
    {"detected", "launch detected", u::s, 3, &E::detected_s, "roll angle is zero here"},
    {"guide_clear", "off the guide", u::s, 3, &E::guide_clear_s, "true time, not known on board"},
    {"dormant", "dormant", u::s, 3, &E::dormant_s, "off the guide, canards at trim until the plan's gate opens"},
    {"control_start", "control starts", u::s, 3, &E::control_start_s, "canards leave trim"},
    {"burnout", "burn-out", u::s, 3, &E::burnout_s, "thrust is over"},
    {"control_end", "control ends", u::s, 3, &E::control_end_s, "canards are commanded to trim"},
    {"apogee", "apogee", u::s, 3, &E::apogee_s, "highest point"},
    {"parachute", "parachute", u::s, 3, &E::parachute_s, "begins to open; true time, not known on board"},
});

inline constexpr auto margins = result::fields<flight::LoopMargin>({
    {"speed", "air speed", u::m_s, 0, &flight::LoopMargin::speed_m_s, "air speed that the loop is linearised at"},
    {"phase_margin", "phase margin", u::deg, 0, &flight::LoopMargin::phase_margin_rad,
     "phase lag that the loop can take before it oscillates"},
    {"gain_margin", "gain margin", u::times, 1, &flight::LoopMargin::gain_margin,
     "factor on the gain at which it oscillates", result::Worse::neither, nullptr, "any"},
    {"crossover", "crossover", u::rad_s, 1, &flight::LoopMargin::crossover_rad_s,
     "crossover frequency: the highest frequency that the loop can follow"},
});

using N = Neutral;
inline constexpr auto neutral = result::fields<N>({
    {"from", "canards at trim from", u::s, 3, &N::from_s, "first row of the wait, from the last arming on"},
    {"until", "until", u::s, 3, &N::until_s, "last row before control, or before the end of a flight without control"},
    {"largest_command", "largest command before control", u::deg, 2, &N::command_rad,
     "largest distance of a canard's command from its trim in that time"},
    {"largest_encoder", "largest canard angle before control", u::deg, 2, &N::encoder_rad,
     "the same, of a canard's angle by its encoder"},
    {"unread", "an encoder was not read for", u::s, 3, &N::unread_s, "in that time, in all"},
});

using O = Opening;
inline constexpr auto opening = result::fields<O>({
    {"speed", "speed at control start", u::m_s, 1, &O::speed_m_s,
     "true speed through the air, along the axis; of a log, the log's"},
    {"roll_angle", "roll angle at control start", u::deg, 1, &O::roll_angle_rad,
     "true where the truth is known, from launch detection"},
    {"roll_rate", "roll rate at control start", u::deg_s, 1, &O::roll_rate_rad_s, "likewise"},
    {"dormant", "net roll while dormant", turns_of, 2, &O::dormant_turns,
     "while the canards waited for the gate, all such times together"},
    {"closings", "gate closed again", u::times, 0, &O::closings, "how often, under control"},
});

using C = Capture;
inline constexpr auto capture = result::fields<C>({
    {"turn", "turn that capture chose", u::none, 0, &C::turn,
     "whole turns on the plan's reference; none where the plan does not capture"},
    {"after", "captured after", u::s, 2, &C::after_s,
     "until the roll stayed within 10 deg of where the law settles, or of its rest where the fin offset is unknown"},
    {"watched", "looked at for", u::s, 2, &C::watched_s, "until it had stayed for a second, or the reference changed"},
    {"saturated_fraction", "canards at their limit in it", u::percent, 1, &C::saturated_fraction,
     "share of that time with the command at its limit"},
});

using R = Reopening;
[[nodiscard]] inline Cell if_known(const std::optional<double>& value) { return value ? Cell{*value} : Cell{}; }
inline constexpr auto reopening = result::fields<R>({
    {"time", "gate reopens", u::s, 3, &R::time_s, "control goes on"},
    {"turn", "turn that capture chose", u::none, 0, [](const R& r) { return if_known(r.capture.turn); }, "as at first"},
    {"after", "captured after", u::s, 2, [](const R& r) { return if_known(r.capture.after_s); }, "from then on"},
    {"watched", "looked at for", u::s, 2, [](const R& r) { return if_known(r.capture.watched_s); }, "as at first"},
});

using S = SideDeflection;
inline constexpr auto side_deflection = result::fields<S>({
    {"largest", "largest side deflection", u::deg, 1, &S::largest_rad,
     "sum of the four deflections as vectors across the axis"},
    {"mean", "mean side deflection", u::deg, 2, &S::mean_rad, "mean size of the same sum"},
    {"largest_moment", "largest side moment", u::n_m, 3, &S::largest_moment_n_m,
     "largest moment of the side deflection about the centre of gravity, across the long axis"},
});

inline constexpr auto camera_roll = result::fields<CameraRoll>({
    {"largest_apart", "camera's roll less roll angle", u::deg, 1, &CameraRoll::largest_rad,
     "largest difference of the roll that a camera sees from the roll angle: the rocket cones"},
    {"at_end_apart", "camera's roll less roll angle at the end", u::deg, 1, &CameraRoll::at_end_rad,
     "the same at the end of control"},
});

inline constexpr auto oscillation = result::fields<Oscillation>({
    {"from", "canards swing from", u::s, 2, &Oscillation::from_s, "first seen"},
    {"frequency", "frequency", hertz, 1, &Oscillation::frequency_hz, "of the swing"},
    {"lowest", "lowest", u::deg, 1, &Oscillation::lowest_rad, "canard angle in the second with the widest swing"},
    {"highest", "highest", u::deg, 1, &Oscillation::highest_rad, "likewise"},
});

inline constexpr result::Unit angle{"", "deg", text::degrees(1.0)};
inline constexpr auto canard_reach = result::fields<flight::CanardReach>({
    {"lowest", "canards reach", angle, 1, &flight::CanardReach::lowest_rad,
     "effective angle in the air at the largest roll command one way"},
    {"highest", "to", angle, 1, &flight::CanardReach::highest_rad, "the other way"},
});

using U = flight::Unmeasured;
inline constexpr auto unmeasured = result::fields<U>({
    {"spin_from", "faster than the gyro from", u::s, 2, &U::spin_from_s, "since detection"},
    {"spin_for", "for", u::s, 2, &U::spin_for_s, "in all"},
    {"spin", "end of the gyro's range", u::deg_s, 0, &U::spin_rad_s, "with the sense of the turn"},
    {"silent_from", "no rate known from", u::s, 2, &U::silent_from_s, "under control, with canards at trim"},
    {"silent_for", "for", u::s, 2, &U::silent_for_s, "in all"},
    {"speed_bound_from", "speed is a lower bound from", u::s, 2, &U::speed_bound_from_s,
     "estimates of height and speed"},
});

using B = flight::BarometerSpell;
inline constexpr auto barometer = result::fields<B>({
    {"state", "barometer", u::none, 0, [](const B& b) { return Cell{std::string{core::name(b.state)}}; },
     "used, or why not: silent, on_pad, too_fast, disagrees or alone"},
    {"from", "from", u::s, 3, &B::from_s, "since launch detection"},
    {"to", "to", u::s, 3, &B::to_s, "last tick of it"},
});

inline constexpr auto wind = result::fields<flight::MeanWind>({
    {"speed", "wind", u::m_s, 1, &flight::MeanWind::speed_m_s, "without gusts"},
    {"from", "from", u::deg, 0, [](const flight::MeanWind& w) { return result::Cell{text::bearing_rad(w.from_rad)}; },
     "0 north, 90 east"},
    {"height", "at a height of", u::m, 0, &flight::MeanWind::height_m, "above ground"},
});

inline constexpr auto imposed_roll = result::fields<flight::ImposedRoll>({
    {"time", "roll imposed at", u::s, 2, &flight::ImposedRoll::time_s, "set by hand"},
    {"angle", "angle", u::deg, 1, &flight::ImposedRoll::angle_rad, "roll angle"},
    {"rate", "rate", u::deg_s, 1, &flight::ImposedRoll::rate_rad_s, "roll rate"},
});

using P = flight::PathPoint;
inline constexpr auto apogee = result::fields<P>({
    {"north", "north", u::m, 1, &P::north_m, "from the foot of the guide"},
    {"east", "east", u::m, 1, &P::east_m, "likewise"},
    {"height", "height", u::m, 1, &P::height_m, "likewise"},
    {"tilt", "tilt at apogee", u::deg, 0, &P::tilt_rad, "of the axis from the vertical"},
});
/// Of a path in a plane.
inline constexpr auto apogee_in_plane = result::fields<P>({
    {"across", "across", u::m, 1, &P::north_m, "from the foot of the guide"},
    apogee[2],
    apogee[3],
});

inline constexpr auto outages = result::fields<flight::Outage>({
    {"from", "from", u::s, 3, &flight::Outage::from_s, "last tick before it"},
    {"to", "to", u::s, 3, &flight::Outage::to_s, "first tick after it; none where the record ends"},
    {"cause", "cause", u::none, 0, &flight::Outage::cause, "of the reset; empty: there was none"},
    {"resumed", "resumed", u::none, 0, &flight::Outage::resumed, "whether the flight went on after it"},
});

inline constexpr auto canard_verdicts = result::fields<flight::CanardVerdictChange>({
    {"time", "time", u::s, 3, &flight::CanardVerdictChange::time_s, "when it changed"},
    {"canard", "canard", u::none, 0,
     [](const flight::CanardVerdictChange& c) { return Cell{std::uint64_t{c.canard + 1}}; }, "number of the canard"},
    {"verdict", "monitor's verdict", u::none, 0,
     [](const flight::CanardVerdictChange& c) { return Cell{std::string{core::name(c.verdict)}}; },
     "of the avionics on this canard"},
});

inline constexpr auto phases = result::fields<flight::PhaseChange>({
    {"time", "time", u::s, 3, &flight::PhaseChange::time_s, "when it began"},
    {"phase", "phase", u::none, 0, [](const flight::PhaseChange& p) { return Cell{std::string{core::name(p.phase)}}; },
     "of the flight law"},
    {"reason", "reason", u::none, 0,
     [](const flight::PhaseChange& p) { return p.reason ? Cell{std::string{core::name(*p.reason)}} : Cell{}; },
     "why it began"},
});

}  // namespace fantail::report::fields
