// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "identify/closed_loop/loop.hpp"
#include "identify/model/roll_model.hpp"
#include "identify/result/findings.hpp"

namespace fantail::identify::result {

/// How well a least-squares model is known: the spread that its residual, with its own memory, gives the numbers of the
/// model. With Start::measured the noise of the measured starts is part of it. `simulation` is the model's own.
[[nodiscard]] Uncertainty open_loop_uncertainty(const model::Record& record, const model::Airframe& airframe,
                                                const model::RollModel& model, const model::Simulation& simulation,
                                                model::Start start);
/// The canards that excite are then the model's commands, whatever the encoders say, if there are any.
[[nodiscard]] Uncertainty closed_loop_uncertainty(const model::Record& record, const model::Airframe& airframe,
                                                  const closed_loop::Control& control, const model::RollModel& model,
                                                  const model::Simulation& simulation, model::Start start);

/// Known within a factor of four: less, and the number is of no use to predict a flight.
[[nodiscard]] bool is_identifiable(const Interval& interval);

/// The least standard deviations that any unbiased method could reach (Cramer-Rao) with white angle noise and exactly
/// known starts; in the order alpha, beta, nodes.
[[nodiscard]] Eigen::VectorXd cramer_rao_standard_deviations(const model::Sensitivities& sensitivities,
                                                             double angle_noise_rad);

/// How far the canards moved apart from what the nodes could have done themselves (root mean square).
[[nodiscard]] double excitation_rad(const model::Record& record, const model::NodeTimes& nodes);

}  // namespace fantail::identify::result
