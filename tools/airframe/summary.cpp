// SPDX-License-Identifier: MIT
#include "airframe/summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

using model::Estimate;
using text::fixed;

Estimate exactly(double value) { return {.value = value, .low = value, .high = value}; }

Estimate scaled(const Estimate& e, double factor) {
  const auto [low, high] = std::minmax({e.low * factor, e.high * factor});
  return {.value = e.value * factor, .low = low, .high = high};
}

/// So that the number has three digits, but at least two decimals: alpha and beta are small on a large area.
int decimals_of(double value) {
  const double size = std::abs(value);
  return size > 0.0 && size < 1.0 ? std::min(2 - static_cast<int>(std::floor(std::log10(size))), 9) : 2;
}

std::optional<Estimate> of_mass(const std::optional<model::MassSum>& sum, double model::MassSum::* member) {
  return sum ? std::optional{exactly((*sum).*member)} : std::nullopt;
}

void add_body(Summary& summary, const sim::Vehicle& vehicle) {
  const auto& airframe = vehicle.airframe;
  const model::BuildUp& b = summary.build_up;
  const auto file = [&](double sim::Airframe::* member) {
    return airframe ? std::optional{(*airframe).*member} : std::nullopt;
  };
  summary.lines.push_back({"normal force slope", "1/rad", b.normal_force_slope_per_rad,
                           file(&sim::Airframe::normal_force_slope_per_rad), 2});
  summary.lines.push_back(
      {"centre of pressure", "m", b.centre_of_pressure_m, file(&sim::Airframe::centre_of_pressure_m), 3});
  if (b.worst_centre_of_pressure_m) {
    summary.lines.push_back({"centre of pressure, worst plane", "m", b.worst_centre_of_pressure_m, {}, 3});
  }
  summary.lines.push_back(
      {"spread of the parts", "m", exactly(b.parts_spread_m), file(&sim::Airframe::parts_spread_m), 3});
  summary.lines.push_back(
      {"body lift area", "m2", exactly(b.body_lift_area_m2), file(&sim::Airframe::body_lift_area_m2), 3});
  summary.lines.push_back(
      {"body lift position", "m", exactly(b.body_lift_position_m), file(&sim::Airframe::body_lift_position_m), 3});
}

void add_masses(Summary& summary, const sim::Vehicle& vehicle) {
  using Sum = model::MassSum;
  const model::BuildUp& b = summary.build_up;
  const auto file = [&](const auto& value_of) {
    return vehicle.airframe ? std::optional<double>{value_of(*vehicle.airframe)} : std::nullopt;
  };
  const double empty_kg = vehicle.mass_kg - vehicle.motor.propellant_kg();
  auto& lines = summary.lines;
  lines.push_back({"mass at lift-off", "kg", of_mass(b.at_liftoff, &Sum::mass_kg), vehicle.mass_kg, 3});
  lines.push_back({"mass after burn-out", "kg", of_mass(b.after_burnout, &Sum::mass_kg), empty_kg, 3});
  lines.push_back({"centre of gravity at lift-off", "m", of_mass(b.at_liftoff, &Sum::centre_of_gravity_m),
                   file([](const sim::Airframe& a) { return a.at_liftoff.centre_of_gravity_m; }), 3});
  lines.push_back({"centre of gravity after burn-out", "m", of_mass(b.after_burnout, &Sum::centre_of_gravity_m),
                   file([](const sim::Airframe& a) { return a.after_burnout.centre_of_gravity_m; }), 3});
  lines.push_back({"transverse inertia at lift-off", "kg m2", of_mass(b.at_liftoff, &Sum::transverse_inertia_kg_m2),
                   file([](const sim::Airframe& a) { return a.at_liftoff.transverse_inertia_kg_m2; }), 3});
  lines.push_back({"transverse inertia after burn-out", "kg m2",
                   of_mass(b.after_burnout, &Sum::transverse_inertia_kg_m2),
                   file([](const sim::Airframe& a) { return a.after_burnout.transverse_inertia_kg_m2; }), 3});
  lines.push_back({"roll inertia at lift-off", "kg m2", of_mass(b.at_liftoff, &Sum::roll_inertia_kg_m2),
                   vehicle.roll_plant.inertia_kg_m2, 5});
}

