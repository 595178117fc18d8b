// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "airframe/model/build_up.hpp"
#include "flight/model_end.hpp"
#include "rules/figures.hpp"
#include "text/apart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::rules {
namespace {

/// Where the air pushes and where the mass is: of [airframe], or of the shape and its parts.
struct Centres {
  double pressure_m;
  double full_m;
  double empty_m;
  double diameter_m;
  double length_m;
};

std::optional<Centres> centres_of(const sim::Vehicle& vehicle) {
  if (const auto& frame = vehicle.airframe) {
    return Centres{frame->centre_of_pressure_m, frame->at_liftoff.centre_of_gravity_m,
                   frame->after_burnout.centre_of_gravity_m, frame->diameter_m, frame->length_m};
  }
  if (!vehicle.geometry) {
    return std::nullopt;
  }
  const airframe::model::BuildUp built = airframe::model::build_up(vehicle);
  if (!built.at_liftoff || !built.after_burnout) {
    return std::nullopt;
  }
  return Centres{built.centre_of_pressure_m.value, built.at_liftoff->centre_of_gravity_m,
                 built.after_burnout->centre_of_gravity_m, vehicle.geometry->diameter_m, vehicle.geometry->length_m};
}

/// The pitch equation I a'' + c v a' + k v^2 a = 0, with k = 1/2 rho A C m and c = 1/2 rho A C (s^2 + m^2) for parts at
/// a root mean square distance s from the centre of pressure, which is m behind the centre of gravity: c / (2 sqrt(k
/// I)) at every speed.
double damping_ratio(const sim::Airframe& frame, const sim::Airframe::MassProperties& mass, double density_kg_m3) {
  const double margin_m = sim::static_margin_m(frame, mass);
  const double force = 0.5 * density_kg_m3 * frame.cross_section_m2() * frame.normal_force_slope_per_rad;
  return force * (frame.parts_spread_m * frame.parts_spread_m + margin_m * margin_m) /
         (2.0 * std::sqrt(force * margin_m * mass.transverse_inertia_kg_m2));
}

/// As it flew.
struct Flown {
  const sim::Vehicle& vehicle;
  std::optional<double> side_moment_m3;
  double density_kg_m3;  ///< at the launch site
  Number top_mach;
};

class OfRocket {
 public:
  explicit OfRocket(const Flown& flown) : flown_{flown}, why_beyond_{why_beyond(flown.top_mach)} {}

  Findings take() && {
    add("mass_kg", exactly(flown_.vehicle.mass_kg));
    add("total_impulse_n_s", exactly(flown_.vehicle.motor.impulse_n_s()));
    if (const auto centres = centres_of(flown_.vehicle)) {
      add_margins(*centres);
    } else {
      for (const char* name : {"margin_calibres", "margin_at_stop_calibres", "attack_at_stop_deg",
                               "margin_at_launch_percent", "least_margin_percent", "largest_margin_percent"}) {
        add(name, {}, "the vehicle has no [airframe], and no [shape] with [masses] and the propellant's place");
      }
    }
    add_damping();
    return std::move(all_);
  }

 private:
  /// Empty: the centre of pressure stayed where the vehicle states it.
  static std::string why_beyond(const Number& mach) {
    const std::string moves =
        fmt::format("above Mach {} the centre of pressure moves", text::brief(flight::model_ends_at_mach, 2));
    return mach.low > flight::model_ends_at_mach
               ? fmt::format("the flight reaches Mach {}, and {}", text::apart(mach.low, flight::model_ends_at_mach, 2),
                             moves)
           : mach.high > flight::model_ends_at_mach ? "the record does not show the largest Mach number, and " + moves
                                                    : "";
  }

  void add(std::string_view name, std::optional<Known> known, std::string how = {}) {
    all_["rocket." + std::string{name}] = {std::move(known), std::move(how)};
  }

  void add_margins(const Centres& at) {
    const auto [least_m, most_m] = std::minmax({at.pressure_m - at.full_m, at.pressure_m - at.empty_m});
    const double percent = 100.0 / at.length_m;
    add("margin_at_launch_percent", exactly((at.pressure_m - at.full_m) * percent));
    if (!why_beyond_.empty()) {
      for (const char* name : {"margin_calibres", "margin_at_stop_calibres", "attack_at_stop_deg",
                               "least_margin_percent", "largest_margin_percent"}) {
        add(name, {}, why_beyond_);
      }
      return;
    }
    add("margin_calibres", exactly(least_m / at.diameter_m));
    add("least_margin_percent", exactly(least_m * percent));
    add("largest_margin_percent", exactly(most_m * percent));
    add_at_stop(at, least_m);
  }

