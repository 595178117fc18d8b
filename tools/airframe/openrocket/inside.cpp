// SPDX-License-Identifier: MIT
// What is inside or on the body: masses, fins, the motor's place.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/core.h>

#include "airframe/openrocket/fins.hpp"
#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/solids.hpp"
#include "text/number.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;

constexpr double of_a_full_rod = 0.70710678;  // radius of gyration over radius

double front_of(const Component& c, const Place& parent, double length_m) {
  const char* key = c.has("axialoffset") ? "axialoffset" : "position";
  const pugi::xml_node offset = c.xml().child(key);
  const std::string method = offset.attribute(c.has("axialoffset") ? "method" : "type").as_string("top");
  const double offset_m = c.number_or(key, -longest_m, longest_m, 0.0);
  if (method == "bottom") {
    return parent.begin_m + parent.length_m - length_m + offset_m;
  }
  if (method == "middle") {
    return parent.begin_m + 0.5 * (parent.length_m - length_m) + offset_m;
  }
  return (method == "absolute" ? 0.0
          : method == "after"  ? parent.begin_m + parent.length_m
                               : parent.begin_m) +
         offset_m;
}

bool is_packed(const std::string& kind) {
  return kind == "masscomponent" || kind == "parachute" || kind == "streamer" || kind == "shockcord";
}

bool is_ring(const std::string& kind) {
  return kind == "innertube" || kind == "tubecoupler" || kind == "engineblock" || kind == "centeringring" ||
         kind == "bulkhead" || kind == "launchlug";
}

/// Several of one kind in a row, each this far behind the one before; the first is the one that was read.
Geometry::Mass in_a_row(const Component& c, const Geometry::Mass& one) {
  const double count = c.number_or("instancecount", 1.0, 100.0, 1.0);
  if (count == 1.0) {
    return one;
  }
  const double apart_m = c.number_or("instanceseparation", -longest_m, longest_m, 0.0);
  Geometry::Mass all = one;
  all.mass_kg *= count;
  all.position_m += 0.5 * (count - 1.0) * apart_m;
  all.length_m = std::sqrt(one.length_m * one.length_m + (count * count - 1.0) * apart_m * apart_m);
  return all;
}

/// Its own radius of gyration, about an axis that is not its own.
Geometry::Mass off_axis(Geometry::Mass mass, double away_m) {
  mass.radius_of_gyration_m = std::hypot(mass.radius_of_gyration_m, away_m);
  return mass;
}

double away_m(const Component& c) { return std::abs(c.number_or("radialposition", -widest_m, widest_m, 0.0)); }

/// A ring whose inner radius is "auto" sits on the inner tubes beside it: the radius of the largest that it overlaps.
double radius_of_tubes_m(const std::filesystem::path& file, const Component& ring, const Place& parent,
                         double length_m) {
  const double front_m = front_of(ring, parent, length_m);
  double largest_m = 0.0;
  for (const pugi::xml_node sibling : ring.xml().parent().children("innertube")) {
    const Component tube{file, sibling};
    const double tube_m = tube.number("length", 0.0, longest_m);
    const double tube_front_m = front_of(tube, parent, tube_m);
    if (tube_front_m < front_m + length_m && front_m < tube_front_m + tube_m) {
      largest_m = std::max(largest_m, tube.number_or_auto("outerradius", 0.0, widest_m).value_or(parent.inner_m));
    }
  }
  return largest_m;
}

/// Two discs and a neck between them, and a screw's head, half a sphere or flatter.
Geometry::Mass rail_button(const Component& c, double begin_m, double body_radius_m) {
  const double outer_m = 0.5 * c.number("outerdiameter", 0.0, widest_m);
  const double inner_m = 0.5 * c.number("innerdiameter", 0.0, widest_m);
  const double height_m = c.number("height", 0.0, widest_m);
  const double base_m = c.number_or("baseheight", 0.0, widest_m, 0.0);
  const double flange_m = c.number_or("flangeheight", 0.0, widest_m, 0.0);
  const double screw_m = c.number_or("screwheight", 0.0, widest_m, 0.0);
  const double neck_m = std::max(0.0, height_m - base_m - flange_m - screw_m);
  const double volume_m3 =
      std::numbers::pi * (outer_m * outer_m * (base_m + flange_m + 2.0 / 3.0 * screw_m) + inner_m * inner_m * neck_m);
  return {.name = {},
          .mass_kg = volume_m3 * c.density(),
          .position_m = begin_m,
          .radius_of_gyration_m = body_radius_m + 0.5 * height_m};
}

/// What is packed weighs by its own rules.
double packed_kg(const Component& c) {
  const std::string kind = c.kind();
  if (kind == "masscomponent") {
    return c.number("mass", 0.0, heaviest_kg);
  }
  if (kind == "shockcord") {
    return c.density() * c.number("cordlength", 0.0, 1000.0);
  }
  if (kind == "streamer") {
    return c.density() * c.number("striplength", 0.0, 1000.0) * c.number("stripwidth", 0.0, 100.0);
  }
  const double diameter_m = c.number("diameter", 0.0, 100.0);
  const double line_kg_m =
      ::fantail::text::number(c.xml().child("linematerial").attribute("density").value()).value_or(0.0);
  return c.density() * 0.25 * std::numbers::pi * diameter_m * diameter_m +
         line_kg_m * c.number_or("linecount", 0.0, 1000.0, 0.0) * c.number_or("linelength", 0.0, 1000.0, 0.0);
}

}  // namespace

