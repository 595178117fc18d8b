// SPDX-License-Identifier: MIT

#include "degree.hpp"
#include "input/document.hpp"
#include "input/scenario_file.hpp"
#include "sim/units.hpp"
#include "sim/world.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

struct Reading {
  double time_s;  ///< after the start command
  WindReading reading;
};

std::vector<Reading> readings(const Scenario& scenario) {
  std::vector<Reading> all;
  World world{scenario};
  while (!world.over()) {
    world.tick();
    if (const auto reading = world.wind_reading()) {
      all.push_back({1e-6 * static_cast<double>(world.now().count()) - scenario.pad_time_s, *reading});
    }
    world.advance();
  }
  return all;
}

Scenario load(const std::string& name, const std::vector<std::string>& changes) {
  return input::load_scenario(name, input::parse_overrides(changes));
}

TEST(WindSensor, ShowsWholeStepsOrWithoutARoundingWhatIs) {
  EXPECT_DOUBLE_EQ(WindSensor{}.shown_m_s(22.04), 22.0);
  EXPECT_DOUBLE_EQ(WindSensor{}.shown_m_s(22.06), 22.1);
  EXPECT_DOUBLE_EQ((WindSensor{.resolution_m_s = 0.5}.shown_m_s(22.26)), 22.5);
  EXPECT_DOUBLE_EQ((WindSensor{.resolution_m_s = 0.0}.shown_m_s(22.26)), 22.26);
}

TEST(TunnelRun, TheFanFollowsItsProgrammeAndTheAirTheFan) {
  const std::vector<Reading> log =
      readings(load("tunnel_flow", {"tunnel.turbulence=0", "tunnel.wind_sensor_period_s=0.5", "run.control_time_s=8",
                                    "tunnel.wind_sensor_resolution_m_s=0", "tunnel.fan_lag_s=2", "tunnel.fan_rpm=100",
                                    "tunnel.fan_times_s=[0, 4.5]", "tunnel.fan_rpms=[1000, 500]",
                                    "timing.time_after_end_s=3", "tunnel.speed_per_rpm_m_s=0.02"}));
  ASSERT_EQ(log.size(), 42U);  // ten seconds, eight and three
  for (const auto& [time_s, reading] : log) {
    const double rose_to = 20.0 - 18.0 * std::exp(-4.5 / 2.0);
    const double expected = time_s <= 0.0   ? 2.0
                            : time_s <= 4.5 ? 20.0 - 18.0 * std::exp(-time_s / 2.0)
                                            : 10.0 + (rose_to - 10.0) * std::exp(-(time_s - 4.5) / 2.0);
    EXPECT_NEAR(reading.wind_speed_m_s, expected, 1e-6) << time_s;
    EXPECT_EQ(reading.fan_rpm, time_s <= 0.0 ? 100.0 : time_s <= 4.5 ? 1000.0 : 500.0) << time_s;
  }
}

TEST(TunnelRun, AFlightHasNoWindSensor) {
  const Scenario scenario = load("tasha3_launch2", {});
  World world{scenario};
  world.tick();
  EXPECT_FALSE(world.wind_reading().has_value());
}

// The paper's session: set points by their speed, and each is steady when it says so.
TEST(TunnelRun, TheFlowSessionIsSteadyAtTheSixPublishedTimes) {
  const Scenario scenario = load("tunnel_flow", {"tunnel.turbulence=0", "tunnel.wind_sensor_resolution_m_s=0"});
  const std::vector<std::pair<double, double>> published{{100, 570},  {230, 870},  {390, 1100},
                                                         {550, 1400}, {718, 1650}, {858, 1700}};
  const std::vector<Reading> log = readings(scenario);
  for (const auto& [time_s, rpm] : published) {
    std::size_t found = 0;
    for (const Reading& line : log) {
      if (line.time_s >= time_s && line.time_s < time_s + 40.0) {
        EXPECT_EQ(line.reading.fan_rpm, rpm) << line.time_s;
        EXPECT_NEAR(line.reading.wind_speed_m_s, 0.0176 * rpm, 0.05) << line.time_s;
        ++found;
      }
    }
    EXPECT_EQ(found, 20U) << time_s;
  }
}

// Steady rates of the two swirl sessions at 22 m/s in closed form (Eq 27): -6.1 and -4.1 degrees of offset.
TEST(TunnelRun, TheSwirlSessionsRollFreelyAtTheRateOfTheirOffset) {
  for (const auto& [name, offset_deg, rate_deg_s] :
       {std::tuple{"tunnel_swirl_without", -6.1, -66.41}, std::tuple{"tunnel_swirl_with", -4.1, -44.64}}) {
    const Scenario scenario = load(name, {"tunnel.fan_rpm=1250", "tunnel.fan_rpms=[]", "tunnel.fan_times_s=[]",
                                          "tunnel.turbulence=0", "servo.backlash_deg=0", "run.control_time_s=8"});
    World world{scenario};
    Truth last{};
    while (!world.over()) {
      const core::TickRecord& record = world.tick();
      EXPECT_EQ(static_cast<double>(record.command.radians()), 0.0);
      if (record.phase == core::Phase::controlling) {
        last = world.truth();
      }
      world.advance();
    }
    EXPECT_NEAR(last.disturbance_rad, offset_deg * degree, 1e-9) << name;
    EXPECT_NEAR(last.roll_rate_rad_s / degree, rate_deg_s, 0.01) << name;
  }
}

}  // namespace
}  // namespace fantail::sim
