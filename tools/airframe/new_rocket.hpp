// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/vehicle.hpp"
#include "text/output_folder.hpp"

namespace fantail::airframe {

/// A rocket that nobody has flown yet.
struct NewRocket {
  std::string name;
  /// With a geometry, a mass, a drag area and a motor; its roll plant and airframe are not looked at.
  sim::Vehicle vehicle;
  std::string motor_file;  ///< as a vehicle file names it
  std::string source;      ///< what its shape was read from
  std::vector<std::string> assumed;
  std::optional<text::NamedFile> motor{};  ///< that lies beside the vehicle from now on; none: a shipped one
};

struct NewFiles {
  std::vector<text::NamedFile> files;
  std::string gains;  ///< a sentence on where those of the plan come from; empty without canards
};

/// vehicle.toml, plan.toml and scenario.toml: roll model, stability and inertia as the shape gives them, gains that
/// suit them, everything that was not measured listed as assumed. The vehicle has an [airframe] where masses and
/// propellant say the centre of gravity.
[[nodiscard]] NewFiles files_of(const NewRocket& rocket);

}  // namespace fantail::airframe
