// SPDX-License-Identifier: MIT
// A vehicle's parts lie within the rocket; those of a design need not.
#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "airframe/model/body.hpp"
#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/solids.hpp"
#include "text/error.hpp"

namespace fantail::airframe::openrocket {

using sim::Geometry;

/// A rod that would reach out has the mass, middle and inertia of two points, which may not.
void Reader::check_places() {
  constexpr double worth_a_word = 0.01;  // of the transverse inertia
  Geometry& g = design_.geometry;
  const double room_m = g.length_m + g.diameter_m;  // a retainer, or the end of a motor
  const double drawn_kg_m2 = model::sum_of(g.masses).transverse_inertia_kg_m2;
  Masses placed;
  for (Geometry::Mass mass : g.masses) {
    if (mass.position_m < 0.0 || mass.position_m > room_m) {
      throw text::Error{text::ErrorKind::bad_data,
                        fmt::format("{}: \"{}\": its centre of gravity is {:.4g} m behind the tip of the nose, but the "
                                    "rocket is {:.4g} m long. Move it inside, or leave it out",
                                    file_.string(), mass.name, mass.position_m, g.length_m)};
    }
    Geometry::Mass shorter = mass;
    shorten_to_rocket(shorter, room_m);
    const double lost_kg_m2 =
        mass.mass_kg * (mass.length_m * mass.length_m - shorter.length_m * shorter.length_m) / 12.0;
    const double apart_m = mass.length_m / std::sqrt(12.0);
    if (lost_kg_m2 > worth_a_word * drawn_kg_m2 && apart_m <= std::min(mass.position_m, room_m - mass.position_m)) {
      for (const auto& [half, to_m] : {std::pair{"front", -apart_m}, std::pair{"rear", apart_m}}) {
        placed.push_back({.name = fmt::format("{} ({} half)", mass.name, half),
                          .mass_kg = 0.5 * mass.mass_kg,
                          .position_m = mass.position_m + to_m,
                          .radius_of_gyration_m = mass.radius_of_gyration_m});
      }
    } else {
      placed.push_back(shorter);
    }
  }
  g.masses = std::move(placed);
  const double lost = 1.0 - model::sum_of(g.masses).transverse_inertia_kg_m2 / drawn_kg_m2;
  if (lost > worth_a_word) {
    design_.assumed.push_back(fmt::format(
        "Parts that reach out of the rocket: shortened until they end in it. Its transverse inertia is {:.1f} % less "
        "than drawn; masses and centres of gravity are as drawn.",
        100.0 * lost));
  }
}

}  // namespace fantail::airframe::openrocket
