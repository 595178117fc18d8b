// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "identify/closed_loop/loop.hpp"
#include "identify/model/roll_model.hpp"
#include "paper/flown_record.hpp"

namespace fantail::identify::closed_loop {

/// The first launch (t = 0 at launch detection): from 1.47 s on the canards stand at their limit of 6 degrees.
[[nodiscard]] paper::Loop first_launch();
/// Where its disturbance has corners.
[[nodiscard]] model::NodeTimes first_launch_nodes();

/// The second launch (t = 0 at control start): never at its limit for long.
[[nodiscard]] paper::Loop second_launch();
/// The same with the published chirp, which drives the canards to their limit and back.
[[nodiscard]] paper::Loop second_launch_with_chirp();

/// The modes of the law beyond the publication.
[[nodiscard]] paper::Loop with_integral(paper::Loop loop);
[[nodiscard]] paper::Loop with_observer(paper::Loop loop);  ///< that knows the rocket as it is
[[nodiscard]] paper::Loop with_schedule(paper::Loop loop);

/// Four seconds of noise in what the law measures, once a millisecond: 0.3 deg of the angle, 1 deg/s of the rate.
[[nodiscard]] paper::Loop with_noise(paper::Loop loop, std::uint64_t seed);

/// What a log of this run would hold, with the columns that the closed loop needs, and no noise.
[[nodiscard]] model::Record closed_loop_record(const paper::Loop& loop, double to_s, int every_ms);

[[nodiscard]] Control controller_of(const paper::Loop& loop);

/// What the run was made with. The nodes lie on the run's own disturbance.
[[nodiscard]] model::RollModel truth(const paper::Loop& loop, const model::NodeTimes& node_time_s);

/// All numbers of a model near those of the truth: alpha 0.01 m2, beta 0.001 m, nodes 0.01 degrees, times a factor.
void expect_same(const model::RollModel& found, const model::RollModel& truth, double times = 1.0);

}  // namespace fantail::identify::closed_loop
