// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "identify/model/roll_model.hpp"

namespace fantail::identify::model {

/// What a fit makes least of the angle errors.
enum class Loss : std::uint8_t {
  squares,
  huber,  ///< squares up to a threshold, and beyond it in proportion to the distance (Huber 1964)
};

/// An open-loop fit that a few wrong samples cannot pull away.
struct RobustFit {
  RollModel model;
  double threshold_rad;  ///< 1.345 standard deviations of the noise, these from the median of the errors
  std::size_t beyond;    ///< samples with a larger error
  bool settled;          ///< false: the model still moved when the search was ended
  /// The record as least squares would have to see it to find the same model with the same uncertainty (Huber 1973):
  /// modelled angles plus errors that are cut at the threshold and divided by the share of those that are not.
  Record pseudo_record;
};

/// Initial values are fitted, too: a model cannot begin with a sample that may be wrong.
[[nodiscard]] RobustFit fit_open_loop_robustly(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                               const Grid& grid);

}  // namespace fantail::identify::model