  /// In this model a canard that is turned adds a side force and leaves the centre of pressure where it is; one that
  /// stalls takes lift away in front of it, so that it moves aft. The margin is therefore that at trim, as long as the
  /// rocket comes to rest where the model holds.
  void add_at_stop(const Centres& at, double least_m) {
    const double margin_m = at.pressure_m - at.empty_m;
    const auto& shape = flown_.vehicle.geometry;
    const bool is_known = flown_.vehicle.airframe && flown_.side_moment_m3 && shape && shape->canards &&
                          shape->canards->position_m < at.pressure_m;
    if (least_m <= 0.0) {
      add("margin_at_stop_calibres", exactly(least_m / at.diameter_m), "unstable with its canards at trim, too");
      add("attack_at_stop_deg", {}, "the rocket is unstable");
      return;
    }
    if (!is_known) {
      const char* why = "the vehicle has no [airframe], or no [canard_fins] in front of its centre of pressure";
      add("margin_at_stop_calibres", {}, why);
      add("attack_at_stop_deg", {}, why);
      return;
    }
    const sim::Airframe& frame = *flown_.vehicle.airframe;
    const double attack_rad = *flown_.side_moment_m3 * flown_.vehicle.servo.stop_rad /
                              (frame.cross_section_m2() * frame.normal_force_slope_per_rad * margin_m);
    add("attack_at_stop_deg", exactly(text::degrees(attack_rad)));
    if (attack_rad > flight::model_ends_at_attack_rad) {
      add("margin_at_stop_calibres", {},
          fmt::format("the rocket rests at {} deg of attack, where fins stall",
                      text::fixed(text::degrees(attack_rad), 0)));
    } else {
      add("margin_at_stop_calibres", exactly(least_m / at.diameter_m),
          fmt::format("the rocket rests at {} deg of attack with one canard at {} deg",
                      text::fixed(text::degrees(attack_rad), 1),
                      text::brief(text::degrees(flown_.vehicle.servo.stop_rad), 1)));
    }
  }

  void add_damping() {
    const auto& frame = flown_.vehicle.airframe;
    if (!frame || sim::static_margin_m(*frame, frame->at_liftoff) <= 0.0 ||
        sim::static_margin_m(*frame, frame->after_burnout) <= 0.0) {
      add("damping_ratio", {}, frame ? "the rocket is unstable" : "the vehicle has no [airframe]");
      return;
    }
    if (!why_beyond_.empty()) {
      add("damping_ratio", {}, why_beyond_);
      return;
    }
    const auto [least, most] = std::minmax({damping_ratio(*frame, frame->at_liftoff, flown_.density_kg_m3),
                                            damping_ratio(*frame, frame->after_burnout, flown_.density_kg_m3)});
    add("damping_ratio", Number{least, most}, "in the air at the launch site, without the exhaust");
  }

  Flown flown_;
  std::string why_beyond_;
  Findings all_;
};

}  // namespace

Findings of_rocket(const sim::Scenario& scenario, const flight::Flight& flight) {
  Findings all = OfRocket{{.vehicle = scenario.vehicle,
                           .side_moment_m3 = flight.side_moment_m3,
                           .density_kg_m3 = scenario.atmosphere.density_kg_m3(0.0),
                           .top_mach = exactly(flight.extremes.top_mach.value_or(0.0))}}
                     .take();
  all["flight.tilt_at_rest_deg"] = {exactly(text::degrees(scenario.guide.tilt_rad)), "of the scenario's guide"};
  return all;
}

Findings of_rocket(const sim::Vehicle& vehicle, std::optional<double> side_moment_m3, const Findings& found) {
  const auto mach = found.find("flight.largest_mach");
  const bool is_known = mach != found.end() && mach->second.known;
  return OfRocket{{.vehicle = vehicle,
                   .side_moment_m3 = side_moment_m3,
                   .density_kg_m3 = sim::Atmosphere{}.density_kg_m3(0.0),
                   .top_mach = is_known ? std::get<Number>(*mach->second.known) : Number{0.0, infinity}}}
      .take();
}

}  // namespace fantail::rules
