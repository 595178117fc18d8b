// SPDX-License-Identifier: MIT
#pragma once

#include "identify/identification.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::benchmark {

/// What all the solvers of the comparison identify: 9 s of a simulated launch from control start on, as the avionics
/// logged them, noise and all. The excitation swings the canards, the speed falls from 80 m/s to a tenth of it, and the
/// disturbance has corners.
struct IdentifyTask {
  identify::model::Record record;
  identify::model::Airframe airframe;
  identify::closed_loop::Control loop;
  identify::model::NodeTimes node_time_s;  ///< five
  /// What the fast search finds over the whole default grid: the others are compared with it.
  identify::model::GridResult expected;
  /// Every sixth alpha and every fourth beta of it, the expected winner among them: for solvers that would take
  /// minutes.
  identify::model::Grid some_points;
};

/// The rates that are compared. Each is flown once.
enum class SampleRate : int { hz_100 = 100, hz_1000 = 1000 };
[[nodiscard]] const IdentifyTask& identify_task(SampleRate rate);

}  // namespace fantail::benchmark
