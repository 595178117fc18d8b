// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::trajectory {

/// A flight that RocketPy or OpenRocket has flown, as a path for a scenario.
struct Trajectory {
  sim::PrescribedPath path;
  std::vector<std::string> notes;  ///< first where the path is from, what was read and what derived; a sentence each
};

/// What the file does not have is derived:
///   horizontal speed  from total and vertical speed, or from one of them and the tilt
///   vertical speed    from total speed and tilt
///   tilt              from horizontal and vertical speed up to apogee, while they tell a direction
///   density           from temperature and pressure
///   felt force        from the speeds, unless the file has the acceleration along the axis
/// Without a tilt and a second speed the rocket goes along the line of the scenario's guide; without density,
/// temperature and pressure, and where density is rounded to more than 2 % of itself (OpenRocket writes 0.001 g/cm3),
/// the scenario's air is at every height. The scenario's atmosphere and guide tilt are all that is taken from it.
///
/// `text` is the content, `name` what messages call it. Throws text::Error (bad_data) as files::parse(), Columns and
/// read_series() do; bad_configuration for a scenario that is no flight.
[[nodiscard]] Trajectory parse_trajectory(std::string text, const std::string& name, const sim::Scenario& scenario);

/// Of a file. Throws also text::Error (no_such_input), and std::system_error for a file that cannot be read.
[[nodiscard]] Trajectory load_trajectory(const std::string& path, const sim::Scenario& scenario);

}  // namespace fantail::trajectory
