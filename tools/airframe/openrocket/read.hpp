// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry.hpp"

namespace fantail::airframe::openrocket {

/// A motor that a design can fly with.
struct NamedMotor {
  std::string configuration;  ///< the key of the flight configurations that have it
  std::string designation;
  double length_m = 0.0;    ///< of the casing
  double diameter_m = 0.0;  ///< likewise
};

/// Where a design holds its motor.
struct MotorPlace {
  double end_m = 0.0;   ///< of the nozzle, from the tip of the nose
  int count = 1;        ///< of a cluster: all of one kind, lit at once
  double ring_m = 0.0;  ///< root mean square of their distances from the long axis
  std::vector<NamedMotor> motors{};

  /// Those that a file of thrust calls by this name: by their class and mean thrust, as "I150" of "1115-I150WH-14A".
  [[nodiscard]] std::vector<NamedMotor> called(const std::string& name) const;
};

/// What stability depends on and the reader left out or may have wrong, as a part of a sentence.
struct LeftOut {
  std::string what;
  bool is_force = false;  ///< not (only) a mass, which an override of a whole can replace
};

/// A simulated flight that a design file has stored. Lengths from the tip of the nose.
struct StoredFlight {
  std::string name;
  std::string configuration;
  std::optional<double> mass_kg{};               ///< at lift-off
  std::optional<double> centre_of_gravity_m{};   ///< likewise
  std::optional<double> centre_of_pressure_m{};  ///< of the slow ascent, at the smallest angle of attack
  double angle_of_attack_rad = 0.0;              ///< there
  std::optional<double> margin_calibres{};       ///< there
};

/// What could be used of a design.
struct Design {
  std::string name;
  sim::Geometry geometry;  ///< without propellant
  std::optional<MotorPlace> motor;
  std::vector<std::string> not_used;  ///< what is in the file and is left out, a sentence each
  std::vector<std::string> assumed;   ///< what was taken in the place of something, a sentence each
  std::vector<LeftOut> left_out;
  std::vector<StoredFlight> flights;  ///< those that belong to the design as it is
};

/// Reads the first stage of a design of OpenRocket (.ork; document versions 1.0 to 1.10, and later ones of major
/// version 1 with a word in `not_used`). Masses follow from materials and sizes as OpenRocket has them, and from its
/// overrides. An override that its versions read differently is refused, and so is a part whose centre of gravity is
/// outside of the rocket, and a first stage without a motor when a later one has one. The rearmost set of three fins or
/// more are the fins. `canards` is the name of those that are the canards; empty: four that are ahead of the fins, and
/// in the front half or smaller. All others are further fins. What is in a component that is neither read nor known to
/// change nothing is left out by name. Throws text::Error: no_such_input; bad_data for what is no design, and for
/// numbers that are missing or out of range, by component.
[[nodiscard]] Design read_design(const std::filesystem::path& file, const std::string& canards = {});

}  // namespace fantail::airframe::openrocket
