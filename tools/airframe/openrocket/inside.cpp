// SPDX-License-Identifier: MIT
// What is inside or on the body: masses, fins, the motor's place.
#include <algorithm>
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
                      {.name = {},
                       .mass_kg = packed_kg(c),
                       .position_m = place.begin_m + 0.5 * length_m,
                       .length_m = length_m,
                       .radius_of_gyration_m = of_a_full_rod * radius_m},
                      into);
  } else if (is_ring(kind)) {
    const double length_m = c.number("length", 0.0, longest_m);
    const char* outer = c.has("outerradius") ? "outerradius" : "radius";
    const double outer_m = c.number_or_auto(outer, 0.0, widest_m).value_or(parent.inner_m);
    double inner_m = kind == "bulkhead" ? 0.0 : c.number_or_auto("innerradius", 0.0, widest_m).value_or(0.0);
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
    own.mass_kg *= c.number_or("instancecount", 1, 100, 1);
    if (const std::string cluster = c.text("clusterconfiguration"); !cluster.empty() && cluster != "single") {
      design_.left_out.push_back(
          {.what = fmt::format("{} \"{}\": a cluster ({}), read as one tube with one motor", kind, c.name(), cluster),
           .is_force = true});
    }
    note_motor(c, place);
    add_with_children(c, place, own, into);
  } else {
    design_.not_used.push_back(fmt::format("{} \"{}\": the whole part.", kind, c.name()));
    design_.left_out.push_back({.what = fmt::format("{} \"{}\": not read", kind, c.name()), .is_force = true});
  }
}

void Reader::add_fins(const Component& c, const Place& parent, Masses& into) {
  FoundFins found = read_fins(c, parent.outer_m, design_.assumed);
  const double front_m = front_of(c, parent, found.set.root_chord_m);
  found.set.position_m = front_m;
  found.mass.position_m += front_m;
  fins_.emplace_back(found.name, found.set);
  const Place place{.begin_m = front_m, .length_m = found.set.root_chord_m};
  if (c.number_or("filletradius", 0.0, widest_m, 0.0) > 0.0) {
    design_.not_used.push_back(fmt::format("Fins \"{}\": their fillets.", found.name));
    design_.left_out.push_back({.what = fmt::format("fins \"{}\": the mass of their fillets", found.name)});
  }
  if (c.number_or("tabheight", 0.0, widest_m, 0.0) > 0.0 && c.number_or("tablength", 0.0, longest_m, 0.0) > 0.0) {
    design_.not_used.push_back(fmt::format("Fins \"{}\": their tabs.", found.name));
    design_.left_out.push_back({.what = fmt::format("fins \"{}\": the mass of their tabs", found.name)});
  }
  add_with_children(c, place, found.mass, into);
}

void Reader::note_motor(const Component& c, const Place& place) {
  const pugi::xml_node mount = c.xml().child("motormount");
  if (!mount) {
    return;
  }
  if (design_.motor) {
    design_.not_used.push_back(fmt::format("Motor mount \"{}\": a second one.", c.name()));
    design_.left_out.push_back({.what = fmt::format("motor mount \"{}\": a second one", c.name()), .is_force = true});
    return;
  }
  const Component mounted{file_, mount};
  MotorPlace motor{.end_m = place.begin_m + place.length_m + mounted.number_or("overhang", -5.0, 5.0, 0.0),
                   .motors = {}};
  for (const pugi::xml_node node : mount.children("motor")) {
    const Component one{file_, node};
    motor.motors.push_back({.configuration = node.attribute("configid").as_string(),
                            .designation = one.text("designation"),
                            .length_m = one.number_or("length", 0.0, 10.0, 0.0),
                            .diameter_m = one.number_or("diameter", 0.0, 1.0, 0.0)});
  }
  if (!motor.motors.empty()) {
    design_.motor = motor;
  }
}

}  // namespace fantail::airframe::openrocket
