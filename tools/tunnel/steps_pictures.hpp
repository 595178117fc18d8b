// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "result/document.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {

/// A figure of one step that lies apart from those of the others.
struct Outlier {
  std::size_t step = 0;    ///< its number
  std::size_t figure = 0;  ///< of step_fields
  double value = 0.0;      ///< in SI and radians, as the figure
  double median = 0.0;     ///< of all steps
};

/// By steps. Apart is what is farther from the median than 3.5 times the spread, which is the median distance from it
/// over 0.6745 (modified z-score; Iglewicz and Hoaglin 1993): a few that are wrong do not widen it. None of fewer than
/// five steps, where nobody can say which are the odd ones, of a figure in which half of them agree to the last bit,
/// and of what is nearer than 2 % (an angle or a rate: 0.1 deg or deg/s), which nobody would look for in a tunnel.
[[nodiscard]] std::vector<Outlier> outliers(const StepTable& table);

/// All steps over each other in one chart, each from its own begin and in the sense of its step; the odd ones are
/// named.
[[nodiscard]] std::vector<result::Block> overlay(const StepTable& table);
/// Damping, torque and disturbance over the steps, with their means.
[[nodiscard]] std::vector<result::Block> over_steps(const StepTable& table);
/// Each step alone, measured and modelled.
[[nodiscard]] std::vector<result::Block> responses(const StepTable& table);

}  // namespace fantail::tunnel