void add_roll(Summary& summary, const sim::Vehicle& vehicle) {
  const model::BuildUp& b = summary.build_up;
  const sim::RollPlant& plant = vehicle.roll_plant;
  const double per_area = 1.0 / plant.reference_area_m2;
  summary.lines.push_back({"roll damping alpha", "m2", scaled(b.roll_damping_m4, per_area), plant.damping_m2,
                           decimals_of(b.roll_damping_m4.value * per_area)});
  if (b.roll_torque_m3) {
    summary.lines.push_back({"canard torque beta", "m", scaled(*b.roll_torque_m3, per_area), plant.torque_m,
                             decimals_of(b.roll_torque_m3->value * per_area)});
    if (b.roll_torque_m3->low == 0.0) {
      summary.remarks.emplace_back(
          "Beta is computed without the canards' wash on the fins behind them, which takes back part of the torque, or "
          "all of it: the amount is not computed. Measure it in a tunnel.");
    }
  } else {
    summary.remarks.emplace_back("The file has no section [canard_fins]: their torque is not computed.");
  }
  if (b.cant_as_canards) {
    summary.lines.push_back({"canards for a degree of fin cant", "deg", b.cant_as_canards, {}, 2});
    if (const double cant_rad = vehicle.geometry->fins->cant_rad; cant_rad != 0.0) {
      const Estimate offset_deg = scaled(*b.cant_as_canards, text::degrees(cant_rad));
      summary.remarks.push_back(
          fmt::format("Fins canted by {} deg push as canards at {} deg would ({}): the fin offset of a scenario.",
                      text::brief(text::degrees(cant_rad), 2), fixed(offset_deg.value, 1), range_text(offset_deg, 1)));
    }
  }
  if (b.hinge_moment_m3) {
    summary.lines.push_back({"hinge moment, 100 m/s, 10 deg",
                             "N m",
                             scaled(*b.hinge_moment_m3, 0.5 * 1.225 * 100.0 * 100.0 * text::radians(10.0)),
                             {},
                             4});
  }
}

void judge(Summary& summary, const sim::Vehicle& vehicle) {
  const model::BuildUp& b = summary.build_up;
  const Estimate& pressure = model::least_centre_of_pressure_m(b);
  const double calibre_m = model::largest_diameter_m(*vehicle.geometry);
  struct Case {
    const char* when;
    std::optional<double> gravity_m;
  };
  const auto of_parts = [](const std::optional<model::MassSum>& sum) {
    return sum ? std::optional{sum->centre_of_gravity_m} : std::nullopt;
  };
  const auto& airframe = vehicle.airframe;
  const Case at_liftoff{"at lift-off", airframe ? airframe->at_liftoff.centre_of_gravity_m : of_parts(b.at_liftoff)};
  const Case empty{"after burn-out",
                   airframe ? airframe->after_burnout.centre_of_gravity_m : of_parts(b.after_burnout)};
  summary.centre_of_gravity_m = at_liftoff.gravity_m;
  std::optional<Estimate> least;
  const char* when = "";
  for (const Case& c : {at_liftoff, empty}) {
    if (!c.gravity_m) {
      continue;
    }
    const Estimate margin{.value = (pressure.value - *c.gravity_m) / calibre_m,
                          .low = (pressure.low - *c.gravity_m) / calibre_m,
                          .high = (pressure.high - *c.gravity_m) / calibre_m};
    const std::optional<double> file =
        airframe ? std::optional{(airframe->centre_of_pressure_m - *c.gravity_m) / calibre_m} : std::nullopt;
    summary.lines.push_back({fmt::format("static margin {}{}", c.when, airframe ? ", file's centre of gravity" : ""),
                             "calibres", margin, file, 2});
    if (!least || margin.value < least->value) {
      least = margin;
      when = c.when;
    }
  }
  if (!least) {
    summary.sentence =
        "Not judged: the centre of gravity is unknown. It follows from [masses] with the propellant's position, or "
        "from [airframe].";
    return;
  }
  const std::string range = fmt::format("{} calibres {}{} ({} to {} by the method's error)", fixed(least->value, 2),
                                        when, b.worst_centre_of_pressure_m ? ", in the worst plane" : "",
                                        fixed(least->low, 2), fixed(least->high, 2));
  if (least->high < 0.0) {
    summary.stability = Stability::unstable;
    summary.sentence = fmt::format("Unstable: the static margin is {}. It turns over in flight.", range);
  } else if (least->low < 0.0) {
    summary.stability = Stability::marginal;
    summary.sentence =
        fmt::format("Perhaps unstable: the static margin is {}. Swing it in a tunnel, or move weight forwards.", range);
  } else if (least->value < least_margin_calibres) {
    summary.stability = Stability::marginal;
    summary.sentence = fmt::format("Stable, but with less than the usual calibre: the static margin is {}.", range);
  } else {
    summary.stability = Stability::stable;
    summary.sentence = fmt::format("Stable: the static margin is {}.", range);
  }
}

