// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "sim/thrust_curve.hpp"

namespace fantail::input {

struct RaspMotor {
  std::string name;
  sim::ThrustCurve curve;
  double total_kg = 0.0;               ///< of the loaded motor, at least its propellant
  double diameter_m = 0.0;             ///< of its case; 0 in files that do not say it
  double length_m = 0.0;               ///< likewise
  std::optional<std::string> warning;  ///< what was assumed to make sense of the file
};

/// Reads a motor from a RASP file (.eng): comment lines (;), then
///   name diameter_mm length_mm delays propellant_kg total_kg maker
/// and one "seconds newtons" pair a line; numbers may have a decimal comma, names spaces (which become underscores),
/// and the maker may be missing. Or one of RockSim (.rse), whose lines then count as in that form. A first point after
/// ignition means that thrust rises from zero at ignition; a last one with thrust, that it ends there, with a warning;
/// two at one time are a step. A warning also names masses and sizes that no motor has. Of several motors in one file
/// `motor` names one, which is then the only one that is judged: "K550", "K550:MAKER" or "K550:2", the second of that
/// name; without it they are refused. Throws text::Error: no_such_input, or bad_data as "file:line: value; rule".
[[nodiscard]] RaspMotor load_rasp(const std::filesystem::path& file, const std::optional<std::string>& motor = {});

/// What no motor has, because its file is in other units than RASP's, as a sentence; empty: nothing.
[[nodiscard]] std::string odd_units(const RaspMotor& motor);

}  // namespace fantail::input
