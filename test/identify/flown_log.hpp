// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "logs/roll_log.hpp"

namespace fantail::test {

/// A log from -1 s to 10 s at 100 Hz: launched at 0, control from 1 s to 9 s, the reference steps at 3 s and at 5 s,
/// thrust until 4 s. Each column is a straight line over time, so that what lies between two samples is known.
inline logs::RollLog flown_log() {
  logs::RollLog log;
  log.name = "flown.csv";
  for (int i = -100; i <= 1000; ++i) {
    const double t = 0.01 * i;
    log.time_s.push_back(t);
    log.roll_angle_rad.push_back(0.5 * t);
    log.roll_rate_rad_s.push_back(0.5);
    log.canard_rad.push_back(0.01 * t);
    log.speed_m_s.push_back(t > 0.0 ? 10.0 * t : 0.0);
    log.height_m.push_back(t > 0.0 ? 5.0 * t * t : 0.0);
    log.specific_force_m_s2.push_back(t < 0.0 ? 9.8 : (t < 4.0 ? 40.0 - 0.1 * t : -5.0));
    log.reference_rad.push_back(t < 3.0 - 1e-9 ? 0.0 : (t < 5.0 - 1e-9 ? 0.3 : -0.3));
    log.excitation_rad.push_back(0.0);
    log.phase.push_back(t < 0.0           ? core::Phase::armed
                        : t < 1.0 - 1e-9  ? core::Phase::launched
                        : t <= 9.0 + 1e-9 ? core::Phase::controlling
                                          : core::Phase::finished);
  }
  return log;
}

/// Takes the samples between two times out of every column.
inline void cut_out(logs::RollLog& log, double from_s, double to_s) {
  const std::vector<double> time_s = log.time_s;
  const auto cut = [&](auto& list) {
    if (list.size() != time_s.size()) {
      return;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < time_s.size(); ++i) {
      if (time_s[i] < from_s || time_s[i] > to_s) {
        list[kept++] = list[i];
      }
    }
    list.resize(kept);
  };
  for (auto* list : {&log.roll_angle_rad, &log.roll_rate_rad_s, &log.canard_rad, &log.speed_m_s, &log.height_m,
                     &log.specific_force_m_s2, &log.reference_rad, &log.excitation_rad}) {
    cut(*list);
  }
  cut(log.phase);
  cut(log.time_s);
}

}  // namespace fantail::test
