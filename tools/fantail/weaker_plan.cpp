// SPDX-License-Identifier: MIT
#include "fantail/weaker_plan.hpp"

#include <string_view>

#include <fmt/core.h>

#include "text/number.hpp"

namespace fantail::tool {

std::vector<std::string> weaker_than_shipped(const core::FlightPlan& plan) {
  std::vector<std::string> weaker;
  if (plan.run.start != core::Start::launch) {
    return weaker;
  }
  const core::LaunchDetectionPlan& rule = plan.launch_detection;
  const core::GuidePlan& guide = plan.guide;
  const auto add = [&](bool is, std::string_view what) {
    if (is) {
      weaker.emplace_back(what);
    }
  };
  const auto value = [](float number, double unit, int digits) {
    return text::brief(static_cast<double>(number) / unit, digits);
  };
  constexpr double g_m_s2 = 9.80665;
  const bool two = rule.accelerometers == core::AccelerometerRule::two_agree;
  add(!two, "launch_detection.accelerometers = \"one\"; two must agree there");
  add(two && rule.single_allowed, "launch_detection.single_allowed = true; one alone does not count there");
  add(!rule.low_pass, "launch_detection.low_pass = false; 8 Hz there");
  add(rule.low_pass && rule.low_pass_hz > 8.0F,
      fmt::format("launch_detection.low_pass_hz = {}; 8 there", value(rule.low_pass_hz, 1.0, 1)));
  add(rule.threshold_m_s2 < static_cast<float>(1.999 * g_m_s2),
      fmt::format("launch_detection.threshold_g = {}; 2 or more there", value(rule.threshold_m_s2, g_m_s2, 2)));
  add(rule.hold < std::chrono::milliseconds{100}, "launch_detection.hold_s is less than 0.1");
  add(guide.length_m <= 0.0F, "guide.length_m = 0: control does not wait for the end of a guide");
  add(guide.minimum_speed_m_s < 17.0F,
      fmt::format("guide.minimum_speed_m_s = {}; 17 there", value(guide.minimum_speed_m_s, 1.0, 1)));
  return weaker;
}

}  // namespace fantail::tool
