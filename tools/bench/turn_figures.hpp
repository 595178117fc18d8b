// SPDX-License-Identifier: MIT
#pragma once

#include "bench/measurement.hpp"
#include "bench/trace.hpp"

namespace fantail::bench {

// The parts of measure(), each for one kind of movement; each fills what it can.

/// Angles reached in the holds at both limits, and where the centre is found again from above and from below.
void add_ends(const CanardTrace& trace, Figures& figures);
void add_centre(const CanardTrace& trace, Figures& figures);

/// The first step, and the speed of the step that begins with part `widest`. Needs `sign`.
void add_steps(const CanardTrace& trace, Part widest, Figures& figures);

/// How the encoder follows a sine.
void add_wave(const CanardTrace& trace, double frequency_hz, Figures& figures);
/// How far the command was the sine that was asked for.
void add_sent_wave(const CanardTrace& trace, const Exercise& exercise, std::size_t canard, Figures& figures);

/// Level, noise and drift whenever the canard should have stood still.
void add_rest(const CanardTrace& trace, Figures& figures);

}  // namespace fantail::bench
