// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry.hpp"

namespace fantail::airframe::openrocket {

/// Where a design holds its motor.
struct MotorPlace {
  double end_m = 0.0;       ///< of the nozzle, from the tip of the nose
  double length_m = 0.0;    ///< of the casing
  double diameter_m = 0.0;  ///< likewise
  std::vector<std::string> designations;
};

/// What could be used of a design.
struct Design {
  std::string name;
  sim::Geometry geometry;  ///< without propellant
  std::optional<MotorPlace> motor;
  std::vector<std::string> not_used;  ///< what is in the file and is left out, a sentence each
  std::vector<std::string> assumed;   ///< what was taken in the place of something, a sentence each
};

/// Reads the first stage of a design of OpenRocket (.ork; document versions 1.0 to 1.10, and later ones of major
/// version 1 with a word in `not_used`). Masses follow from materials and sizes as OpenRocket has them, and from its
/// overrides. The rearmost set of fins are the fins; a set of four in the front half are canards. Throws text::Error:
/// no_such_input; bad_data for what is no design, and for numbers that are missing or out of range, by component.
[[nodiscard]] Design read_design(const std::filesystem::path& file);

}  // namespace fantail::airframe::openrocket
