// SPDX-License-Identifier: MIT
#include "fly/describe.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "airframe/model/build_up.hpp"
#include "sim/deflection_range.hpp"
#include "sim/roll_inertia_course.hpp"
#include "stability/canard_sense.hpp"
#include "stability/pitch_frequency.hpp"

namespace fantail::fly {
namespace {

// Less than this is little, by the usual rule of thumb.
constexpr double usual_margin_calibres = 1.0;

bool has_little_margin(const sim::Airframe& airframe) {
  const double least_m =
      std::min(static_margin_m(airframe, airframe.at_liftoff), static_margin_m(airframe, airframe.after_burnout));
  return least_m > 0.0 && least_m < usual_margin_calibres * airframe.diameter_m;
}

std::string static_margins(const sim::Airframe& airframe) {
  const double full_m = static_margin_m(airframe, airframe.at_liftoff);
  const double empty_m = static_margin_m(airframe, airframe.after_burnout);
  const auto rounded = [](double value) { return std::round(value) + 0.0; };  // without a minus in front of a zero
  return fmt::format("Static margin: {:.0f} mm ({:.1f} calibres) at lift-off, {:.0f} mm ({:.1f}) after burn-out.",
                     rounded(1e3 * full_m), 0.1 * rounded(10.0 * full_m / airframe.diameter_m), rounded(1e3 * empty_m),
                     0.1 * rounded(10.0 * empty_m / airframe.diameter_m));
}

/// The sentences of vehicle and scenario are anybody's words: nobody can tell which of them are about the path.
void limit_to_path(std::vector<std::string>& sentences) {
  if (const std::size_t count = sentences.size(); count > 0) {
    sentences.insert(sentences.begin(),
                     fmt::format("The next {} from vehicle and scenario. The path is that of the trajectory, whatever "
                                 "they say about thrust, drag, mass, stability, wind or parachute.",
                                 count == 1 ? "sentence is" : fmt::format("{} sentences are", count)));
  }
}

}  // namespace

// The roll torque that the vehicle states says how strong a canard is, its shape where it stands.
std::optional<CanardSide> canard_side(const sim::Vehicle& vehicle) {
  if (!vehicle.geometry || !vehicle.geometry->canards || !vehicle.airframe) {
    return {};
  }
  const airframe::model::BuildUp built = airframe::model::build_up(vehicle);
  const auto canards = std::ranges::find(built.parts, "canards", &airframe::model::Part::name);
  if (canards == built.parts.end() || !built.canard_arm_m) {
    return {};
  }
  const double roll_arm_m = vehicle.canard_air.arm_m.value_or(*built.canard_arm_m);
  return CanardSide{.area_m2 = vehicle.roll_plant.reference_area_m2 * vehicle.roll_plant.torque_m / (4.0 * roll_arm_m),
                    .position_m = canards->position_m};
}

std::optional<double> side_moment_m3(const sim::Vehicle& vehicle) {
  const auto side = canard_side(vehicle);
  if (!side) {
    return {};
  }
  return side->area_m2 * std::abs(vehicle.airframe->after_burnout.centre_of_gravity_m - side->position_m);
}

namespace {

/// Of a path that is not Fantail's the masses are unknown.
std::optional<std::array<double, 2>> resonance_1_m(const sim::Scenario& scenario) {
  if (!scenario.vehicle.airframe || scenario.path || scenario.surroundings != sim::Surroundings::flight) {
    return {};
  }
  const auto frequency = stability::pitch_frequency(*scenario.vehicle.airframe, scenario.atmosphere.density_kg_m3(0.0));
  if (!frequency) {
    return {};
  }
  return std::array{frequency->least_1_m, frequency->most_1_m};
}

}  // namespace

flight::Flight describe(const sim::Scenario& scenario) {
  flight::Flight flight;
  flight.scenario = scenario.name;
  flight.vehicle = scenario.vehicle.name;
  flight.airframe = {.vehicle = scenario.vehicle.name,
                     .vehicle_file = scenario.vehicle_name,
                     .roll_inertia_kg_m2 = scenario.vehicle.roll_plant.inertia_kg_m2,
                     .reference_area_m2 = scenario.vehicle.roll_plant.reference_area_m2};
  if (scenario.surroundings == sim::Surroundings::flight && scenario.motion == sim::FlightMotion::six_dof) {
    for (const auto& [time_s, inertia_kg_m2] : sim::roll_inertia_course(scenario.vehicle)) {
      flight.airframe->roll_inertia_course[scenario.pad_time_s + time_s] = inertia_kg_m2;
    }
  }
  flight.airframe->grows_with_mach = scenario.vehicle.compressibility != sim::Compressibility::none;
  flight.plan_name = scenario.plan_name;
  flight.version = FANTAIL_VERSION;
  flight.seed = scenario.seed;
  flight.tunnel = scenario.surroundings != sim::Surroundings::flight;
  flight.plan = scenario.plan;
  flight.rest_limit_rad = scenario.rest_limit_rad;
  flight.tilt_end_before_apogee_s = scenario.tilt_end_before_apogee_s;
  const sim::DeflectionRange reach = sim::deflection_range(scenario);
  flight.canard_reach = {.lowest_rad = reach.lowest_rad, .highest_rad = reach.highest_rad};
  flight.why_uncontrollable = stability::why_uncontrollable(scenario);
  flight.left_by_fins = stability::left_in_the_end(scenario);
  flight.resonance_1_m = resonance_1_m(scenario);
  if (const std::string against = stability::works_against(scenario); !against.empty()) {
    flight.notes.push_back("C" + against.substr(1) + ".");
  }
  for (const auto* sentences :
       {&scenario.vehicle.warnings, &scenario.warnings, &scenario.vehicle.assumed, &scenario.assumed}) {
    flight.notes.insert(flight.notes.end(), sentences->begin(), sentences->end());
  }
  if (scenario.path) {
    flight.path_frame = flight::PathFrame::plane;
    limit_to_path(flight.notes);
  }
  if (const std::string temperature = wrong_air_temperature(scenario); !temperature.empty()) {
    flight.notes.push_back(temperature + ".");
  }
  if (scenario.motion == sim::FlightMotion::six_dof && !scenario.path) {
    const auto& assumed = scenario.vehicle.airframe_assumed;
    flight.notes.insert(flight.notes.end(), assumed.begin(), assumed.end());
    flight.notes.push_back(static_margins(scenario.vehicle.airframe.value()));
    flight.wind = {.speed_m_s = scenario.wind.speed_m_s,
                   .from_rad = scenario.wind.from_rad,
                   .height_m = scenario.wind.reference_height_m};
  }
  if (scenario.motion == sim::FlightMotion::straight && !scenario.path && !flight.tunnel && scenario.vehicle.airframe &&
      has_little_margin(*scenario.vehicle.airframe)) {
    flight.notes.push_back(static_margins(*scenario.vehicle.airframe));
  }
  for (const sim::Fault& fault : scenario.faults) {
    flight.notes.push_back(fault_text(fault, scenario));
  }
  if (std::ranges::any_of(scenario.faults, [](const sim::Fault& fault) {
        return sim::broken_gear(fault) != nullptr && !sim::is_there_at_liftoff(fault);
      })) {
    flight.notes.emplace_back("Authority and stability margins leave out the canard faults that began after lift-off.");
  }
  if (scenario.log_period_s > 0.001) {
    flight.notes.push_back(fmt::format("flight.csv has a row every {:g} s instead of every millisecond{}.",
                                       scenario.log_period_s,
                                       flight.tunnel ? ", and the figures are computed from these rows" : ""));
  }
  return flight;
}

}  // namespace fantail::fly