void Reader::add_with_children(const Component& c, const Place& place, Geometry::Mass own, Masses& into) {
  own.name = c.name();
  Masses children;
  const std::size_t left_out_before = design_.left_out.size();
  for (const pugi::xml_node child : c.xml().child("subcomponents").children()) {
    add_child(Component{file_, child}, place, children);
  }
  const Overrides overrides = overrides_of(c, place.begin_m);
  apply_overrides(c, overrides, own, children);
  if (overrides.mass_is_of_all && overrides.centre_is_of_all) {
    const auto first = design_.left_out.begin() + static_cast<std::ptrdiff_t>(left_out_before);
    design_.left_out.erase(
        std::remove_if(first, design_.left_out.end(), [](const LeftOut& one) { return !one.is_force; }),
        design_.left_out.end());
  }
  if (own.mass_kg > 0.0) {
    into.push_back(own);
  }
  into.insert(into.end(), children.begin(), children.end());
}

void Reader::add_child(const Component& c, const Place& parent, Masses& into) {
  const std::string kind = c.kind();
  note_unknown(c);
  if (is_fin_set(c)) {
    add_fins(c, parent, into);
  } else if (is_packed(kind)) {
    if (kind == "parachute" || kind == "streamer") {
      design_.not_used.push_back(fmt::format(
          "{} \"{}\": everything except its mass; when it opens and how it falls go into [recovery] of the vehicle.",
          kind, c.name()));
    }
    const double length_m = c.number_or("packedlength", 0.0, longest_m, 0.0);
    const double radius_m = c.number_or_auto("packedradius", 0.0, widest_m).value_or(parent.inner_m);
    const Place place{.begin_m = front_of(c, parent, length_m), .length_m = length_m};
    add_with_children(c, place,
                      off_axis({.name = {},
                                .mass_kg = packed_kg(c),
                                .position_m = place.begin_m + 0.5 * length_m,
                                .length_m = length_m,
                                .radius_of_gyration_m = of_a_full_rod * radius_m},
                               away_m(c)),
                      into);
  } else if (is_ring(kind)) {
    const double length_m = c.number("length", 0.0, longest_m);
    const char* outer = c.has("outerradius") ? "outerradius" : "radius";
    const double outer_m = c.number_or_auto(outer, 0.0, widest_m).value_or(parent.inner_m);
    double inner_m = kind == "bulkhead"
                         ? 0.0
                         : c.number_or_auto("innerradius", 0.0, widest_m)
                               .value_or(std::min(outer_m, radius_of_tubes_m(file_, c, parent, length_m)));
    if (c.has("thickness")) {
      inner_m = std::max(0.0, outer_m - c.number("thickness", 0.0, widest_m));
    }
    const Place place{
        .begin_m = front_of(c, parent, length_m), .length_m = length_m, .outer_m = outer_m, .inner_m = inner_m};
    Geometry::Mass own = mass_of({.begin_m = place.begin_m,
                                  .length_m = length_m,
                                  .radius_m = [=](double) { return outer_m; },
                                  .wall_m = outer_m - inner_m,
                                  .density_kg_m3 = c.density()});
    own = in_a_row(c, own);
    if (kind == "launchlug") {
      add_with_children(c, place, off_axis(own, parent.outer_m), into);
      return;
    }
    const Cluster cluster = cluster_of(c, outer_m);
    note_motor(c, place, cluster);
    Masses inside;
    add_with_children(c, place, own, inside);
    for (Geometry::Mass& mass : inside) {
      mass.mass_kg *= cluster.count;
      into.push_back(off_axis(mass, std::hypot(cluster.ring_m, away_m(c))));
    }
  } else if (kind == "railbutton") {
    const double begin_m = front_of(c, parent, 0.0);
    add_with_children(c, {.begin_m = begin_m}, in_a_row(c, rail_button(c, begin_m, parent.outer_m)), into);
  } else {
    design_.not_used.push_back(fmt::format("{} \"{}\": the whole part.", kind, c.name()));
    leave_out(c, "not read", true);
  }
}

void Reader::add_fins(const Component& c, const Place& parent, Masses& into) {
  FoundFins found = read_fins(c, parent.outer_m, design_.assumed);
  const double front_m = front_of(c, parent, found.set.root_chord_m);
  found.set.position_m = front_m;
  found.mass.position_m += front_m;
  fins_.push_back({.name = found.name, .first_angle_rad = found.first_angle_rad, .set = found.set});
  if (c.number_or("radiusoffset", -widest_m, widest_m, 0.0) != 0.0) {
    leave_out(c, "its distance from the body (radiusoffset)", true);
  }
  add_with_children(c, {.begin_m = front_m, .length_m = found.set.root_chord_m}, found.mass, into);
}

}  // namespace fantail::airframe::openrocket
