// SPDX-License-Identifier: MIT
// What the simulated tunnel is told comes back from the logs it makes.
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "fly/fly_scenario.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "sim/wind_tunnel.hpp"
#include "tunnel/flow.hpp"
#include "tunnel/made_logs.hpp"
#include "tunnel/steps.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::tunnel {
namespace {

flight::Flight flown(const std::string& scenario, const std::vector<std::string>& changes = {}) {
  return fly::fly_scenario(input::load_scenario(scenario, input::parse_overrides(changes)));
}

TunnelLog wind_log(const flight::Flight& flight) {
  TunnelLog log{.name = flight.scenario};
  for (const flight::TunnelReading& reading : flight.tunnel_readings) {
    log.time_s.push_back(reading.time_s);
    log.fan_rpm.push_back(reading.fan_rpm);
    log.wind_speed_m_s.push_back(reading.wind_speed_m_s);
  }
  return log;
}

logs::RollLog roll_log(const flight::Flight& flight) {
  logs::RollLog log;
  log.name = flight.scenario;
  for (const flight::Row& row : flight.rows) {
    log.time_s.push_back(row.time_s);
    log.roll_angle_rad.push_back(row.roll_angle_rad);
    log.roll_rate_rad_s.push_back(row.roll_rate_rad_s);
    log.canard_rad.push_back(row.canard_rad.value_or(std::nan("")));
    log.reference_rad.push_back(row.reference_rad);
    log.phase.push_back(row.phase);
  }
  return log;
}

// The six published set points and the times from which they were steady.
TEST(SimulatedTunnel, FlowFindsTheSixSetPointsTheirLineAndTheTurbulence) {
  constexpr std::array<std::pair<double, double>, 6> published{
      {{570.0, 100.0}, {870.0, 230.0}, {1100.0, 390.0}, {1400.0, 550.0}, {1650.0, 718.0}, {1700.0, 858.0}}};
  const TunnelLog log = wind_log(flown("tunnel_flow"));
  const SteadySegments segments = find_steady(log, {});
  const Flow flow = examine_flow(log, segments);
  ASSERT_EQ(flow.points.size(), published.size());
  EXPECT_TRUE(segments.left_out.empty());
  for (std::size_t i = 0; i < published.size(); ++i) {
    const auto [rpm, steady_s] = published[i];
    const FlowPoint& point = flow.points[i];
    EXPECT_EQ(point.segment.fan_rpm, rpm);
    EXPECT_NEAR(point.segment.begin_s, steady_s, 40.0);
    EXPECT_GE(point.segment.end_s, steady_s + 50.0);
    // Turbulence of 0.3 % and the sensor's steps of 0.1 m/s; 35 readings and more.
    const double deviation_m_s = std::hypot(0.003 * 0.0176 * rpm, 0.1 / std::sqrt(12.0));
    EXPECT_NEAR(point.mean_m_s, 0.0176 * rpm, 4.0 * deviation_m_s / std::sqrt(35.0)) << rpm;
    EXPECT_NEAR(point.deviation_m_s, deviation_m_s, 0.4 * deviation_m_s) << rpm;
  }
  EXPECT_NEAR(flow.line->slope, 0.0176, 0.0001);
  EXPECT_NEAR(flow.line->offset, 0.0, 0.1);
  EXPECT_GT(flow.line->r_squared, 0.9999);
  EXPECT_EQ(flow.rounding_m_s, 0.1);
}

// The tunnel alone, which steps from reading to reading as exactly as from tick to tick.
TEST(SimulatedTunnel, FlowFindsThemWhateverTheTurbulenceDoes) {
  const sim::Scenario scenario = input::load_scenario("tunnel_flow", {});
  int complete = 0;
  constexpr int seeds = 300;
  for (int seed = 0; seed < seeds; ++seed) {
    Gaussian gaussian{static_cast<std::uint64_t>(seed)};
    sim::WindTunnel air{scenario.tunnel, gaussian()};
    TunnelLog log{.name = "seed " + std::to_string(seed)};
    std::size_t next = 0;
    double fan_rpm = scenario.tunnel.fan_rpm;
    for (double t = 0.0; t < 940.0; t += scenario.wind_sensor.period_s) {
      log.time_s.push_back(t);
      log.fan_rpm.push_back(fan_rpm);
      log.wind_speed_m_s.push_back(scenario.wind_sensor.shown_m_s(air.speed_m_s()));
      if (next < scenario.fan_programme.size() && scenario.fan_programme[next].time_s <= t) {
        fan_rpm = scenario.fan_programme[next++].fan_rpm;
        air.set_fan_rpm(fan_rpm);
      }
      air.step(scenario.wind_sensor.period_s, gaussian());
    }
    complete += find_steady(log, {}).found.size() == 6 ? 1 : 0;
  }
  EXPECT_GE(complete, seeds * 99 / 100) << "seeds 0 to " << seeds - 1;
}

TEST(SimulatedTunnel, SwirlOfTwoDegreesComesBackFromTheTwoSessions) {
  const auto session = [](const std::string& scenario) {
    const flight::Flight flight = flown(scenario);
    RollSession made{.roll = roll_log(flight), .wind = wind_log(flight), .steady = {}};
    made.steady = find_steady(made.wind, {});
    return made;
  };
  const Swirl swirl =
      examine_swirl(session("tunnel_swirl_without"), session("tunnel_swirl_with"), {.roll = published_roll()});
  ASSERT_EQ(swirl.without.size(), 6U);
  ASSERT_EQ(swirl.with.size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(swirl.without[i].offset_rad / degree, -6.1, 0.03);
    EXPECT_NEAR(swirl.with[i].offset_rad / degree, -4.1, 0.03);
  }
  ASSERT_TRUE(swirl.swirl.has_value());
  EXPECT_EQ(swirl.swirl->speeds, 4U);
  EXPECT_NEAR(swirl.swirl->offset_rad / degree, -2.0, 0.02);
  EXPECT_LT(swirl.swirl->standard_error_rad / degree, 0.02);
}

TEST(SimulatedTunnel, StepsGiveBackThePlantedRollModel) {
  const flight::Flight flight = flown("tunnel_steps");
  const logs::RollLog log = roll_log(flight);
  StepOptions options;
  options.record.density_kg_m3 = 1.2;
  options.record.speed_m_s = mean_wind_speed_m_s(wind_log(flight), find_reference_steps(log));
  EXPECT_NEAR(*options.record.speed_m_s, 22.0, 0.05);
  const StepTable table = identify_steps(log, {.inertia_kg_m2 = 0.00393, .reference_area_m2 = 5.0265e-5}, options);
  ASSERT_EQ(table.steps.size(), 16U);  // eight up, eight down
  for (const StepResult& step : table.steps) {
    EXPECT_NEAR(step.identified.model.alpha_m2, 19.4, 0.5) << step.number;
    EXPECT_NEAR(step.identified.model.beta_m, 9.6, 0.25) << step.number;
    EXPECT_NEAR(step.identified.model.node_rad.front() / degree, -6.1, 0.1) << step.number;
    EXPECT_NEAR(step.identified.model.node_rad.back() / degree, -6.1, 0.1) << step.number;
  }
  EXPECT_NEAR(table.mean.alpha_m2, 19.4, 0.15);
  EXPECT_NEAR(table.mean.beta_m, 9.6, 0.08);
  EXPECT_LT(table.mean.mean_abs_angle_error_rad / degree, 0.05);
}

}  // namespace
}  // namespace fantail::tunnel
