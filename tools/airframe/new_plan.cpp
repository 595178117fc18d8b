// SPDX-License-Identifier: MIT
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "airframe/new_rocket.hpp"

namespace fantail::airframe {
namespace {

constexpr std::string_view plan_text = R"(
[run]
canard_fault = "end_control" # a failed canard ends control; with "share" the others go on (fantail rules has what ranges ask)
tilt_limit_deg = 30 # from the direction of the guide
tilt_from = "guide"

[launch_detection]
threshold_g = 2.5
hold_s = 0.1
low_pass_hz = 8 # this and the next as in the shipped plan tasha3_launch2, which says why
disagreement_g = 2

[guide] # where control may begin
length_m = 4
clearance_m = 2
minimum_speed_m_s = 17

[controller] # fantail fly says their margins; fantail predict, once there are tunnel results, better ones
proportional_gain = {proportional_gain}
derivative_gain_s = {derivative_gain_s}
canard_limit_deg = 9

[reference]
kind = "hold"
initial_deg = 0
)";

constexpr std::string_view schedule_text = R"(
[gain_schedule] # factors on both gains: in faster air the canards are stronger
speeds_m_s = [{speeds}]
factors = [{factors}]
)";

constexpr std::string_view observer_text = R"(
[offset]
rejection = "observer" # without, the fin offset would keep the roll too far from its reference
observer_bandwidth_rad_s = {bandwidth}

[roll_model] # of the observer: that of vehicle.toml after burn-out
roll_inertia_kg_m2 = {inertia}
reference_area_m2 = {area}
damping_m2 = {damping}
torque_m = {torque}
density_kg_m3 = {density}
)";

}  // namespace

std::string rounded(double value) { return fmt::format("{:.6g}", value); }

std::string plan_file(const std::optional<FirstGains>& first, const core::FlightPlan& usual) {
  const stability::Gains gains = first ? first->gains : gains_of(usual);
  std::string plan = fmt::format(fmt::runtime(plan_text), fmt::arg("proportional_gain", rounded(gains.proportional)),
                                 fmt::arg("derivative_gain_s", rounded(gains.derivative_s)));
  if (first && first->schedule.speeds_count > 0) {
    const auto listed = [&](const auto& values) {
      std::string list;
      for (std::size_t i = 0; i < first->schedule.speeds_count; ++i) {
        list += (i == 0 ? "" : ", ") + rounded(static_cast<double>(values[i]));
      }
      return list;
    };
    plan += fmt::format(fmt::runtime(schedule_text), fmt::arg("speeds", listed(first->schedule.speeds_m_s)),
                        fmt::arg("factors", listed(first->schedule.factors)));
  }
  if (!first || !first->observer_bandwidth_rad_s) {
    return plan;
  }
  using Model = core::RollModelPlan;
  const auto of_model = [&](float Model::* member) { return rounded(static_cast<double>(first->roll_model.*member)); };
  plan += fmt::format(fmt::runtime(observer_text), fmt::arg("bandwidth", rounded(*first->observer_bandwidth_rad_s)),
                      fmt::arg("inertia", of_model(&Model::roll_inertia_kg_m2)),
                      fmt::arg("area", of_model(&Model::reference_area_m2)),
                      fmt::arg("damping", of_model(&Model::damping_m2)), fmt::arg("torque", of_model(&Model::torque_m)),
                      fmt::arg("density", of_model(&Model::density_kg_m3)));
  return plan;
}

}  // namespace fantail::airframe
