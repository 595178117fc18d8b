// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight/flight.hpp"
#include "json/value.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// To a reset after which nothing was resumed, or to one or a standstill after which nothing is on record any more.
[[nodiscard]] bool was_lost(const flight::Flight& flight);

/// Of a flight without control: why it never began, as far as is known.
[[nodiscard]] std::string no_control(const flight::Flight& flight, const Figures& figures);

/// The canards waited at trim for a gate that did not open in this flight: the plan asks for that, and nothing failed.
[[nodiscard]] bool gate_stayed_closed(const flight::Flight& flight);

[[nodiscard]] bool was_under_control(std::span<const flight::PhaseChange> changes);

/// The event named control end is that of canards which waited for their gate to the last: control never began.
[[nodiscard]] bool ends_a_wait(const flight::Flight& flight);

/// Control began so long before the rocket left the launch guide. Empty: it did not.
[[nodiscard]] std::optional<double> begun_on_guide_s(const flight::Flight& flight);

/// " Control began 0.12 s before the rocket left the launch guide.", where that is known: canards that move in a guide
/// can jam the rocket. Empty: it did not.
[[nodiscard]] std::string begun_on_guide(const flight::Flight& flight);

/// A plan whose gains are zero: the rocket rolls freely in its phase of control.
[[nodiscard]] bool nothing_controls_roll(const flight::Flight& flight);

/// What a plan with a gate or with capture did, sentence by sentence: the state at the opening, the motor, the turn and
/// how soon the roll was held, the canards before it. None of another plan.
void add_gate_sentences(std::vector<std::string>& to, const flight::Flight& flight, const Figures& f);

/// When the barometer that the plan asks for was used from launch detection to the end of control, and when and why it
/// was not. Empty: the plan asks for none, or nobody knows.
[[nodiscard]] std::string barometer_sentences(const flight::Flight& flight);

/// "canards commanded to trim", and which of them stood elsewhere before apogee, and how far: each had time to return
/// from `from_s` on. A command moves no canard that is jammed.
[[nodiscard]] std::string commanded_to_trim(const flight::Flight& flight, double from_s);

/// Did control end before apogee, whatever ended it? In the tunnel, where there is no apogee: for another reason than
/// the plan's own time.
[[nodiscard]] bool ended_early(const flight::Flight& flight, const Figures& f);

/// Verdict::allowed_tilt_end_s of control that did not end early.
[[nodiscard]] std::optional<double> allowed_tilt_end_s(const flight::Flight& flight, const Figures& f);

/// Of control that did not end early: by how much before apogee and by what limit, or how long after apogee. A sentence
/// with a space before it; empty: it went on to apogee, or until the avionics detected one.
[[nodiscard]] std::string late_end(const flight::Flight& flight, const Figures& f);

/// When and why control did, and what the rocket turned by until apogee: one or two sentences.
[[nodiscard]] std::string early_end(const flight::Flight& flight, const Figures& f);

/// Of a flight without control on record: it ended in a hole, and control may have begun there.
[[nodiscard]] bool may_hide_control(const flight::Flight& flight, const Figures& figures);

/// A clause of a verdict: "the roll is not known at all times under control", or the hold error is not, for another
/// reason than a reset. Empty: both are, or the hold error never is.
[[nodiscard]] std::string_view what_misses_control(const flight::Flight& flight, const Figures& figures);

/// "the reference or the fin offset": for want of it the hold error is not known at some rows under control.
[[nodiscard]] std::string what_hold_lacks(const HoldRecord& hold);

/// Sentences with a space before each: " The roll is not known from 3.00 s to 5.00 s.", and where what is known begins
/// after control has, ends before control or apogee, or is thin; likewise of the hold error, where the roll is known.
/// Not of resets. Empty: nothing is missing.
[[nodiscard]] std::string unknown_roll(const flight::Flight& flight, const Figures& figures);

/// Nobody knows how such a flight went on: neither the end of control nor apogee is on record.
[[nodiscard]] bool ends_under_control(const flight::Flight& flight, const Figures& figures);

/// What became of a rocket before its motor had burnt out, sentence by sentence: first that it turned over, then all
/// else in the order of time. Empty: nothing did.
[[nodiscard]] std::string before_burnout(const flight::Flight& flight);

/// From when on a rocket that is not stable flew tail first in its climb; empty: it did not.
[[nodiscard]] std::optional<double> tumbled_s(const flight::Flight& flight);

/// No ascent of a rocket: by flight::BeforeBurnout, or because it tumbled.
[[nodiscard]] bool ascent_failed(const flight::Flight& flight);

/// before_burnout(), and that it tumbled where that does not say so. Empty: neither.
[[nodiscard]] std::string failed_ascent(const flight::Flight& flight);

/// As summary.json has it; null where nothing happened.
[[nodiscard]] json::Value before_burnout_json(const flight::Flight& flight);

/// The other way.
[[nodiscard]] std::optional<flight::BeforeBurnout> read_before_burnout(const json::Value& json);

/// Something pulled at the rocket after apogee, as an opening parachute does.
struct Jolt {
  double time_s = 0.0;               ///< of its begin, on the rows' clock
  double specific_force_m_s2 = 0.0;  ///< the largest along the axis within a second, not negative
};

/// The first stretch after apogee and burn-out (without one: after control that ended there) in which the accelerometer
/// reads more than 1.5 g along the axis, either way, for 20 ms. Air alone brings a falling rocket to 1 g at most.
/// Empty: none in the record, which may end before it.
[[nodiscard]] std::optional<Jolt> jolt_after_apogee(const flight::Flight& flight);

// Sentences of a verdict, each with a space before it; empty where there is nothing to say.

/// Each reset and standstill of the processor in flight, and whether the flight went on after it.
[[nodiscard]] std::string outages(const flight::Flight& flight);

/// When the gyro was silent, and from when on height and speed are lower bounds.
[[nodiscard]] std::string unmeasured(const flight::Flight& flight);

/// The first finding of the monitor about each canard, how long it lasted, and what became of it.
[[nodiscard]] std::string canard_faults(const flight::Flight& flight);

/// A clause without that space, "canard 1 does not follow its command": stalled or slipping for its monitor, when
/// control ended; empty: none.
[[nodiscard]] std::string not_following(const flight::Flight& flight);

/// "3.2 times", or "any" where no factor makes the loop swing. A loop with an integrator can be one that swings with
/// less gain, not with more, and then that is said: "0.4 times, and swings with less".
[[nodiscard]] std::string gain_margin_text(const flight::LoopMargin& margin);

/// Those of a flight that differ when speed and phase margin are printed as whole numbers; of others the worst.
[[nodiscard]] std::vector<flight::LoopMargin> different_margins(const flight::Flight& flight);

}  // namespace fantail::report
