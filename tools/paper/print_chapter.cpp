// SPDX-License-Identifier: MIT
// What can be checked with the printed page and a pencil.
#include <cmath>

#include "paper/chapters.hpp"

namespace fantail::paper {
namespace {

double percent(double part, double whole) { return 100.0 * part / whole; }

Claim arithmetic(std::string place, std::string what, double theirs, double ours, int decimals, double tolerance,
                 std::string why_otherwise = {}, std::string unit = "%") {
  return compare({.place = std::move(place),
                  .what = std::move(what),
                  .theirs = theirs,
                  .ours = ours,
                  .unit = std::move(unit),
                  .decimals = decimals,
                  .tolerance = tolerance,
                  .otherwise = Finding::error_in_print,
                  .why_otherwise = std::move(why_otherwise)});
}

}  // namespace

Chapter print_chapter() {
  Chapter chapter{.title = "The print, held against itself",
                  .introduction = "Sums, percentages and repeated numbers that need nothing but the publication."};
  auto& claims = chapter.claims;
  claims.push_back(
      arithmetic("Section 4.1.2", "Reduction of the bare fins' roll rate by the straightener, 87.0 to 25.7 deg/s",
                 340.0, percent(87.0 - 25.7, 87.0), 1, 0.5,
                 "Nothing can be reduced by more than all of it. 87.0 / 25.7 is 3.4: the rate fell to 30 %."));
  claims.push_back(
      arithmetic("Section 4.1", "Distance from the rocket's outermost point to the wall", 160.0, 300.0 - (40.0 + 60.0),
                 0, 0.5, "The section is 600 mm wide, the body 80 mm, canards and fins reach 60 mm beyond it.", "mm"));
  claims.push_back(arithmetic("Section 4.2", "Error of the modelled drop, 26.15 of 27.2 degrees: less than", 4.0,
                              percent(27.2 - 26.15, 27.2), 1, 0.2));
  claims.push_back(arithmetic("Section 4.3.1", "Smallest mean angle error of Table 2 over the step of 45 degrees", 0.6,
                              percent(0.26, 45.0), 1, 0.05));
  claims.push_back(arithmetic("Section 4.3.1", "Largest of them", 3.6, percent(1.64, 45.0), 1, 0.05));
  claims.push_back(arithmetic("Section 4.3.2", "Launch 2's damping, 23, against the tunnel's mean, 19.4", 15.7,
                              percent(23.0 - 19.4, 23.0), 1, 0.05));
  claims.push_back(arithmetic("Section 4.3.2", "Launch 2's torque constant, 9, against the tunnel's mean, 9.6", 4.4,
                              percent(9.6 - 9.0, 9.6), 1, 0.05,
                              "It is 6.2 % of the tunnel's and 6.7 % of the launch's value."));
  claims.push_back(arithmetic("Section 4.3.2", "Mean offset of the launch, 4.9, against the tunnel's, 4.1", 16.3,
                              percent(4.9 - 4.1, 4.9), 1, 0.05));
  claims.push_back(arithmetic("Section 4.3.2", "Second window's torque constant, 8, against the tunnel's mean, 9.6",
                              16.7, percent(9.6 - 8.0, 9.6), 1, 0.05));
  claims.push_back(slip(
      "Section 4.3.2", "Second window's damping and torque constant", "23.0 and 9.0, a repetition of Eq 47", "beta = 8",
      "The text calls the damping far larger than all of the tunnel and the torque constant 16.7 % off, "
      "which is 8; the conclusion names 8 and 9. The damping was lost."));
  claims.push_back(
      slip("Table 2", "Heading of the error columns", "roll rate, then roll angle", "roll angle, then roll rate",
           "The text gives 0.88 degrees and 3.52 deg/s as means, in the columns' order, and 0.6 to 3.6 % of 45 "
           "degrees fits only the first column."));
  claims.push_back(slip("Eq 34", "Grid of torque constants", "5, 5.5, 6.5, 7, ..., 15", "5, 5.5, 6, 6.5, ..., 15",
                        "Step 4 of Table 2 was identified as 6.0."));
  claims.push_back(slip("Eq 34", "Grid of dampings", "1, 2, ..., 60", "a step of 0.5 for launch 1",
                        "8.5 and 7.5 were identified, which are not on a grid of whole numbers."));
  claims.push_back(slip("Section 4.2", "Unit of the mean angle error, open loop", "1.51 deg/s", "1.51 deg",
                        "It is an angle; that of the closed loop is printed in degrees."));
  claims.push_back(slip("Notation", "Unit of the inertia", "kg/m2", "kg m2",
                        "A moment of inertia is a mass times a distance squared, as Table 1 has it."));
  return chapter;
}

}  // namespace fantail::paper
