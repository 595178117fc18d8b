// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "sim/random.hpp"
#include "sim/rotation.hpp"

namespace fantail::sim {

struct WindParameters {
  double speed_m_s = 0.0;            ///< at the reference height
  double from_rad = 0.0;             ///< where it comes from: 0 north, a quarter of a turn east
  double reference_height_m = 10.0;  ///< above zero
  double exponent = 0.0;             ///< of the speed over height; 0: the same at every height; 1/7 over open land
  double gust_m_s = 0.0;             ///< at its height, in the direction of the wind; below zero: against it
  double gust_time_s = 0.0;          ///< when it begins, after ignition
  double gust_duration_s = 1.0;      ///< above zero
  double turbulence = 0.0;           ///< standard deviation of each horizontal component over the speed at that height
};

/// How well the wind of a launch is known beforehand. What draws winds makes use of it (a prediction), not a flight.
struct WindSpread {
  double speed_m_s = 0.0;      ///< standard deviation
  double direction_rad = 0.0;  ///< at most, to both sides; half a turn: nobody knows
};

/// Wind over height and time: a power-law profile, one gust of the form 1 - cos, and Dryden turbulence.
///
/// Turbulence (MIL-F-8785C, 3.7): the rocket flies through eddies that stand still, so that what it meets changes over
/// the time that it needs for a scale length. It flies upwards; hence the vertical component has the longitudinal
/// spectrum and the horizontal ones the transverse spectrum. Lengths and the share of the vertical component follow the
/// height above ground as the specification has it. The processes are exact for every step length.
class Wind {
 public:
  Wind(const WindParameters& parameters, Random random);

  /// The wind at `time_s` after ignition, `dt_s` (not negative) after the last call, for a rocket at this height that
  /// moves through the air with this speed. Earth: north, west, up.
  [[nodiscard]] Vector3 step(double time_s, double dt_s, double height_m, double air_speed_m_s);

  /// Without gust and turbulence.
  [[nodiscard]] double mean_m_s(double height_m) const;

 private:
  /// The transverse spectrum, two first-order lags one behind the other; standard deviation 1.
  struct Transverse {
    double first = 0.0;
    double second = 0.0;
    [[nodiscard]] double value() const;
  };
  /// Of the horizontal components and of the vertical one, at a height above ground.
  struct Eddies {
    double horizontal_length_m = 0.0;
    double vertical_length_m = 0.0;
    double vertical_share = 0.0;  ///< of the horizontal standard deviation
  };
  [[nodiscard]] static Eddies eddies_at(double height_m);
  /// The rocket goes past them with this speed.
  void step_turbulence(double dt_s, const Eddies& eddies, double past_m_s);

  WindParameters parameters_;
  Vector3 direction_;  ///< it blows to there
  Random random_;
  Transverse along_;
  Transverse across_;
  double vertical_;  ///< standard deviation 1
  Eddies eddies_{};
  double eddies_height_m_ = std::numeric_limits<double>::quiet_NaN();  ///< no height yet
};

}  // namespace fantail::sim
