// SPDX-License-Identifier: MIT
#pragma once

#include "identify/identification.hpp"
#include "identify/sensitivities.hpp"

namespace fantail::identify {

/// Flies `model` through the record with the flight controller in the loop: what the rocket should have done. The
/// canard angles of the result are the commands. Throws as closed_loop_course() does.
[[nodiscard]] Simulation simulate_closed_loop(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                                              const Model& model);

/// How much angle and rate move with the numbers of the model and with the states at the begin of the segments, carried
/// along through plant, servo and controller: while a command is at its limit it does not depend on anything.
struct ClosedLoopSensitivities {
  Sensitivities angle{};
  Sensitivities rate{};
};
[[nodiscard]] ClosedLoopSensitivities closed_loop_sensitivities(const Record& record, const Airframe& airframe,
                                                                const ClosedLoop& loop, const Model& model);

}  // namespace fantail::identify
