// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hal/barometer.hpp"
#include "sim/random.hpp"

namespace fantail::sim {

struct BarometerParameters {
  bool is_fitted = false;
  double noise_pa = 1.5;     ///< standard deviation, white from sample to sample, 0 to 500
  double port_error = 0.03;  ///< pressure coefficient at the static ports, -1 to 1; above 0 it reads too low a height
  double vent_lag_s = 0.05;  ///< time constant with which the bay follows the ports, 0 to 5
  double offset_pa = 0.0;    ///< added to every measurement, -5000 to 5000
};

/// The air around the static ports at one instant.
struct AirAtPorts {
  double static_pa = 0.0;   ///< as it would be without the rocket
  double dynamic_pa = 0.0;  ///< 1/2 rho v^2
  double mach = 0.0;
  std::optional<double> since_ejection_s{};  ///< since the recovery system deployed; empty: it has not
};

/// What keeps a barometer from measuring the air now.
struct BarometerFault {
  bool hangs = false;    ///< nothing is measured, and the last sample comes again
  bool blocked = false;  ///< the ports are closed: the bay keeps its pressure
  bool lit = false;      ///< sunlight on the sensing element
};

/// The barometer in the avionics' bay. From the free air to a sample, in this order:
///   1. the port error times the dynamic pressure is added, and near Mach 1 that of the shock that crosses the ports;
///   2. the bay follows as a first-order lag, and the ejection charge adds to it;
///   3. the offset of the device, light and noise are added;
///   4. rounding to the nearest pascal.
/// Every 10 ms a measurement is ready, 5 ms after its middle, whose time it has. In between the old one comes again.
///
/// Example: 89875 Pa at 1000 m; 150 m/s at 1.1 kg/m3 make 12375 Pa, of which a port error of 0.03 adds 371. Climbing
/// there costs 1.6 Pa each millisecond, so a lag of 0.05 s adds 82 more: 90328 Pa, a height of 958 m.
class BarometerModel {
 public:
  static constexpr double shock_error = 0.1;  ///< pressure coefficient at Mach 1, falling to 0 at 0.1 to either side
  static constexpr double ejection_pa = 5000.0;
  static constexpr double ejection_lasts_s = 0.03;  ///< it falls evenly over that
  static constexpr double light_pa = -1500.0;
  static constexpr hal::Microseconds period{10'000};
  static constexpr hal::Microseconds ready_after{5'000};  ///< the middle of its measurement

  /// `random` is this sensor's own stream. Throws std::invalid_argument for a parameter outside its range.
  BarometerModel(const BarometerParameters& parameters, Random random);

  /// What the device delivers at `time`, called every millisecond. Before the first measurement there is no reading.
  [[nodiscard]] const hal::BarometerSample& sample(hal::Microseconds time, const AirAtPorts& air,
                                                   const BarometerFault& wrong);

 private:
  void let_bay_follow(double port_pa, bool blocked);
  [[nodiscard]] hal::BarometerSample measured(hal::Microseconds time, const AirAtPorts& air, bool lit);

  BarometerParameters parameters_;
  Random random_;
  double kept_;       ///< share of a difference that is left after a millisecond
  double lag_ticks_;  ///< the lag in milliseconds
  std::optional<double> bay_pa_{};
  double port_pa_ = 0.0;  ///< a millisecond ago
  std::optional<hal::BarometerSample> next_{};
  hal::BarometerSample latest_{};
};

}  // namespace fantail::sim
