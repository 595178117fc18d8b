// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "sim/atmosphere.hpp"

namespace fantail::sim {

/// An atmosphere for somebody who moves through it in small steps: the exponential is taken four times for each layer
/// of 20 m entered and a cubic does the rest, to 1e-12 of the density. The result depends on the height alone, not on
/// the way there. One user at a time: it remembers the layer.
class LocalDensity {
 public:
  explicit LocalDensity(const Atmosphere& atmosphere) : atmosphere_{atmosphere} { enter(0.0); }

  /// kg/m3.
  [[nodiscard]] double at(double height_m) {
    if (!(height_m >= floor_m_ && height_m < floor_m_ + layer_m)) {
      enter(height_m);
    }
    const double s = (height_m - floor_m_) * (1.0 / layer_m);
    return (c0_ + c1_ * s) + (s * s) * (c2_ + c3_ * s);
  }

 private:
  // Divides the 11 km of the ISA's tropopause, so that its kink lies between two layers.
  static constexpr double layer_m = 20.0;

  // The cubic through four heights of the layer, floor and ceiling among them: neighbours agree at the boundary.
  void enter(double height_m) {
    floor_m_ = layer_m * std::floor(height_m / layer_m);
    const double f0 = atmosphere_.density_kg_m3(floor_m_);
    const double f1 = atmosphere_.density_kg_m3(floor_m_ + layer_m / 3.0);
    const double f2 = atmosphere_.density_kg_m3(floor_m_ + layer_m * 2.0 / 3.0);
    const double f3 = atmosphere_.density_kg_m3(floor_m_ + layer_m);
    c0_ = f0;
    c1_ = 0.5 * (-11.0 * f0 + 18.0 * f1 - 9.0 * f2 + 2.0 * f3);
    c2_ = 0.5 * (18.0 * f0 - 45.0 * f1 + 36.0 * f2 - 9.0 * f3);
    c3_ = 0.5 * (-9.0 * f0 + 27.0 * f1 - 27.0 * f2 + 9.0 * f3);
  }

  Atmosphere atmosphere_;
  double floor_m_ = 0.0;
  double c0_ = 0.0;
  double c1_ = 0.0;
  double c2_ = 0.0;
  double c3_ = 0.0;
};

}  // namespace fantail::sim
