// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "result/answer.hpp"
#include "result/document.hpp"
#include "text/layout.hpp"
#include "tunnel/statistics.hpp"
#include "tunnel/steady.hpp"
#include "tunnel/tunnel_log.hpp"

namespace fantail::tunnel {

/// The air at one set point of the fan.
struct FlowPoint {
  SteadySegment segment{};
  double mean_m_s = 0.0;
  double deviation_m_s = 0.0;       ///< standard deviation of a sample of readings
  double gamma_m_s = 0.0;           ///< deviation^2 / mean, the turbulence intensity as published (Eq 26)
  double relative_deviation = 0.0;  ///< deviation / mean, the usual turbulence intensity
  double rounding_share = 0.0;      ///< deviation / mean that the sensor's rounding makes alone
};

struct Flow {
  std::vector<FlowPoint> points{};
  std::optional<Line> line{};          ///< mean speed over set point; from two different set points on
  double rounding_m_s = 0.0;           ///< what the sensor rounds to; 0: nothing found
  std::vector<std::string> remarks{};  ///< a sentence each
};

/// Throws text::Error (bad_data) when no set point became steady, or when air stood still in one.
[[nodiscard]] Flow examine_flow(const TunnelLog& log, const SteadySegments& segments);

/// What `fantail tunnel flow` says: nothing was asked, so that there is no yes or no.
[[nodiscard]] result::Document flow_answer(const TunnelLog& log, const Flow& flow, const result::Made& made);
/// Every figure in its JSON, for the manual.
[[nodiscard]] std::vector<result::Listed> listed_flow_fields();

}  // namespace fantail::tunnel