/// What flights use and what its shape gives are of one rocket: a margin of the shape alone must not be the verdict.
void judge_by_file(Summary& summary, const sim::Vehicle& vehicle) {
  const Estimate& shape = summary.build_up.centre_of_pressure_m;
  if (!vehicle.airframe ||
      (vehicle.airframe->centre_of_pressure_m >= shape.low && vehicle.airframe->centre_of_pressure_m <= shape.high)) {
    return;
  }
  const sim::Airframe& file = *vehicle.airframe;
  const bool is_at_liftoff = file.at_liftoff.centre_of_gravity_m >= file.after_burnout.centre_of_gravity_m;
  const double margin_m = sim::static_margin_m(file, is_at_liftoff ? file.at_liftoff : file.after_burnout);
  const bool shape_is_unstable = summary.stability == Stability::unstable;
  const bool file_is_unstable = margin_m <= 0.0;
  const char* const word = shape_is_unstable && file_is_unstable   ? "Unstable"
                           : shape_is_unstable || file_is_unstable ? "Unstable, and doubtful"
                                                                   : "Doubtful";
  const double gravity_m = file.centre_of_pressure_m - margin_m;
  const double calibre_m = model::largest_diameter_m(*vehicle.geometry);
  summary.stability = shape_is_unstable || file_is_unstable ? Stability::unstable : Stability::doubtful;
  summary.sentence = fmt::format(
      "{}: the file's centre of pressure, which flights use, gives a static margin of {} calibres {}; the shape gives "
      "{} ({} to {}). Measure the centre of pressure, or correct the file.",
      word, fixed(margin_m / calibre_m, 2), is_at_liftoff ? "at lift-off" : "after burn-out",
      fixed((shape.value - gravity_m) / calibre_m, 2), fixed((shape.low - gravity_m) / calibre_m, 2),
      fixed((shape.high - gravity_m) / calibre_m, 2));
}

/// Numbers of the file that lie outside of their computed ranges. A margin follows from its centres.
void compare(Summary& summary) {
  std::string outside;
  for (const Line& line : summary.lines) {
    const bool has_range = line.computed && line.computed->low < line.computed->high;
    if (has_range && line.in_file && line.unit != "calibres" &&
        (*line.in_file < line.computed->low || *line.in_file > line.computed->high)) {
      outside +=
          fmt::format("{}{} ({} {})", outside.empty() ? "" : ", ", line.what, text::brief(*line.in_file, 5), line.unit);
    }
  }
  if (!outside.empty()) {
    summary.remarks.push_back("The file is outside the ranges computed from the shape in: " + outside +
                              ". A measured number counts more than a computed one; an assumed number does not.");
  }
}

}  // namespace

std::string range_text(const Estimate& estimate, int decimals) {
  if (std::isinf(estimate.high)) {
    return fixed(estimate.low, decimals) + " or more";
  }
  return std::isinf(estimate.low)
             ? fixed(estimate.high, decimals) + " or less"
             : fmt::format("{} to {}", fixed(estimate.low, decimals), fixed(estimate.high, decimals));
}

Summary summarize(const sim::Vehicle& vehicle) {
  Summary summary{
      .build_up = model::build_up(vehicle), .lines = {}, .sentence = {}, .remarks = {}, .centre_of_gravity_m = {}};
  add_body(summary, vehicle);
  add_masses(summary, vehicle);
  judge(summary, vehicle);
  judge_by_file(summary, vehicle);
  compare_with_design(summary, vehicle);
  doubt_own_numbers(summary, vehicle);
  add_roll(summary, vehicle);
  compare(summary);
  if (!vehicle.geometry->fins) {
    summary.remarks.emplace_back("The file has no section [fins].");
  }
  return summary;
}

}  // namespace fantail::airframe
