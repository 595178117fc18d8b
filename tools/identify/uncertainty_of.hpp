// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include <Eigen/Core>

#include "identify/estimate.hpp"
#include "identify/identification.hpp"
#include "identify/record.hpp"
#include "identify/sensitivities.hpp"
#include "identify/uncertainty.hpp"

namespace fantail::identify {

/// The sum of squared angle errors when everything but alpha is fitted.
using AlphaProfile = std::function<double(double alpha_m2)>;

/// How well a least-squares model is known: the spread that its residual, with its own memory, gives the numbers of the
/// model. With Start::measured the noise of the measured starts is part of it.
[[nodiscard]] Uncertainty uncertainty_of(const Record& record, const Model& model, const Simulation& simulation,
                                         const Sensitivities& sensitivities, Start start, const AlphaProfile& profile);

/// The least standard deviations that any unbiased method could reach (Cramer-Rao) with white angle noise and exactly
/// known starts; in the order alpha, beta, nodes.
[[nodiscard]] Eigen::VectorXd cramer_rao_standard_deviations(const Sensitivities& sensitivities,
                                                             double angle_noise_rad);

/// How far the canards moved apart from what the nodes could have done themselves (root mean square).
[[nodiscard]] double excitation_rad(const Record& record, const NodeTimes& nodes);

/// Of Student's distribution: 97.5 % lie below. To 1 % from 3 degrees of freedom on; fewer than 2 count as 2.
[[nodiscard]] double student_975(double degrees_of_freedom);

}  // namespace fantail::identify
