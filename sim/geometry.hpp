// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace fantail::sim {

/// What a rocket looks like from outside and how its mass is spread, as drawn or weighed. Nothing in a flight follows
/// from it: it is what the aerodynamic numbers of a vehicle are computed from (fantail airframe), or held against.
/// Positions count from the tip of the nose towards the tail.
struct Geometry {
  enum class NoseShape : std::uint8_t { cone, ogive, ellipsoid, parabola, haack };

  /// Flat trapezoids, evenly spaced around the body, their root chord along it.
  struct FinSet {
    int count = 4;              ///< 1 to 8; of the fins at least three, and four canards
    double position_m = 0.0;    ///< where the leading edge meets the body
    double root_chord_m = 0.0;  ///< above zero
    double tip_chord_m = 0.0;   ///< not negative
    double span_m = 0.0;        ///< from the body's surface to the tip, above zero
    double sweep_m = 0.0;       ///< how far behind the root's leading edge that of the tip is; negative: swept forward
    double thickness_m = 0.003;
    double cant_rad = 0.0;  ///< all turned alike: positive rolls the rocket as positive canards do
  };

  /// Fins beside the fins and the canards. One or two hold the rocket in one plane more than in the other.
  struct MoreFins {
    std::string name;
    double first_angle_rad = 0.0;  ///< of the first one around the body, from anywhere that all sets count from
    FinSet set;
  };

  /// A length over which the diameter changes; behind it the body goes on with the new one.
  struct Transition {
    double position_m = 0.0;      ///< of its front
    double length_m = 0.0;        ///< above zero
    double aft_diameter_m = 0.0;  ///< above zero
  };

  /// A part of the rocket without its propellant. A point has neither length nor radius.
  struct Mass {
    std::string name;
    double mass_kg = 0.0;
    double position_m = 0.0;            ///< of its middle
    double length_m = 0.0;              ///< along the rocket
    double radius_of_gyration_m = 0.0;  ///< about the long axis: a thin tube's radius, 0.707 times that of a full rod
  };

  /// What the design file that a shape was read from says of the whole rocket, and what of it was left out.
  struct Design {
    std::string file;
    std::string flight{};             ///< the simulated flight whose numbers follow; empty: none is stored
    std::optional<double> mass_kg{};  ///< at lift-off, as all of them
    std::optional<double> centre_of_gravity_m{};
    std::optional<double> centre_of_pressure_m{};  ///< at angle_of_attack_rad
    double angle_of_attack_rad = 0.0;
    std::optional<double> margin_calibres{};  ///< some time between lift-off and burn-out
    std::vector<std::string> left_out{};      ///< what a mass, a place or a force depends on
  };

  NoseShape nose_shape = NoseShape::ogive;
  double nose_length_m = 0.0;
  double diameter_m = 0.0;                ///< of nose and body: a calibre
  double length_m = 0.0;                  ///< of the whole rocket
  std::vector<Transition> transitions{};  ///< from nose to tail, none within another
  std::optional<FinSet> fins{};
  std::optional<FinSet> canards{};
  std::vector<MoreFins> more_fins{};
  std::optional<double> canard_hinge_m{};  ///< the shaft, behind the leading edge at the root
  std::vector<Mass> masses{};
  std::optional<Mass> propellant{};  ///< where it lies; its mass is the motor's
  std::optional<Design> design{};    ///< empty: the shape was not read from a design file
};

}  // namespace fantail::sim
