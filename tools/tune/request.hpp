// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "core/flight_plan.hpp"
#include "runs/folder.hpp"
#include "stability/margins_asked.hpp"

namespace fantail::tune {

/// What a law is asked to give.
struct Request {
  core::OffsetRejection rejection = core::OffsetRejection::integral;
  bool schedule = false;
  double phase_margin_rad = stability::comfortable_phase_margin_rad;  ///< at every corner of the spread
  double settling_s = 1.0;                                            ///< see settling_s() of a loop
  double spread = 1.5;  ///< damping and torque are each within this factor of the vehicle's
  std::size_t flights = 24;
  unsigned threads = 0;                ///< 0: as many as the machine has; no figure depends on it
  const runs::Folder* kept = nullptr;  ///< of finished flights; null: none are kept
  std::string command{};               ///< that repeats it
  std::string scenario_command{};      ///< the same without what this struct has: "fantail tune NAME --seed 7"
  bool replaces = false;               ///< a plan that an earlier run wrote
  std::string version{};               ///< of the program
};

}  // namespace fantail::tune
