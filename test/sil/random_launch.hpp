// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "random_stream.hpp"
#include "sim/scenario.hpp"

namespace fantail::sil {

class Draw {
 public:
  explicit Draw(std::uint32_t seed) : stream_{seed} {}
  double between(double low, double high) { return low + (high - low) * stream_.unit(); }
  /// Of mean 0 and variance 1 (Box and Muller, 1958).
  double normal() {
    const double size = std::sqrt(-2.0 * std::log(1.0 - stream_.unit()));
    return size * std::cos(2.0 * std::numbers::pi * stream_.unit());
  }
  bool chance(double share) { return stream_.unit() < share; }
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(between(0.0, static_cast<double>(count))));
  }

 private:
  core::RandomStream stream_;
};

/// The second launch with a plan and a rocket of its own, without faults.
sim::Scenario random_rocket(Draw& draw);

/// One more fault, of any kind, at any moment.
void draw_fault(sim::Scenario& scenario, Draw& draw);

}  // namespace fantail::sil
