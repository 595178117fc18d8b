// SPDX-License-Identifier: MIT
#include "paper/runs.hpp"

#include <cmath>

#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
#include "tunnel/steady.hpp"

namespace fantail::paper {

Run fly(const std::string& scenario, std::span<const input::Override> changes, const Tell& tell) {
  Run run{.scenario = input::load_scenario(scenario, changes), .flight = {}};
  tell("flying " + run.scenario.name);
  run.flight = fly::fly_scenario(run.scenario, [&](double) { tell("flying " + run.scenario.name); });
  return run;
}

identify::model::Airframe airframe(const sim::Scenario& scenario) {
  const sim::RollPlant& plant = scenario.vehicle.roll_plant;
  return {.inertia_kg_m2 = plant.inertia_kg_m2, .reference_area_m2 = plant.reference_area_m2};
}

identify::model::Record true_record(const Run& run, double from_s, double to_s, double every_s, Canards canards) {
  identify::model::Record record;
  record.window = run.scenario.name;
  record.window_begin_s = from_s;
  double next_s = from_s;
  const auto density = [&run](double height_m) {
    return run.flight.tunnel ? run.scenario.tunnel.density_kg_m3 : run.scenario.atmosphere.density_kg_m3(height_m);
  };
  for (const flight::Row& row : run.flight.rows) {
    if (!row.truth || row.time_s < next_s - 1e-9 || row.time_s > to_s + 1e-9) {
      continue;
    }
    next_s = row.time_s + every_s;
    record.time_s.push_back(row.time_s - from_s);
    record.roll_angle_rad.push_back(row.truth->roll_angle_rad);
    record.roll_rate_rad_s.push_back(row.truth->roll_rate_rad_s);
    record.canard_rad.push_back(canards == Canards::as_encoders_read ? row.canard_rad.value_or(0.0)
                                                                     : row.truth->canard_rad);
    record.speed_m_s.push_back(row.truth->speed_m_s);
    record.density_kg_m3.push_back(density(row.truth->height_m));
    record.reference_rad.push_back(row.reference_rad);
    record.excitation_rad.push_back(row.excitation_rad);
    record.in_control.push_back(row.phase == core::Phase::controlling);
  }
  return record;
}

tunnel::TunnelLog wind_log(const Run& run) {
  tunnel::TunnelLog log{.name = run.scenario.name};
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
