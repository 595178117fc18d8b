// SPDX-License-Identifier: MIT
#include "fantail/plan_outlook.hpp"

#include <algorithm>
#include <iterator>

#include "dormancy/sentences.hpp"
#include "text/degrees.hpp"

namespace fantail::tool {
namespace {

json::Value number(std::optional<double> value) { return value ? json::Value{json::rounded(*value)} : json::Value{}; }

json::Value moment(const std::optional<dormancy::Moment>& at) {
  return at ? json::Value{{"time_s", json::rounded(at->time_s)},
                          {"height_m", json::rounded(at->height_m)},
                          {"speed_m_s", json::rounded(at->speed_m_s)}}
            : json::Value{};
}

json::Value opening(const dormancy::Outlook& outlook) {
  if (!outlook.opening) {
    return {};
  }
  const dormancy::Opening& at = *outlook.opening;
  return {{"time_s", json::rounded(at.time_s)},
          {"height_m", json::rounded(at.height_m)},
          {"speed_m_s", json::rounded(at.speed_m_s)},
          {"roll_rate_deg_s", json::rounded(text::degrees(at.rate_rad_s))},
          {"roll_angle_deg", json::rounded(text::degrees(at.angle_rad))},
          {"reopenings", at.reopenings},
          {"captured_after_s", number(at.captured_after_s)}};
}

json::Value capture(const std::optional<dormancy::CaptureForecast>& forecast) {
  if (!forecast) {
    return {};
  }
  return {{"residual_rate_deg_s", number(text::in_degrees(forecast->residual_rate_rad_s))},
          {"earliest_stop_s", number(forecast->earliest_stop_s)},
          {"path_m", number(forecast->path_m)},
          {"longest_path_m", number(forecast->longest_path_m)},
          {"path_left_m", json::rounded(forecast->path_left_m)},
          {"within_s", number(forecast->within_s)},
          {"from_any_angle_within_s", number(forecast->from_any_angle_within_s)}};
}

json::Value json_of(const dormancy::Outlook& outlook, const std::optional<dormancy::CaptureForecast>& forecast) {
  json::Value all{
      {"guide_clear", moment(outlook.guide_clear)},       {"largest_dynamic_pressure", moment(outlook.most_pressure)},
      {"thrust_is_drag", moment(outlook.thrust_is_drag)}, {"last_thrust", moment(outlook.last_thrust)},
      {"thrust_end", moment(outlook.thrust_end)},         {"apogee", moment(outlook.apogee)}};
  all["opening"] = opening(outlook);
  all["opens_after_last_thrust_s"] = number(outlook.opens_after_thrust_s());
  all["burn_time_s"] = number(outlook.burn_s);
  all["height_margin_costs_s"] = number(outlook.height_costs_s());
  all["capture"] = capture(forecast);
  return all;
}

}  // namespace

GateCheck check_gate(const core::FlightPlan& plan, const std::optional<sim::Scenario>& scenario) {
  GateCheck found{.warnings = dormancy::doubts(plan)};
  if (!scenario || plan.run.start != core::Start::launch) {
    return found;
  }
  const dormancy::Outlook outlook = dormancy::outlook(*scenario);
  const auto forecast = dormancy::capture_forecast(*scenario, outlook);
  found.sentence = dormancy::opening_clause(*scenario, outlook, forecast);
  std::ranges::move(dormancy::doubts(*scenario, outlook, forecast), std::back_inserter(found.warnings));
  found.json = json_of(outlook, forecast);
  return found;
}

}  // namespace fantail::tool
