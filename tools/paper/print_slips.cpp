// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "paper/recomputed.hpp"

namespace fantail::paper {
namespace {

void add_geometry(std::vector<Claim>& slips) {
  constexpr double section_radius_mm = 300.0;
  constexpr double body_diameter_mm = 80.0;
  constexpr double canard_radial_mm = 60.0;
  slips.push_back(
      slip("Section 4.1", "Distance from the rocket's outermost point to the wall", "160 mm",
           fmt::format("{:g} or {:g} mm", section_radius_mm - (body_diameter_mm / 2.0 + canard_radial_mm),
                       section_radius_mm - canard_radial_mm),
           "The section is 600 mm wide and the body 80 mm. 200 mm if canards and fins reach 60 mm beyond the body, 240 "
           "mm if they end 60 mm from the axis. 160 mm is 300 \u2212 (80 + 60): it uses the diameter as the radius. "
           "Either way it stays out of the 200 mm at the wall where the air is printed to be slower."));
  slips.push_back(slip("Section 4.1.2", "Where the swirl is, from the centre of the tunnel", "100 to 300 mm",
                       "50 to 150 mm",
                       "It follows from fins of 100 and 300 mm diameter, which reach half as far. At 300 mm is the "
                       "wall."));
  slips.push_back(slip("Section 2.1", "Pine along the test section", "77 \u00d7 38 mm", "75 \u00d7 38 mm",
                       "The next sentence, section 2.2.1 and figure 4 have 75 mm."));
}

void add_signs_and_units(std::vector<Claim>& slips) {
  slips.push_back(slip("Table 2, step 7", "Sign of the offset at the end", "7.41", "\u22127.41",
                       "All other offsets are negative, and the printed mean of the column, 6.62, needs it."));
  slips.push_back(slip("Table 2, mean", "Sign of the mean offset at the end", "6.62", "\u22126.62",
                       "The mean of the eight rows with step 7 at \u22127.41 is \u22126.616."));
  slips.push_back(
      slip("Table 2", "Heading of the error columns", "roll rate, then roll angle", "roll angle, then roll rate",
           "The text gives 0.88 degrees and 3.52 deg/s as means, in the columns' order, and 0.6 to 3.6 % of 45 "
           "degrees fits only the first column."));
  slips.push_back(slip("Section 4.2, Eq 39", "Unit of the mean angle error, open loop", "1.51 deg/s", "1.51 deg",
                       "It is an angle; that of the closed loop is printed in degrees."));
  slips.push_back(slip("Section 4.3.2, Eq 49 and 52", "Unit of the mean angle errors of both windows",
                       "0.26 deg/s and 0.99 deg/s", "0.26 deg and 0.99 deg",
                       "They are angles; the text calls 0.26 an angle in degrees."));
  slips.push_back(slip("Section 4.3.2",
                       "Sign of the offset that the second window's \u22124.7 degrees is compared with", "4.1",
                       "\u22124.1", "Section 4.3.1 has \u22124.1."));
  slips.push_back(slip("Eq 10 and 29", "Derivative term of the controller", "kd (R \u2212 p)", "kd (dR/dt \u2212 p)",
                       "An angle minus a rate. With a stepped reference dR/dt is zero between the steps."));
  slips.push_back(slip("Notation", "Unit of the inertia", "kg/m2", "kg m2",
                       "A moment of inertia is a mass times a distance squared, as Table 1 has it."));
}

void add_notation(std::vector<Claim>& slips) {
  slips.push_back(slip("Notation", "Individual canard commands", "cmd_1, ..., cmd_2", "cmd_1, ..., cmd_4",
                       "A rocket has four canards, and Eq 32 adds four commands."));
  slips.push_back(slip("Notation", "Individually measured encoders", "enc_1, ..., enc_2", "enc_1, ..., enc_4",
                       "Eq 33 adds four, and section 4.2 names enc_1 to enc_4."));
  slips.push_back(slip(
      "Notation", "\u03bc|p| and \u03bc|\u03d5|, OL and CL", "mean absolute roll rate and roll angle of controllers",
      "mean absolute errors of models in roll rate and roll angle",
      "Eq 38, 39, 41, 42, 48, 49, 51 and 52 call each a mean absolute error. Both models have the same "
      "controller: open and closed loop name the source of the model's canard angle."));
  slips.push_back(slip("Eq 22 and 23", "F on the right-hand sides", "without OL or CL", "F^OL and F^CL",
                       "Eq 13 and 14 define the two, and the left-hand sides have them. F is not in the notation."));
}

void add_contradictions(std::vector<Claim>& slips) {
  slips.push_back(
      slip("Section 4.3.2, Eq 50", "Second window's damping and torque constant", "23.0 and 9.0, a repetition of Eq 47",
           "beta = 8",
           "The text calls the damping significantly larger than all of table 2, whose largest is 27. It has the "
           "torque constant 16.7 % off, which is 8, and also names 8 and 9. The damping was lost."));
  slips.push_back(slip(
      "Section 4.3.2", "Where the offset of launch 2 was lower", "for the smaller fin movements", "for the larger ones",
      "Section 5: \u201cwith high dynamic movement in the canards the identified fin offset was "
      "lower\u201d. In table 2, which the sentence refers to, it is lower at the begin of a step, where "
      "the canards move most."));
  slips.push_back(slip("Section 4.3", "Canards of launch 2", "two new ones, 3D printed", "fibreglass",
                       "Table 1 and section 3.1 have the fibreglass canards of the supersonic avionics stack."));
  slips.push_back(slip("Section 4.1.2", "Rocket whose back fins were damaged, so that it missed the swirl test",
                       "of figure 8b (launch 1)", "of figure 8c (launch 2)",
                       "Launch 1 was recovered without two canards (section 4.2). Stony ground and a gust damaged the "
                       "fins of launch 2 (section 4.3.2), and the swirl test came after it (section 5)."));
  slips.push_back(slip("Section 4.1.2, figure 14", "Which panel shows the roll rate", "14a in the text", "14b",
                       "The caption has the fan speeds as (a) and the roll rate as (b)."));
  slips.push_back(slip("Eq 34", "Grid of torque constants", "5, 5.5, 6.5, 7, ..., 15", "5, 5.5, 6, 6.5, ..., 15",
                       "Step 4 of Table 2 was identified as 6.0."));
  slips.push_back(slip("Eq 34", "Grid of dampings", "1, 2, ..., 60", "a step of 0.5 for launch 1",
                       "8.5 and 7.5 were identified, which are not on a grid of whole numbers."));
  slips.push_back(slip("Section 4.2", "Largest change of the torque constant over two to six thrust intervals", "0.05",
                       "0 or at least 0.5", "The grid of Eq 34 has steps of 0.5."));
  constexpr double frequency_hz = 0.1;
  slips.push_back(
      slip("Section 4.3.1", "First half of the data in each step response, at a reference of 0.1 Hz", "5 s",
           fmt::format("{:.1f} s", 0.25 / frequency_hz),
           fmt::format("A square wave of 0.1 Hz steps every {:.0f} s: 5 s is the whole of a response, and its first "
                       "half lasts 2.5 s. With the 5 s of T1 as a half, the reference was one of 0.05 Hz.",
                       0.5 / frequency_hz)));
}

}  // namespace

std::vector<Claim> print_slips() {
  std::vector<Claim> slips;
  add_geometry(slips);
  add_signs_and_units(slips);
  add_notation(slips);
  add_contradictions(slips);
  return slips;
}

}  // namespace fantail::paper
