// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "input/rasp_file.hpp"
#include "input/shipped.hpp"
#include "sim/ascent.hpp"

namespace fantail::paper {

/// A whole ascent with the shipped motor, millisecond by millisecond from lift-off.
class FlownAscent {
 public:
  explicit FlownAscent(double mass_kg) {
    sim::Ascent ascent{{.mass_kg = mass_kg,
                        .drag_area_m2 = 0.0050,
                        .motor = input::load_rasp(input::find_input(input::Shipped::motor, "i150_canonical")).curve}};
    for (int tick = 0; !ascent.events().apogee_s; ++tick) {
      ascent.advance_to(1e-3 * tick);
      if (ascent.events().liftoff_s) {
        speeds_m_s_.push_back(ascent.speed_m_s());
        apogee_m_ = std::max(apogee_m_, ascent.height_m());
        top_speed_m_s_ = std::max(top_speed_m_s_, ascent.speed_m_s());
      }
    }
    time_to_apogee_s_ = *ascent.events().apogee_s - *ascent.events().liftoff_s;
  }

  [[nodiscard]] double apogee_m() const { return apogee_m_; }
  [[nodiscard]] double top_speed_m_s() const { return top_speed_m_s_; }
  [[nodiscard]] double time_to_apogee_s() const { return time_to_apogee_s_; }

  [[nodiscard]] double speed_m_s(double after_liftoff_s) const {
    const double place = after_liftoff_s * 1e3;
    const auto before = static_cast<std::size_t>(place);
    if (before + 1 >= speeds_m_s_.size()) {
      return speeds_m_s_.back();
    }
    return speeds_m_s_[before] + (place - std::floor(place)) * (speeds_m_s_[before + 1] - speeds_m_s_[before]);
  }

 private:
  std::vector<double> speeds_m_s_;
  double apogee_m_ = 0.0;
  double top_speed_m_s_ = 0.0;
  double time_to_apogee_s_ = 0.0;
};

}  // namespace fantail::paper
