// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/scenario.hpp"
#include "stability/roll_loop.hpp"
#include "stability/speed_range.hpp"
#include "tune/law.hpp"
#include "tune/request.hpp"
#include "tune/speeds_flown.hpp"

namespace fantail::tune {

/// Asks the linear loops of the vehicle and the corners of the spread, at some speeds under control, whether they
/// tolerate a law.
class LinearTrial {
 public:
  LinearTrial(const sim::Scenario& scenario, const SpeedsFlown& speeds, const Request& request);

  /// The schedule of all laws that follow; see Law::schedule_exponent.
  void set_exponent(double exponent);
  [[nodiscard]] double exponent() const { return exponent_; }
  /// By how much the schedule raises the gains, in the mean of the rest that they leave over the time under control.
  [[nodiscard]] double mean_factor() const { return mean_factor_; }

  [[nodiscard]] bool has_phase_margin(const Law& law);
  [[nodiscard]] bool has_gain_margin(const Law& law) const;
  /// Of the slowest, from the median speed on; empty: longer than that.
  [[nodiscard]] std::optional<double> settling_s(const Law& law, double longest_s);
  [[nodiscard]] stability::MarginAtSpeed least_margin(const Law& law) const;

 private:
  struct LoopsAtSpeed {
    double speed_m_s;
    std::vector<stability::RollLoop> loops;
  };
  [[nodiscard]] bool fails_at(const LoopsAtSpeed& at, const Law& law) const;
  [[nodiscard]] const LoopsAtSpeed& median() const;

  sim::Scenario scenario_;
  SpeedsFlown speeds_;
  Request request_;
  std::vector<sim::Scenario> airframes_;
  std::vector<LoopsAtSpeed> all_;
  double exponent_ = 0.0;
  double mean_factor_ = 1.0;
  std::size_t failed_at_ = 0;
  std::size_t slow_airframe_ = 0;
};

/// How far a step of the reference has been followed, after every millisecond: 0 to begin with, 1 in the end. The
/// linear loop at its one speed, without noise, play or limits.
[[nodiscard]] std::vector<double> step_response(const stability::RollLoop& loop, double duration_s);

/// How long after a step of the reference the roll angle stays within a tenth of the step of it. Empty: longer than
/// `longest_s`, or never.
[[nodiscard]] std::optional<double> settling_s(const stability::RollLoop& loop, double longest_s);

}  // namespace fantail::tune
