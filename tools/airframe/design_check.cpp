// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "airframe/summary.hpp"
#include "text/number.hpp"

namespace fantail::airframe {
namespace {

using Design = sim::Geometry::Design;
using text::fixed;

constexpr double mass_tolerance = 0.02;
constexpr double tolerance_calibres = 0.2;

/// At an angle of attack the lift of the body adds to that of nose and fins, at a place of its own. Where planes
/// differ, a design does not say which one its own belongs to: any between the worst and the best does.
double centre_of_pressure_m(const model::BuildUp& b, const sim::Geometry& shape, const Design& design) {
  const double cross_section_m2 = 0.25 * std::numbers::pi * shape.diameter_m * shape.diameter_m;
  const double body = b.body_lift_area_m2 / cross_section_m2 * std::sin(design.angle_of_attack_rad);
  const double rest = b.normal_force_slope_per_rad.value;
  const double mean_m = (rest * b.centre_of_pressure_m.value + body * b.body_lift_position_m) / (rest + body);
  if (!b.worst_centre_of_pressure_m || !design.centre_of_pressure_m) {
    return mean_m;
  }
  const double apart_m = b.centre_of_pressure_m.value - b.worst_centre_of_pressure_m->value;
  return std::clamp(*design.centre_of_pressure_m, mean_m - apart_m, mean_m + apart_m);
}

/// The centre of gravity at lift-off, and those that it may have under thrust.
struct Gravity {
  std::optional<double> at_liftoff_m;
  std::optional<double> after_burnout_m;
};

Gravity gravity_of(const Summary& summary, const sim::Vehicle& vehicle) {
  const auto& b = summary.build_up;
  if (vehicle.airframe) {
    return {vehicle.airframe->at_liftoff.centre_of_gravity_m, vehicle.airframe->after_burnout.centre_of_gravity_m};
  }
  return {b.at_liftoff ? std::optional{b.at_liftoff->centre_of_gravity_m} : std::nullopt,
          b.after_burnout ? std::optional{b.after_burnout->centre_of_gravity_m} : std::nullopt};
}

class Comparison {
 public:
  Comparison(Summary& summary, const sim::Vehicle& vehicle)
      : summary_{summary}, calibre_m_{model::largest_diameter_m(*vehicle.geometry)} {}

  void mass(std::optional<double> stored_kg, double ours_kg) {
    if (stored_kg) {
      note(std::abs(*stored_kg - ours_kg) > mass_tolerance * *stored_kg,
           fmt::format("a mass at lift-off of {} kg, and this vehicle has {} kg", fixed(*stored_kg, 3),
                       fixed(ours_kg, 3)));
    }
  }

  void centre(const char* what, std::optional<double> stored_m, std::optional<double> ours_m) {
    if (stored_m && ours_m) {
      const double apart = std::abs(*stored_m - *ours_m) / calibre_m_;
      note(apart > tolerance_calibres, fmt::format("{} at {} m, and this vehicle has it at {} m, {} calibres away",
                                                   what, fixed(*stored_m, 3), fixed(*ours_m, 3), fixed(apart, 2)));
    }
  }

  /// Some time under thrust, so between the margins at its beginning and its end.
  void margin(std::optional<double> stored, const Gravity& gravity, double pressure_m) {
    if (!stored || !gravity.at_liftoff_m || !gravity.after_burnout_m) {
      return;
    }
    const double full = (pressure_m - *gravity.at_liftoff_m) / calibre_m_;
    const double empty = (pressure_m - *gravity.after_burnout_m) / calibre_m_;
    const auto [low, high] = std::minmax(full, empty);
    note(*stored < low - tolerance_calibres || *stored > high + tolerance_calibres,
         fmt::format("a static margin of {} calibres, and this vehicle has {} to {}", fixed(*stored, 2), fixed(low, 2),
                     fixed(high, 2)));
  }

  [[nodiscard]] std::size_t compared() const { return compared_; }

 private:
  void note(bool differs, std::string clause) {
    ++compared_;
    if (differs) {
      summary_.doubts.push_back(std::move(clause));
    }
  }

  Summary& summary_;
  double calibre_m_;
  std::size_t compared_ = 0;
};

/// "a; b; c", and how many more there are.
std::string list(const std::vector<std::string>& all) {
  constexpr std::size_t most = 4;
  const auto shown = std::min(all.size(), most);
  const std::string out =
      fmt::format("{}", fmt::join(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(shown), "; "));
  return shown < all.size() ? out + fmt::format("; and {} more", all.size() - shown) : out;
}

/// Behind the word that is the verdict, so that nobody reads it alone.
void say_not_compared(Summary& summary, const Design& design, const std::string& missing) {
  const std::size_t colon = summary.sentence.find(": ");
  summary.sentence.insert(colon, ", not compared with its design");
  summary.sentence += fmt::format(
      " {} stores no {}. Weigh and balance the rocket, or simulate it in OpenRocket, save, and make the vehicle again.",
      design.file, missing);
}

}  // namespace

void compare_with_design(Summary& summary, const sim::Vehicle& vehicle) {
  const auto& found = vehicle.geometry->design;
  if (!found || summary.stability == Stability::unknown) {
    return;
  }
  const Design& design = *found;
  const Gravity gravity = gravity_of(summary, vehicle);
  const double pressure_m = summary.build_up.centre_of_pressure_m.value;
  Comparison comparison{summary, vehicle};
  comparison.mass(design.mass_kg, vehicle.mass_kg);
  comparison.centre("the centre of gravity at lift-off", design.centre_of_gravity_m, gravity.at_liftoff_m);
  comparison.centre("the centre of pressure", design.centre_of_pressure_m,
                    centre_of_pressure_m(summary.build_up, *vehicle.geometry, design));
  const bool has_centres = design.centre_of_gravity_m && design.centre_of_pressure_m;
  if (!has_centres) {
    comparison.margin(design.margin_calibres, gravity, pressure_m);
  }
  const bool is_whole = design.mass_kg && (has_centres || design.margin_calibres);
  summary.agrees_with_design = is_whole && summary.doubts.empty();
  if (!summary.doubts.empty()) {
    doubt(summary, fmt::format("{} stores {}.", design.file, list(summary.doubts)));
  } else if (is_whole) {
    summary.sentence += fmt::format(" {} and the flight \"{}\" stored in {} agree.",
                                    has_centres ? "Mass, centres of gravity and pressure" : "Mass and static margin",
                                    design.flight, design.file);
  } else if (!design.left_out.empty()) {
    summary.doubts = design.left_out;
    doubt(summary, fmt::format("parts of {} were left out or are uncertain: {}.", design.file, list(design.left_out)));
  } else {
    say_not_compared(summary, design,
                     comparison.compared() == 0 ? "simulated flight with this motor that matches the design"
                                                : "flight with mass and both centres");
  }
}

}  // namespace fantail::airframe
