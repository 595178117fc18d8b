// SPDX-License-Identifier: MIT
#include "airframe/openrocket/fins.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/core.h>

#include "airframe/openrocket/solids.hpp"
#include "text/number.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;

/// Area and the middle of its chord-wise distances.
struct Planform {
  double area_m2 = 0.0;
  double middle_m = 0.0;
};

Planform planform(const Geometry::FinSet& set) {
  const double root = set.root_chord_m;
  const double tip = set.tip_chord_m;
  return {.area_m2 = 0.5 * set.span_m * (root + tip),
          .middle_m = (set.sweep_m * (root + 2.0 * tip) + root * root + root * tip + tip * tip) / (3.0 * (root + tip))};
}

/// The trapezoid on this root with this area, span and middle.
void make_trapezoid(Geometry::FinSet& set, const Planform& wanted) {
  set.tip_chord_m = std::max(0.0, 2.0 * wanted.area_m2 / set.span_m - set.root_chord_m);
  const double root = set.root_chord_m;
  const double tip = set.tip_chord_m;
  set.sweep_m = (3.0 * wanted.middle_m * (root + tip) - root * root - root * tip - tip * tip) / (root + 2.0 * tip);
}

/// The polygon of a freeform fin: from the root's front around to its end, closed along the root.
void read_points(const Component& component, Geometry::FinSet& set) {
  constexpr double largest_m = 5.0;
  std::vector<std::pair<double, double>> points;
  for (const pugi::xml_node point : component.xml().child("finpoints").children("point")) {
    const auto x_m = ::fantail::text::number(point.attribute("x").value());
    const auto y_m = ::fantail::text::number(point.attribute("y").value());
    if (!x_m || !y_m || std::abs(*x_m) > largest_m || std::abs(*y_m) > largest_m) {
      component.refuse("a point of its fins is missing a number, or farther than 5 m away");
    }
    points.emplace_back(*x_m, *y_m);
  }
  if (points.size() < 3) {
    component.refuse("its fins have fewer than three points");
  }
  double twice_m2 = 0.0;
  double moment_m3 = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [ax, ay] = points[i];
    const auto& [bx, by] = points[(i + 1) % points.size()];
    const double cross = ax * by - bx * ay;
    twice_m2 += cross;
    moment_m3 += (ax + bx) * cross;
    set.span_m = std::max(set.span_m, ay);
  }
  set.root_chord_m = std::abs(points.back().first - points.front().first);
  if (!(set.span_m > 0.0) || !(set.root_chord_m > 0.0) || twice_m2 == 0.0) {
    component.refuse("its fins have no root, no span or no area");
  }
  make_trapezoid(set, {.area_m2 = 0.5 * std::abs(twice_m2), .middle_m = moment_m3 / (3.0 * twice_m2)});
}

/// Of its thickness times its area: what the rounding of its edges leaves.
double full_share(const Component& component) {
  const std::string section = component.text("crosssection");
  return section == "airfoil" ? 0.85 : section == "rounded" ? 0.99 : 1.0;
}

/// The tabs that reach through the body's wall.
Geometry::Mass with_tabs(const Component& component, const Geometry::FinSet& set, double body_radius_m,
                         const Geometry::Mass& own) {
  const double height_m = component.number_or("tabheight", 0.0, 1.0, 0.0);
  const double length_m = component.number_or("tablength", 0.0, 5.0, 0.0);
  if (height_m == 0.0 || length_m == 0.0) {
    return own;
  }
  const double offset_m = component.number_or("tabposition", -5.0, 5.0, 0.0);
  const std::string from = component.xml().child("tabposition").attribute("relativeto").as_string("front");
  const double room_m = set.root_chord_m - length_m;
  const double front_m = offset_m + (from == "center" || from == "middle" ? 0.5 * room_m
                                     : from == "end" || from == "bottom"  ? room_m
                                                                          : 0.0);
  return together(own, {.name = {},
                        .mass_kg = set.count * height_m * length_m * set.thickness_m * component.density(),
                        .position_m = front_m + 0.5 * length_m,
                        .length_m = length_m,
                        .radius_of_gyration_m = std::max(0.0, body_radius_m - 0.5 * height_m)});
}

