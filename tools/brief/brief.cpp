// SPDX-License-Identifier: MIT
#include "brief/brief.hpp"

#include <utility>

#include "brief/landing.hpp"
#include "hardover/study.hpp"

namespace fantail::brief {
namespace {

struct Size {
  std::optional<double> length_m{};
  std::optional<double> diameter_m{};
};

Size size_of(const sim::Vehicle& vehicle) {
  if (vehicle.geometry) {
    return {vehicle.geometry->length_m, vehicle.geometry->diameter_m};
  }
  return vehicle.airframe ? Size{vehicle.airframe->length_m, vehicle.airframe->diameter_m} : Size{};
}

}  // namespace

Brief make(Request request, const std::function<void(std::size_t done, std::size_t of)>& look) {
  sim::Scenario& scenario = request.scenario;
  hardover::require_free_flight(scenario);
  const sim::Vehicle& vehicle = scenario.vehicle;
  if (vehicle.airframe) {
    scenario.motion = sim::FlightMotion::six_dof;
  }
  const Size size = size_of(vehicle);
  const double impulse_n_s = vehicle.motor.impulse_n_s();
  Brief brief{.scenario = scenario.name,
              .vehicle = vehicle.name,
              .plan_name = scenario.plan_name,
              .seed = scenario.seed,
              .plan = scenario.plan,
              .length_m = size.length_m,
              .diameter_m = size.diameter_m,
              .mass_kg = vehicle.mass_kg,
              .impulse_n_s = impulse_n_s,
              .motor_class = motor_class(impulse_n_s),
              .guide_length_m = scenario.guide.length_m.value_or(static_cast<double>(scenario.plan.guide.length_m)),
              .guide_tilt_rad = scenario.guide.tilt_rad,
              .guide_azimuth_rad = scenario.guide.azimuth_rad,
              .faults = scenario.faults.size(),
              .is_six_dof = vehicle.airframe.has_value(),
              .wind_m_s = scenario.wind.speed_m_s,
              .wind_from_rad = scenario.wind.from_rad,
              .nominal = fly_nominal(scenario),
              .why_no_landing = why_no_landing(vehicle),
              .rules = std::move(request.rules)};
  if (vehicle.airframe && brief.nominal.control_start) {
    brief.wind_limit = wind_limit(scenario, [&] { look(0, 0); });
  }
  if (brief.why_no_landing.empty()) {
    brief.landing = landing(request, look);
  }
  return brief;
}

}  // namespace fantail::brief
