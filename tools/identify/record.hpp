// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace fantail::identify {

/// The rocket as the roll model needs it. Only area times alpha and area times beta show in a transient.
struct Airframe {
  double inertia_kg_m2 = 0.0;      ///< I, above zero
  double reference_area_m2 = 0.0;  ///< A, above zero
};

/// One window of a log, ready for the model. All lists that are not empty are as long as time_s. Between two samples
/// canard angle, speed and density run straight.
struct Record {
  std::vector<double> time_s;  ///< 0 at the begin of the window, strictly increasing
  std::vector<double> roll_angle_rad;
  std::vector<double> roll_rate_rad_s;
  std::vector<double> canard_rad;
  std::vector<double> speed_m_s;
  std::vector<double> density_kg_m3;
  std::vector<double> reference_rad;   ///< empty where nobody needs it: closed loop only
  std::vector<double> excitation_rad;  ///< likewise
  std::vector<bool> in_control;        ///< likewise: the command is zero where false
  /// First sample of each stretch without a gap; the first is 0. Behind a gap the model starts anew from what was
  /// measured there, because nobody knows where the canards stood meanwhile.
  std::vector<std::size_t> segment_begin{0};
  double window_begin_s = 0.0;  ///< on the log's clock
  std::string window;           ///< what the person called it: "control", "0.4:2"

  [[nodiscard]] std::size_t size() const { return time_s.size(); }
};

}  // namespace fantail::identify