/// Glue in the corners between fin and body, both sides, which a cylinder of the fillet's radius touches.
Geometry::Mass with_fillets(const Component& component, const Geometry::FinSet& set, double body_radius_m,
                            const Geometry::Mass& own) {
  const double radius_m = component.number_or("filletradius", 0.0, 1.0, 0.0);
  const double density_kg_m3 = component.density("filletmaterial");
  if (radius_m == 0.0 || density_kg_m3 == 0.0 || body_radius_m == 0.0) {
    return own;
  }
  // From the body's middle to that of the cylinder, from there square to the fin, and back along the fin.
  const double outer_rad = std::acos(radius_m / (radius_m + body_radius_m));
  const double inner_rad = std::asin(radius_m / (radius_m + body_radius_m));
  const double corner_m2 =
      0.5 * (radius_m * radius_m * (std::tan(outer_rad) - outer_rad) - body_radius_m * body_radius_m * inner_rad);
  return together(own, {.name = {},
                        .mass_kg = set.count * 2.0 * corner_m2 * set.root_chord_m * density_kg_m3,
                        .position_m = 0.5 * set.root_chord_m,
                        .length_m = set.root_chord_m,
                        .radius_of_gyration_m = body_radius_m});
}

}  // namespace

bool is_fin_set(const Component& component) {
  const std::string kind = component.kind();
  return kind == "trapezoidfinset" || kind == "ellipticalfinset" || kind == "freeformfinset";
}

FoundFins read_fins(const Component& component, double body_radius_m, std::vector<std::string>& assumed) {
  FoundFins found{.name = component.name(), .set = {}, .mass = {}};
  Geometry::FinSet& set = found.set;
  set.count = static_cast<int>(component.number(component.has("instancecount") ? "instancecount" : "fincount", 1, 8));
  set.thickness_m = component.number("thickness", 1e-5, 0.2);
  const char* turned = component.has("angleoffset") ? "angleoffset" : "rotation";
  found.first_angle_rad = component.number_or(turned, -3600.0, 3600.0, 0.0) * std::numbers::pi / 180.0;
  set.cant_rad = component.number_or("cant", -45.0, 45.0, 0.0) * std::numbers::pi / 180.0;
  const char* shape = "";
  if (component.kind() == "trapezoidfinset") {
    set.root_chord_m = component.number("rootchord", 0.001, 5);
    set.tip_chord_m = component.number("tipchord", 0, 5);
    set.sweep_m = component.number("sweeplength", -2, 5);
    set.span_m = component.number("height", 0.001, 2);
  } else if (component.kind() == "ellipticalfinset") {
    set.root_chord_m = component.number("rootchord", 0.001, 5);
    set.span_m = component.number("height", 0.001, 2);
    make_trapezoid(
        set, {.area_m2 = 0.25 * std::numbers::pi * set.root_chord_m * set.span_m, .middle_m = 0.5 * set.root_chord_m});
    shape = "elliptical";
  } else {
    read_points(component, set);
    shape = "freeform";
  }
  if (*shape != '\0') {
    assumed.push_back(fmt::format("Fins \"{}\": {}; replaced by the trapezoid of the same area, span and middle.",
                                  found.name, shape));
  }
  const Planform form = planform(set);
  const double arm_m = body_radius_m + set.span_m / 3.0 * (set.root_chord_m + 2.0 * set.tip_chord_m) /
                                           (set.root_chord_m + set.tip_chord_m);
  const double half_span_m = set.span_m / std::sqrt(12.0);  // of the strips' distances from the middle one
  found.mass = {.name = found.name,
                .mass_kg = set.count * form.area_m2 * set.thickness_m * component.density() * full_share(component),
                .position_m = form.middle_m,
                .length_m = 0.5 * (set.root_chord_m + set.tip_chord_m),
                .radius_of_gyration_m = std::hypot(arm_m, half_span_m)};
  found.mass = with_fillets(component, set, body_radius_m, with_tabs(component, set, body_radius_m, found.mass));
  return found;
}

}  // namespace fantail::airframe::openrocket
