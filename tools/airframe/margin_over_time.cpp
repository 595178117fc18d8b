// SPDX-License-Identifier: MIT
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "airframe/summary.hpp"
#include "page/chart.hpp"
#include "sim/burning_rocket.hpp"

namespace fantail::airframe {
namespace {

using page::Role;

/// Where the mass of the rocket is before and after the burn: of the file, or of its parts.
struct Balance {
  sim::Airframe airframe;
  double mass_kg;
};

std::optional<Balance> balance_of(const sim::Vehicle& vehicle, const model::BuildUp& computed) {
  if (vehicle.airframe) {
    return Balance{*vehicle.airframe, vehicle.mass_kg};
  }
  if (!computed.at_liftoff || !computed.after_burnout) {
    return std::nullopt;
  }
  sim::Airframe of_parts;
  of_parts.at_liftoff.centre_of_gravity_m = computed.at_liftoff->centre_of_gravity_m;
  of_parts.after_burnout.centre_of_gravity_m = computed.after_burnout->centre_of_gravity_m;
  return Balance{of_parts, computed.at_liftoff->mass_kg};
}

constexpr const char* caption =
    "From ignition to burn-out. The centre of gravity moves with the propellant, which burns in proportion to the "
    "impulse. The centre of pressure "
    "is that of small angles; in this model it does not move with the Mach number. The verdict asks for one calibre, "
    "and for zero at the low end of the shape's range.";

}  // namespace

std::vector<result::Block> margin_over_time(const sim::Vehicle& vehicle, const Summary& summary) {
  const sim::ThrustCurve& motor = vehicle.motor;
  const auto balance = balance_of(vehicle, summary.build_up);
  if (!balance) {
    return {
        std::string{"Not shown over time: the centre of gravity is not known both at lift-off and after burn-out. It "
                    "follows from [masses] with the propellant's position, or from [airframe]."}};
  }
  const model::Estimate& shape = model::least_centre_of_pressure_m(summary.build_up);
  const double calibre_m = model::largest_diameter_m(*vehicle.geometry);
  page::Series by_shape{.name = "with the shape's centre of pressure", .role = Role::model};
  page::Area range{.name = "with the range of the shape", .role = Role::model};
  page::Series by_file{.name = "with the file's, as in flights", .role = Role::measured};
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double time_s = motor.burnout_s() * i / points;
    const double gravity_m =
        sim::burning_rocket(balance->airframe, {.mass_kg = balance->mass_kg, .propellant_kg = motor.propellant_kg()},
                            motor.impulse_until(time_s) / motor.impulse_n_s())
            .centre_of_gravity_m;
    const auto margin = [&](double pressure_m) { return (pressure_m - gravity_m) / calibre_m; };
    by_shape.x.push_back(time_s);
    by_shape.y.push_back(margin(shape.value));
    range.low.push_back(margin(shape.low));
    range.high.push_back(margin(shape.high));
    if (vehicle.airframe) {
      by_file.x.push_back(time_s);
      by_file.y.push_back(margin(vehicle.airframe->centre_of_pressure_m));
    }
  }
  range.x = by_shape.x;
  page::Chart chart{
      .label = "Static margin over time",
      .x_label = "time after ignition / s",
      .y_label = "static margin / calibres",
      .series = {std::move(by_shape)},
      .areas = {std::move(range)},
      .levels = {{.value = least_margin_calibres, .label = "1 calibre, the limit of the verdict", .role = Role::limit},
                 {.value = 0.0, .label = "unstable below zero", .role = Role::limit}}};
  if (vehicle.airframe) {
    chart.series.push_back(std::move(by_file));
  }
  return {result::Picture{std::move(chart), caption}};
}

}  // namespace fantail::airframe
