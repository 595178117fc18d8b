// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/axes.hpp"
#include "result/answer.hpp"

namespace fantail::bench {

/// A tilt about the axes y and z of the body, without what the rocket rolled beside it.
struct Tilt {
  double y_rad;
  double z_rad;
};

/// One tilt as the gyro and as each accelerometer sees it; empty: it gave nothing valid.
struct TiltSeen {
  Tilt gyro{};
  std::array<std::optional<Tilt>, accelerometer_count> accelerometer{};
};

struct AxesResult {
  ForcesAtRest upright_m_s2{};
  sim::Vector3 roll_rad{};  ///< about the three axes of the gyro, while the rocket was rolled once around
  std::array<TiltSeen, 2> tilts{};
  bool right = false;
  std::vector<std::string> sentences{};  ///< what is wrong; or that all is right
  std::string plan_lines{};  ///< with these in the plan the same turns would be right; empty: nothing is known to help
};
[[nodiscard]] AxesResult judge_axes(const TurnsSeen& seen);

[[nodiscard]] std::string axes_text(const AxesResult& result);
[[nodiscard]] std::string axes_json(const AxesResult& result, const result::Made& made = {});

/// What stays unchecked, a sentence.
[[nodiscard]] std::string_view unchecked_of_axes();

}  // namespace fantail::bench
