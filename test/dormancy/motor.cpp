// SPDX-License-Identifier: MIT
#include "dormancy/motor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace fantail::dormancy {

std::string_view name(Family family) {
  constexpr std::array<std::string_view, families> names{"neutral", "regressive",    "progressive", "boost-sustain",
                                                         "tail",    "unlisted tail", "steep end",   "erosive spike",
                                                         "hump",    "fading"};
  return names[static_cast<std::size_t>(family)];
}

Motor::Motor(Family family, std::size_t variant)
    : family_{family},
      v_{static_cast<double>(variant) / static_cast<double>(variants - 1)},
      end_{family == Family::steep_end ? 0.004 : 0.02 + 0.1 * v_} {
  constexpr int steps = 2'000;
  double highest = 0.0;
  for (int i = 0; i < steps; ++i) {
    highest = std::max(highest, shape((i + 0.5) / steps));
  }
  peak_ = highest;
  for (int i = 0; i < steps; ++i) {
    const double time = (i + 0.5) / steps;
    mean_ += thrust(time) / steps;
    if (thrust(time) > 0.02) {
      last_thrust_ = time;
    }
  }
  published_ = family == Family::unlisted_tail ? 0.9 - 0.2 * v_ : last_thrust_;
}

double Motor::shape(double time) const {
  const double v = v_;
  const double whole = std::clamp((1.0 - time) / end_, 0.0, 1.0);
  switch (family_) {
    case Family::neutral:
    case Family::steep_end: return whole;
    case Family::regressive: return (1.0 - (0.3 + 0.6 * v) * time) * whole;
    case Family::progressive: return (0.8 - 0.5 * v + (0.2 + 0.5 * v) * time) * whole;
    case Family::boost_sustain: {
      const double sustained = 0.42 - 0.3 * v;
      return std::clamp(1.0 - (time - 0.15 - 0.35 * v) / 0.04, sustained, 1.0) * whole;
    }
    case Family::tail:
    case Family::unlisted_tail: {
      const double level = 0.021 + 0.029 * v;
      const double main = (1.0 - 0.3 * time) * std::clamp((0.9 - 0.2 * v - time) / 0.05, 0.0, 1.0);
      return time >= 1.0 ? 0.0 : std::max(main, level);
    }
    case Family::erosive_spike: return (1.0 + (0.4 + 1.1 * v) * std::exp(-time / 0.05)) * whole;
    case Family::hump: {
      const double from_middle = 2.0 * time - 1.0;
      return (1.0 - (0.3 + 0.5 * v) * from_middle * from_middle) * whole;
    }
    case Family::fading: {
      const double begin = 0.6 - 0.4 * v;
      return std::exp(-std::max(0.0, time - begin) * std::log(50.0) / (1.0 - begin)) * std::min(1.0, whole * 2.0);
    }
  }
  return 0.0;
}

double Motor::thrust(double time) const { return time < 0.0 || time >= 1.0 ? 0.0 : shape(time) / peak_; }

}  // namespace fantail::dormancy
