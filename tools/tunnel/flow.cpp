// SPDX-License-Identifier: MIT
#include "tunnel/flow.hpp"

#include <algorithm>
#include <span>

#include <fmt/core.h>

#include "text/error.hpp"

namespace fantail::tunnel {
namespace {

FlowPoint examine(const TunnelLog& log, const SteadySegment& segment, double rounding_m_s) {
  const Moments m = moments(std::span{log.wind_speed_m_s}.subspan(segment.first, segment.count));
  if (m.mean <= 0.0) {
    text::refuse(fmt::format("{}: mean wind speed {:g} m/s from {:g} to {:g} s; turbulence intensity needs moving air",
                             log.name, m.mean, segment.begin_s, segment.end_s));
  }
  return {.segment = segment,
          .mean_m_s = m.mean,
          .deviation_m_s = m.standard_deviation,
          .gamma_m_s = m.standard_deviation * m.standard_deviation / m.mean,
          .relative_deviation = m.standard_deviation / m.mean,
          .rounding_share = rounding_deviation(rounding_m_s) / m.mean};
}

std::optional<Line> line_through(const std::vector<FlowPoint>& points) {
  std::vector<double> rpm;
  std::vector<double> speed_m_s;
  for (const FlowPoint& point : points) {
    rpm.push_back(point.segment.fan_rpm.value_or(0.0));
    speed_m_s.push_back(point.mean_m_s);
  }
  const auto [lowest, highest] = std::ranges::minmax(rpm);
  return highest > lowest ? std::optional{fit_line(rpm, speed_m_s)} : std::nullopt;
}

}  // namespace

Flow examine_flow(const TunnelLog& log, const SteadySegments& segments) {
  Flow flow{.rounding_m_s = rounding_of(log.wind_speed_m_s), .remarks = segments.left_out};
  if (segments.found.empty()) {
    std::string message = log.name + ": the wind was not steady at any set point of the fan";
    for (const std::string& sentence : segments.left_out) {
      message += "; " + sentence;
    }
    text::refuse(message);
  }
  for (const SteadySegment& segment : segments.found) {
    flow.points.push_back(examine(log, segment, flow.rounding_m_s));
  }
  flow.line = line_through(flow.points);
  flow.remarks.insert(flow.remarks.end(), log.remarks.begin(), log.remarks.end());
  if (flow.line && flow.points.size() == 2) {
    flow.remarks.emplace_back("Two points always lie on a line, so R2 means nothing here.");
  }
  if (flow.rounding_m_s > 0.0) {
    flow.remarks.push_back(
        fmt::format("The sensor has a resolution of {:g} m/s. Rounding alone gives a standard deviation of about "
                    "{:.3f} m/s, which is part of every turbulence figure here.",
                    flow.rounding_m_s, rounding_deviation(flow.rounding_m_s)));
  }
  return flow;
}

}  // namespace fantail::tunnel
