// SPDX-License-Identifier: MIT
#include "tunnel/flow_report.hpp"

#include <iterator>

#include <fmt/format.h>

#include "tunnel/json.hpp"

namespace fantail::tunnel {
namespace {

Json line(const Line& line) {
  return {{"slope_m_s_per_rpm", rounded(line.slope)},
          {"offset_m_s", rounded(line.offset)},
          {"r_squared", rounded(line.r_squared)}};
}

}  // namespace

std::string flow_text(const TunnelLog& log, const Flow& flow) {
  fmt::memory_buffer out;
  const auto print = [&out](const std::string& text) { out.append(text.data(), text.data() + text.size()); };
  print(fmt::format("{}: {} steady set points\n\n", log.name, flow.points.size()));
  print("    fan       steady       mean     deviation   Gamma      sigma/mean   of rounding   readings\n");
  for (const FlowPoint& p : flow.points) {
    print(fmt::format("{:5.0f} rpm {:>5g}-{:<5g} s {:7.3f} m/s {:6.3f} m/s {:8.5f} m/s {:7.3f} % {:10.3f} % {:9}\n",
                      p.segment.fan_rpm.value_or(0.0), p.segment.begin_s, p.segment.end_s, p.mean_m_s, p.deviation_m_s,
                      p.gamma_m_s, 100.0 * p.relative_deviation, 100.0 * p.rounding_share, p.segment.count));
  }
  if (flow.line) {
    print(fmt::format("\nspeed = {:.6f} m/s per rpm x fan {} {:.3f} m/s, R2 = {:.6f}\n", flow.line->slope,
                      flow.line->offset < 0.0 ? "-" : "+", std::abs(flow.line->offset), flow.line->r_squared));
  }
  print(flow.remarks.empty() ? "" : "\n");
  for (const std::string& remark : flow.remarks) {
    print("  " + remark + "\n");
  }
  return fmt::to_string(out);
}

std::string flow_json(const TunnelLog& log, const Flow& flow) {
  Json points = Json::array();
  for (const FlowPoint& p : flow.points) {
    points.push_back({{"fan_rpm", rounded(p.segment.fan_rpm)},
                      {"begin_s", rounded(p.segment.begin_s)},
                      {"end_s", rounded(p.segment.end_s)},
                      {"readings", p.segment.count},
                      {"mean_m_s", rounded(p.mean_m_s)},
                      {"deviation_m_s", rounded(p.deviation_m_s)},
                      {"gamma_m_s", rounded(p.gamma_m_s)},
                      {"relative_deviation", rounded(p.relative_deviation)},
                      {"relative_deviation_of_rounding", rounded(p.rounding_share)}});
  }
  const Json all = {{"log", log.name},
                    {"set_points", points},
                    {"line", flow.line ? line(*flow.line) : Json{}},
                    {"rounding_m_s", rounded(flow.rounding_m_s)},
                    {"rounding_deviation_m_s", rounded(rounding_deviation(flow.rounding_m_s))},
                    {"remarks", flow.remarks}};
  return all.pretty();
}

}  // namespace fantail::tunnel
