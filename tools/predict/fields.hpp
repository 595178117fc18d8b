// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "predict/decision.hpp"
#include "predict/sentences.hpp"
#include "report/verdict.hpp"
#include "result/document.hpp"

namespace fantail::predict {

// Every figure of a prediction: its key, label, unit and rounding in all outputs, and its meaning for the manual. A new
// figure is a line here and a member of the row that it is read from.

namespace u = result::units;
using result::Cell;
using result::Worse;
using P = Prediction;

inline constexpr auto median_fields = result::fields<P>({
    {"authority_margin", "authority margin", u::deg, 1, &P::authority_margin_rad,
     "angle that the canards reach against the fin offset, less the size of the offset"},
    {"authority", "canards can balance the offset", u::percent, 0, &P::authority,
     "share of the runs whose authority margin is above zero"},
    {"held", "roll is held", u::percent, 0, &P::held, "share of the runs that hold their roll"},
    {"settle", "roll settles at", u::deg, 1, &P::settle_rad,
     "roll angle at which the law settles, at the end of control"},
    {"settle_reference", "its reference then", u::deg, 1, &P::settle_reference_rad,
     "commanded roll angle at the end of control"},
    {"settle_off", "off its reference", u::deg, 1, &P::settle_off_rad,
     "distance of that angle from the commanded angle"},
    {"saturated", "control time with canards at their limit", u::share, 0, &P::saturated_share,
     "share of the time under control with the command at the canard limit"},
    {"gate_time", "gate opens, after lift-off", u::s, 2, &P::gate_time_s,
     "time after lift-off at which canards leave trim, of a plan that waits for more than the guide"},
    {"gate_height", "height then", u::m, 0, &P::gate_height_m, "true height at that time"},
    {"gate_speed", "speed then, through the air", u::m_s, 1, &P::gate_speed_m_s,
     "true speed along the axis at that time"},
    {"gate_rate", "roll rate then", u::deg_s, 0, &P::gate_rate_rad_s, "true roll rate at that time"},
    {"captured_after", "roll captured after", u::s, 2, &P::captured_after_s,
     "time from the last opening until the roll angle stays within 10 deg of where the law settles"},
    {"spin_rate", "spin without authority, at top speed", u::deg_s, 0, &P::spin_rate_rad_s,
     "final roll rate of the runs whose canards cannot balance the fin offset"},
    {"offset_size", "size of the fin offset", u::deg, 1, &P::offset_size_rad,
     "largest fin offset under control, without its sign"},
    {"top_speed", "top speed over ground", u::m_s, 1, &P::top_speed_m_s, "highest speed over ground"},
    {"apogee", "apogee", u::m, 0, &P::apogee_m, "greatest height above the site"},
    {"drift", "drift at apogee", u::m, 0, &P::drift_m, "distance over ground from the foot of the guide"},
    {"wind", "wind", u::m_s, 1, &P::wind_m_s, "wind speed at its reference height"},
});

inline constexpr auto count_fields = result::fields<P>({
    {"canard_limit", "canard limit", u::deg, 1, [](const P& p) { return Cell{p.reach.angle_rad}; },
     "angle that all canards together reach against the fin offset"},
    {"rest_limit", "farthest rest from the reference", u::deg, 1,
     [](const P& p) { return Cell{p.flown.rest_limit_rad}; },
     "a roll that settles farther from its reference is not held (verdict.rest_limit_deg)"},
    {"not_judged", "not judged", u::none, 0, &P::not_judged, "runs whose roll could not be judged"},
    {"without_control", "without control", u::none, 0, &P::without_control, "runs that never came under control"},
    {"outside_model", "outside the model", u::none, 0, &P::outside_model, "runs in which the roll model does not hold"},
    {"runs", "runs", u::none, 0, [](const P& p) { return Cell{std::uint64_t{p.runs.size()}}; }, "runs flown"},
});

inline constexpr auto loop_fields = result::fields<P>({
    {"servo_lag", "servo lag", u::s, 4, &P::servo_lag_s, "first-order lag of the servos"},
    {"delay", "dead time", u::s, 4, &P::delay_s, "dead time of the whole loop"},
});

using M = MarginsAtSpeed;
inline constexpr auto margin_fields = result::fields<M>({
    {"speed", "air speed", u::m_s, 0, &M::speed_m_s,
     "air speed of the row; of the worst, the speed with the least margin"},
    {"phase_margin", "phase margin", u::deg, 0, &M::phase_margin_rad, "phase margin of the roll loop"},
    {"crossover", "crossover", u::rad_s, 1, &M::crossover_rad_s,
     "crossover frequency: the highest frequency that the loop can follow", Worse::neither, nullptr, "none"},
    {"gain_margin", "gain margin", u::times, 1, &M::gain_margin, "factor on the loop's gain at which it oscillates",
     Worse::neither, nullptr, "any"},
});

[[nodiscard]] inline Cell of_gate(const Run& run, double dormancy::Opening::* member) {
  return run.opening ? Cell{(*run.opening).*member} : Cell{};
}
inline constexpr auto run_fields = result::fields<Run>({
    {"seed", "seed", u::none, 0, &Run::seed, "seed of the run's random streams"},
    {"alpha", "damping", u::m2, 6, [](const Run& r) { return Cell{r.airframe.damping_m2}; }, "damping of its airframe"},
    {"beta", "torque", u::m, 6, [](const Run& r) { return Cell{r.airframe.torque_m}; },
     "canard torque of its airframe"},
    {"offset_begin", "fin offset at first", u::deg, 1, [](const Run& r) { return Cell{r.airframe.offset_begin_rad}; },
     "fin offset at lift-off"},
    {"offset_end", "fin offset at last", u::deg, 1, [](const Run& r) { return Cell{r.airframe.offset_end_rad}; },
     "fin offset from 1.7 s after lift-off on"},
    {"authority_margin", "authority margin", u::deg, 1, &Run::authority_margin_rad, "as above, of this run"},
    {"outcome", "outcome", u::none, 0, [](const Run& r) { return Cell{std::string{report::name(r.outcome)}}; },
     "the verdict of its flight report in a word"},
    {"largest_hold_error", "largest hold error", u::deg, 1, &Run::largest_hold_error_rad,
     "largest distance of the roll angle from where it settles"},
    {"settle", "settles at", u::deg, 1, &Run::settle_rad, "roll angle of rest at the end of control"},
    {"saturated", "saturated", u::share, 0, &Run::saturated_share,
     "share of the time under control with the command at the canard limit"},
    {"top_speed", "top speed over ground", u::m_s, 1, &Run::top_speed_m_s, "highest speed over ground"},
    {"apogee", "apogee", u::m, 0, &Run::apogee_m, "greatest height above the site"},
    {"gate_time", "gate opens", u::s, 3, [](const Run& r) { return of_gate(r, &dormancy::Opening::time_s); },
     "time after lift-off at which canards leave trim"},
    {"gate_height", "height then", u::m, 1, [](const Run& r) { return of_gate(r, &dormancy::Opening::height_m); },
     "true height at that time"},
    {"gate_speed", "speed then, through the air", u::m_s, 1,
     [](const Run& r) { return of_gate(r, &dormancy::Opening::speed_m_s); }, "true speed along the axis at that time"},
    {"gate_rate", "roll rate then", u::deg_s, 1,
     [](const Run& r) { return of_gate(r, &dormancy::Opening::rate_rad_s); }, "true roll rate at that time"},
    {"gate_angle", "roll angle then", u::deg, 1, [](const Run& r) { return of_gate(r, &dormancy::Opening::angle_rad); },
     "roll angle since launch detection, as the law has it"},
    {"captured_after", "captured after", u::s, 3,
     [](const Run& r) {
       return r.opening && r.opening->captured_after_s ? Cell{*r.opening->captured_after_s} : Cell{};
     },
     "time from the last opening until the roll angle stays within 10 deg of where the law settles"},
    {"spin_rate", "spin", u::deg_s, 0, &Run::spin_rate_rad_s,
     "final roll rate where the canards cannot balance the offset"},
    {"wind", "wind", u::m_s, 1, [](const Run& r) { return r.wind ? Cell{r.wind->speed_m_s} : Cell{}; },
     "wind speed at its reference height"},
    {"wind_from", "wind from", u::deg, 0, [](const Run& r) { return r.wind ? Cell{r.wind->from_rad} : Cell{}; },
     "direction that the wind comes from, clockwise from north"},
    {"drift", "drift", u::m, 0, &Run::drift_m, "distance over ground from the foot of the guide, at apogee"},
});

/// Of all runs that left the pad, at one time.
struct Instant {
  double time_s;
  result::Spread roll_rad;
  result::Spread rate_rad_s;
};
inline constexpr auto band_fields = result::fields<Instant>({
    {"time", "time after lift-off", u::s, 2, &Instant::time_s, "time after lift-off"},
    {"roll_angle", "roll angle", u::deg, 1, &Instant::roll_rad, "true roll angle"},
    {"roll_rate", "roll rate", u::deg_s, 0, &Instant::rate_rad_s, "true roll rate"},
});

[[nodiscard]] inline result::Answer answer_of(Judgement judgement) {
  return judgement == Judgement::met       ? result::Answer::yes
         : judgement == Judgement::not_met ? result::Answer::no
                                           : result::Answer::undecided;
}

using C = Criterion;
[[nodiscard]] inline Cell judged(const C& c) {
  return result::Judged{answer_of(c.judgement), std::string{label(c.judgement)}};
}
inline constexpr auto criterion_fields = result::fields<C>({
    {"label", "criterion", u::none, 0, &C::label, "what a go requires"},
    {"found", "found", u::none, 0, &C::found, "what was found"},
    {"required", "asked for", u::none, 0, &C::required, "the value that a go requires"},
    {"judgement", "judgement", u::none, 0, judged, "met, not met, or not judged"},
});
inline constexpr auto filed_criterion_fields = result::fields<C>({
    {"criterion", "key", u::none, 0, &C::key, "name of the requirement"},
    {"judgement", "judgement", u::none, 0, judged, "met, not_met, or not_judged"},
    {"found", "found", u::none, 0, &C::found, "the value that was found"},
    {"required", "asked for", u::none, 0, &C::required, "the value that a go requires"},
    {"sentence", "sentence", u::none, 0, &C::clause, "the same as a clause"},
});

}  // namespace fantail::predict
