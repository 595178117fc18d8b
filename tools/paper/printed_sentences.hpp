// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

namespace fantail::paper {

/// What became of the numbers of a sentence that no row compares.
struct PrintedSentence {
  std::string_view place;
  std::string_view numbers;
  std::string_view here;
};

inline constexpr std::string_view taken = "taken as printed: an input of the runs on this page";
inline constexpr std::string_view construction = "how the tunnel was built: no model here contains it";
inline constexpr std::string_view measured_only = "a measurement without published data";

inline constexpr std::array<PrintedSentence, 25> printed_sentences{{
    {"Section 1", "supersonic tunnels run for 0.1 to 0.2 s", "about other tunnels"},
    {"Section 2",
     "inlet 1.4 m, section 0.6 m wide and 2 m long, fan 1 m and 15 kW, blades at 23 degrees, walls of 6, 9 "
     "and 17 mm, cloth of 200 g",
     construction},
    {"Section 3.1", "a camera that stands out by 10 mm", "no asymmetry is modelled but the fin offset"},
    {"Section 3.2", "balanced on less than 20 mm, holes of 4 mm", "how the test was made"},
    {"Section 3.2", "stable at 15, 20 and 30 m/s", "pitch and yaw are not modelled"},
    {"Section 4.1", "no boundary effect beyond 200 mm from the wall, below 5 % at 100 mm", measured_only},
    {"Section 4.1.1", "a reading every 2 s, rounded to 0.1 m/s; six fan speeds and when they are steady", taken},
    {"Section 4.1.1", "a sensor 200 mm from the edge; below 0.1 m/s is negligible", "how the test was made"},
    {"Section 4.1.2", "fins below 100 mm do not roll, above 300 mm little, at 200 mm most", measured_only},
    {"Section 4.1.2", "video of 5 min; egg crate 20 cm high", "how the test was made"},
    {"Sections 4.2, 4.3.2", "ground wind of 1 to 2 m/s, and of 3 m/s", "wind is not simulated"},
    {"Section 4.2", "gains 1 and 0.1, limit 6 degrees, 0 then \u221215 degrees", taken},
    {"Section 4.2", "between \u221215 and 15 degrees every second", "one step is in the analysed data, and in ours"},
    {"Section 4.2", "2 g over 0.2 s, guide of 4 m, control 2 m above it", taken},
    {"Section 4.2", "t = 0 of figure 18 is 1.5 s before launch", "our figures count from launch detection"},
    {"Section 4.2", "offset small for 0.5 s, from 1 s on about \u22127 degrees",
     "an input of the flight here, read off figure 21b"},
    {"Section 4.2", "two disturbance intervals in thrust and two in coast", taken},
    {"Section 4.3.1", "eight steps of 45 degrees at 22 m/s, gains 0.5 and 0.05, 0.1 Hz, 5 s each, N = 1", taken},
    {"Section 4.3.1", "not at 30 m/s, where the rocket spun and swung", "the swing is not modelled"},
    {"Section 4.3.2",
     "0 to \u221220 degrees after 2 s, limit 9 degrees, excitation from 0.4 s until 5 s after the step", taken},
    {"Section 4.3.2", "chirp of 4 degrees, 2 pi (2 t \u2212 10)", taken},
    {"Section 4.3.2", "2.5 g over 0.1 s, two accelerometers", taken},
    {"Section 5", "turbulence below 0.04 %, swirl of 2 degrees, offset of 7 degrees",
     "repeats section 4; see the rows there"},
    {"Section 5, section 4.3.2", "torque constants 8 and 9 of launch 2, 10 of launch 1",
     "identified from logs that are not published; see the rows there"},
    {"Table 1", "mass, length and inertia", taken},
}};

}  // namespace fantail::paper
