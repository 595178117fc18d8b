// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace fantail::paper {

/// What became of one printed figure.
struct PrintedFigure {
  std::string_view number;
  std::string_view shows;
  std::string_view here;  ///< the chapter that draws it, or why none does
};

inline constexpr std::string_view photograph = "a photograph";

inline constexpr std::array<PrintedFigure, 24> printed_figures{{
    {"1 to 7", "the tunnel and how it was built", photograph},
    {"8, 9", "airframes, avionics, stability test", photograph},
    {"10", "wind speed over time for six fan speeds", "The air of the tunnel"},
    {"11", "fan speed against wind speed; turbulence", "The air of the tunnel"},
    {"12, 13", "bare fins; flow straightener", photograph},
    {"14", "roll rate with and without flow straightener", "Swirl"},
    {"15", "mean steady roll rate over speed", "Swirl"},
    {"16", "equivalent fin offset over speed", "Swirl"},
    {"17", "stills of launch 1", photograph},
    {"18", "roll rate of launch 1 with its key points", "Launch 1"},
    {"19", "roll rate and canard angle", "Launch 1"},
    {"20", "model against data, launch 1", "Launch 1, against the simulated flight"},
    {"21", "the same in detail; disturbance", "Launch 1, against the simulated flight"},
    {"22", "closed loop against data; disturbance", "Launch 1, against the simulated flight"},
    {"23", "eight measured steps", "Steps in the wind tunnel has rows for its contents; step 6 is drawn"},
    {"24", "step 6 and its model", "Steps in the wind tunnel"},
    {"25", "stills of launch 2", photograph},
    {"26", "the chirp", "Launch 2, without its unpublished variations"},
    {"27", "roll rate of launch 2 with its key points", "Launch 2"},
    {"28", "first window and its model", "Launch 2, against the simulated flight"},
    {"29", "offset of the first window", "not drawn: its course is not printed, and ours is constant"},
    {"30", "second window and its model", "Launch 2, against the simulated flight"},
    {"31", "offset of the second window", "not drawn: its course is not printed, and ours is constant"},
    {"Table 1", "mass, length and inertia of three vehicles", "they are the figures of the shipped vehicles"},
}};

}  // namespace fantail::paper
