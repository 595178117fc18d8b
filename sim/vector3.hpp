// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::sim {

/// Three components in the rocket's body frame: x along the axis towards the nose; positive roll turns y towards z.
struct Vector3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

}  // namespace fantail::sim
