// SPDX-License-Identifier: MIT
#include "paper/tunnel_sessions.hpp"

#include "tunnel/steady.hpp"

namespace fantail::paper {

tunnel::TunnelLog wind_log(const Run& run) {
  tunnel::TunnelLog log{
      .name = run.scenario.name, .time_s = {}, .fan_rpm = {}, .wind_speed_m_s = {}, .rows_left_out = 0};
  for (const flight::TunnelReading& reading : run.flight.tunnel_readings) {
    log.time_s.push_back(reading.time_s);
    log.fan_rpm.push_back(reading.fan_rpm);
    log.wind_speed_m_s.push_back(reading.wind_speed_m_s);
  }
  return log;
}

tunnel::RollSession roll_session(const Run& run) {
  tunnel::RollSession session;
  session.roll.name = run.scenario.name;
  for (const flight::Row& row : run.flight.rows) {
    if (row.time_s >= 0.0) {
      session.roll.time_s.push_back(row.time_s);
      session.roll.roll_angle_rad.push_back(row.roll_angle_rad);
      session.roll.roll_rate_rad_s.push_back(row.roll_rate_rad_s);
      session.roll.canard_rad.push_back(row.canard_rad.value_or(0.0));
    }
  }
  session.wind = wind_log(run);
  session.steady = tunnel::find_steady(session.wind, {});
  return session;
}

}  // namespace fantail::paper
