// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/next_row.hpp"

namespace fantail::predict {

/// What one step in the tunnel showed of the airframe.
struct TunnelStep {
  double damping_m2 = 0.0;
  double torque_m = 0.0;
  double offset_begin_rad = 0.0;  ///< equivalent fin offset as the step began, swirl taken off
  double offset_end_rad = 0.0;    ///< five seconds later
};

inline constexpr std::size_t fewest_tunnel_steps = campaign::fewest_rows;

/// A file of tunnel steps, as `fantail tunnel steps` writes them.
struct TunnelResult {
  std::string name;                           ///< of the file, without folder
  std::vector<std::string> sources{};         ///< what the file says of where its rows are from
  std::vector<TunnelStep> steps{};            ///< `fewest_tunnel_steps` or more
  std::vector<TunnelStep> standard_errors{};  ///< of each number of each step; none where the file does not say
  std::optional<std::string> vehicle{};       ///< whose rows they are; empty: the file does not say
  std::optional<double> reference_area_m2{};  ///< that damping and torque were identified with; likewise
  std::optional<double> inertia_kg_m2{};      ///< likewise
  double swirl_rad = 0.0;                     ///< the mean of what was taken off
  std::string swirl_words;                    ///< a sentence: how much was taken off, and who said so
};

/// Reads the columns alpha_m2, beta_m, disturbance_begin_deg, disturbance_end_deg, and, where they are there,
/// swirl_deg, source, vehicle, reference_area_m2, inertia_kg_m2 and the standard errors of the four. The swirl that is
/// taken off is `swirl_rad` when given, else what the column swirl_deg says in that row. Throws text::Error:
/// no_such_input, bad_data; bad_configuration where the swirl is not given.
[[nodiscard]] TunnelResult read_tunnel_result(const std::filesystem::path& file,
                                              const std::optional<double>& swirl_rad);

}  // namespace fantail::predict
