// SPDX-License-Identifier: MIT
#include "detection/kind.hpp"

#include <algorithm>

namespace fantail::detection {

// clang-format off: a table reads better with one thing a line
constexpr std::array<KindInfo, kinds> kind_table{{
  {"handling",
   "picked up (0.3 to 1.5 m/s in 0.15 to 0.5 s). Carried at 1.4 to 2.5 steps a second with 0.1 to 0.5 g and heel strikes of 0.2 to 1 g. Turned over by up to 180 deg, put down with a knock of 1 to 6 g",
   "assumed; the usual step rate of a walking person and the bounce of a trunk",
   "one person, one turn, about one axis; not measured on this rocket"},
  {"drop",
   "falls 0.02 to 1.22 m and bounces up to four times. Half-sine shocks of 2 to 40 ms (the sensor itself spreads shorter ones). Half of the drops tail first, the others in any orientation",
   "height: transit drop of MIL-STD-810F, method 516.5, procedure IV; the area of the shock is the change of speed",
   "widths from a hard floor to grass are assumed; the tube does not ring"},
  {"transport",
   "a car or a trailer: body 2 to 5 Hz with 0.1 to 0.4 g rms, road 10 to 150 Hz with 0.1 to 1.1 g rms. Up to three potholes of 1 to 6 g and 15 to 60 ms. Lying or standing",
   "level: about 1 g rms, as in MIL-STD-810G (method 514.6, annex C) for highway trucks",
   "two narrow bands in place of a spectrum; an armed rocket should never be on a road"},
  {"shaking",
   "shaken along its axis by two hands: 1 to 8 Hz, up to 0.3 m either way, 300 N and 600 W, 30 to 100 % of that. Axis 0 to 90 deg from the vertical, wobbling",
   "bounds from mechanics: arm's reach, force and power of a strong person on 4 kg",
   "no throw; a machine or a lighter rocket can be shaken harder"},
  {"chuff",
   "one to three bursts of thrust of 2 to 12 g and 20 to 400 ms, with vibration to 2 g rms. The rocket stays in its guide (rises at most 3.5 m); it falls back and lands",
   "thrust as for the launches; the hop is ballistic",
   "a burst that throws the rocket out of its guide is a flight, and is not drawn"},
  {"misfire",
   "igniter pop of 0.5 to 4 g and 2 to 5 ms. Then a hiss of less than the weight for 0.3 to 2 s with vibration to 2 g rms",
   "assumed",
   "not measured"},
  {"neighbour",
   "another launch beside it. Noise of 40 to 450 Hz with 0.05 to 1 g rms comes in 0.1 to 0.5 s and goes in 0.3 to 1.5 s. And a thump of the ground of 0.2 to 1 g",
   "assumed",
   "not measured; a large motor at a few metres may be louder"},
  {"gust",
   "wind rocks the rail: 0.5 to 5 Hz, 0.2 to 5 deg about a point 0.5 to 2 m below. Up to six slaps of 0.5 to 4 g and 3 to 20 ms",
   "assumed; kinematics of a rigid rail",
   "the rail does not bend"},
  {"vibration",
   "shaken on the pad by a band between 20 and 450 Hz with 0 to 2 g rms on each axis",
   "level: the largest that the project requires for a launch",
   "one band at a time"},
  {"bias",
   "stands still with zeros off by up to 0.5 g on each axis of each accelerometer and 5 deg/s of the gyro",
   "several times what the data sheets of the board's sensors allow",
   "with zeros that far off the self-test detects no rest, so the rocket is not armed. Here it is armed anyway, and its tilt is unknown to the flight law"},
  {"tilt",
   "the rail is set from one angle to another, 0 to 15 deg each, in 0.5 to 2 s. Up to four knocks of 1 to 5 g and 5 to 30 ms",
   "range of a launch rail; the rest assumed",
   "the rail turns about one axis"},
  {"launch",
   "peak of 3 to 20 g, reached in 10 ms to 0.6 s and then never below 3 g until burnout after 1 to 3 s. Tilt to 15 deg, vibration 0 to 2 g rms, zeros to 0.05 g",
   "thrust to weight of high-power rockets; the published flights had 4 to 5 g",
   "straight line along the guide's axis; no roll, no weathercock"},
  {"launch_at_2_g",
   "the same with vibration of 2 g rms",
   "as above",
   "as above"},
  {"launch_one_bad",
   "as launch, with an accelerometer that failed in the quarter of a second before ignition",
   "as above",
   "a plan that requires two accelerometers should miss these; they are shown, not judged"},
  {"raised_rail",
   "armed on a rail that is raised by 5 to 90 deg in 1 to 5 s, to 0 to 15 deg from the vertical. In every second case a knock of 1 to 4 g at its stop. Still for 0.2 to 10 s; then as launch",
   "angles and times of a person who raises a launch rail: assumed",
   "the rail turns about one axis; shown, not judged: the crew decides how long to wait"},
  {"missed_flight",
   "a flight that a plan may miss, up to 70 m/s. In turn: 1.6 to 2.45 g for 2 to 4 s; 5 to 15 g with one accelerometer low by 2.1 to 4 g. Or one silent during the burn. Or 10 to 25 g for 100 to 190 ms; 3 to 5 g with vibration of 2 g rms. Then coast, ejection kick, drogue, descent, main (every second), landing, lying still for 1 to 8 s. Last a crew that lifts, carries, turns, shakes, puts down or drives. Openings: half-sine or square, 2 to 20 g, 50 ms to 1 s, at any angle of the axis; jolts of 0.5 to 2 g. Swing of 0.1 to 30 deg, spin of 0.5 to 360 deg/s; landing 5 to 100 g, 5 to 50 ms",
   "assumed; flight by mechanics, with drag; shaking as in the kind of that name",
   "parachutes act straight up; a long hard opening removes more speed than the rocket has; a descent lasts at most 8 s for each parachute"},
  {"uncontrolled_flight",
   "a flight that is detected but in which control may not begin. In turn: gyro silent from before the launch to after the burn; 3 to 4 g for 0.4 to 0.6 s, too slow for the guide's gate. Or one accelerometer low by 2.1 to 4 g from 0.15 to 0.3 s after ignition. Then as missed_flight",
   "as above",
   "as above"},
  {"stirred_launch",
   "in turn gust, misfire, neighbour and vibration as above, and 0 to 1 s after its end a launch",
   "as above",
   "one disturbance before each launch"},
}};
// clang-format on

std::optional<Kind> kind_of(std::string_view name) {
  const auto found = std::ranges::find(kind_table, name, &KindInfo::name);
  return found == kind_table.end() ? std::nullopt : std::optional{static_cast<Kind>(found - kind_table.begin())};
}

}  // namespace fantail::detection
