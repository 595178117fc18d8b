// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "paper/claim.hpp"

namespace fantail::paper {

/// Printed statements that nothing of ours can stand beside.
struct OutsideRow {
  const char* place;
  const char* what;
  const char* printed;
  Kind kind;
  const char* why;
};

inline constexpr const char* how_it_was_built = "How the tunnel was built: no model here contains it.";
inline constexpr const char* how_it_was_tested = "How a test was made.";

inline constexpr std::array<OutsideRow, 15> outside_rows{{
    {"Section 1", "Other tunnels run for", "0.1 to 0.2 s", Kind::outside, "Supersonic tunnels elsewhere."},
    {"Section 2", "Sizes of the tunnel",
     "inlet 1.4 m; section 0.6 m wide, 2 m long; fan 1 m, 15 kW, blades at 23 degrees. Walls of 6, 9 and 17 mm; cloth "
     "of 200 g",
     Kind::outside, how_it_was_built},
    {"Table 1", "Fins, canards and avionics of each vehicle",
     "ABS, PLA with fibreglass, moulded fibreglass; subsonic or supersonic, spot tracker", Kind::outside,
     "Materials have no part in the model; they show in the masses."},
    {"Section 3.1", "A camera stands out by", "10 mm", Kind::outside, "The fin offset is the only asymmetry here."},
    {"Section 3.2", "Stability test: balanced on, strings through holes of", "less than 20 mm, 4 mm", Kind::outside,
     "How the test was made; the scenario tunnel_stability is a simulated one."},
    {"Section 3.2", "Stability test: the rocket straightens at", "15, 20 and 30 m/s", Kind::not_reproducible,
     "Neither centre of gravity nor centre of pressure is printed, nor how far and how fast it swung. The scenario "
     "tunnel_stability repeats the procedure with an assumed airframe, which is stable because it was made so."},
    {"Section 4.1", "Reduction of the wind speed 200 mm and 100 mm from the wall", "negligible, less than 5 %",
     Kind::not_reproducible, "The readings are not printed. The simulated tunnel has no boundary layer."},
    {"Section 4.1.1", "Where the sensor is, and what is negligible", "200 mm from the edge, 0.1 m/s", Kind::outside,
     how_it_was_tested},
    {"Section 4.1.2", "Bare fins: none, most and little roll at a diameter of", "100, 200 and 300 mm",
     Kind::not_reproducible, "A measurement. How the swirl depends on the radius is not printed."},
    {"Section 4.1.2", "Video, egg crate", "5 min, 20 cm high", Kind::outside, how_it_was_tested},
    {"Section 4.2, figures 17 and 18", "Recovery of launch 1; clock of figure 18",
     "parachute, broken canards; t = 0 1.5 s before launch", Kind::outside,
     "The analysed data end before the parachute opens, and so do ours; our figures count from launch detection."},
    {"Section 4.3.1", "At 30 m/s the rocket", "spun and swung", Kind::outside, "Here, the string allows roll only."},
    {"Section 4.3.2, figure 25", "Recovery of launch 2", "back fins damaged on landing by a gust", Kind::outside,
     "The runs here end a second after apogee."},
    {"Section 4.3.2", "Extra damping behind burn-out", "from the angle of attack and the speed", Kind::outside,
     "Damping depends on neither here; alpha is one number a run."},
    {"Section 4.3.2", "Closed-loop analysis of launch 2", "very similar to the open loop", Kind::not_reproducible,
     "Its results are not shown in print."},
}};

}  // namespace fantail::paper
