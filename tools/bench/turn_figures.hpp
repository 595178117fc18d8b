// SPDX-License-Identifier: MIT
#pragma once

#include "bench/course.hpp"
#include "bench/measurement.hpp"

namespace fantail::bench {

// The parts of measure(), each for one kind of movement; each fills what it can.

/// Angles reached in the holds at both limits, and where the centre is found again from above and from below.
void add_ends(const Course& course, Figures& figures);
void add_centre(const Course& course, Figures& figures);

/// The first step, and the speed of the step that begins with part `widest`. Needs `sign`.
void add_steps(const Course& course, Part widest, Figures& figures);

/// How the encoder follows a sine.
void add_wave(const Course& course, double frequency_hz, Figures& figures);

/// Level, noise and drift whenever the canard should have stood still.
void add_rest(const Course& course, Figures& figures);

}  // namespace fantail::bench
