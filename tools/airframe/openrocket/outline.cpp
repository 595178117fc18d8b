// SPDX-License-Identifier: MIT
// The body of a rocket, one part behind the other: what stands in the air, and what it weighs.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "airframe/model/body.hpp"
#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/solids.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;
using NoseShape = Geometry::NoseShape;

constexpr std::array nose_shapes{
    std::pair<std::string_view, NoseShape>{"conical", NoseShape::cone},
    std::pair<std::string_view, NoseShape>{"ogive", NoseShape::ogive},
    std::pair<std::string_view, NoseShape>{"ellipsoid", NoseShape::ellipsoid},
    std::pair<std::string_view, NoseShape>{"parabolic", NoseShape::parabola},
    std::pair<std::string_view, NoseShape>{"haack", NoseShape::haack},
};

double wall_of(const Component& c) {
  return c.text("thickness") == "filled" ? widest_m : c.number("thickness", 0.0, widest_m);
}

/// Between two shapes: an ogive or parabola of parameter 0 is a cone, and of 1 it meets the body without an edge; a
/// Haack body of 0 is von Karman's.
void take_parameter(const Component& c, NoseShape& shape, std::vector<std::string>& assumed) {
  const bool is_haack = shape == NoseShape::haack;
  const double usual = is_haack ? 0.0 : 1.0;
  const double parameter = c.number_or("shapeparameter", 0.0, 1.0, usual);
  if (parameter == usual || (!is_haack && shape != NoseShape::ogive && shape != NoseShape::parabola)) {
    return;
  }
  if (!is_haack && parameter < 0.5) {
    shape = NoseShape::cone;
    if (parameter == 0.0) {
      return;
    }
  }
  assumed.push_back(fmt::format("Nose \"{}\": its shape parameter is {}; {} is used instead.", c.name(), parameter,
                                shape == NoseShape::cone ? "a cone"
                                : is_haack               ? "von Karman's shape"
                                                         : "the full shape"));
}

/// The radius that a component has where it begins.
std::optional<double> front_radius_m(const Component& c) {
  const char* key = c.kind() == "transition" ? "foreradius" : "radius";
  return c.number_or_auto(key, 0.0, widest_m);
}

/// The tube at an end of nose or transition that goes into the part beside it, with its lid. `end` is "fore" or "aft";
/// it reaches from `at_m` forwards or backwards.
Geometry::Mass with_shoulder(const Component& c, const std::string& end, double at_m, bool forwards,
                             const Geometry::Mass& own) {
  const std::string key = end + "shoulder";
  const double length_m = c.number_or((key + "length").c_str(), 0.0, longest_m, 0.0);
  if (length_m == 0.0) {
    return own;
  }
  const double outer_m = c.number((key + "radius").c_str(), 0.0, widest_m);
  const double wall_m = c.number_or((key + "thickness").c_str(), 0.0, widest_m, 0.0);
  const auto radius = [=](double) { return outer_m; };
  Geometry::Mass all = together(own, mass_of({.begin_m = forwards ? at_m - length_m : at_m,
                                              .length_m = length_m,
                                              .radius_m = radius,
                                              .wall_m = wall_m,
                                              .density_kg_m3 = c.density()}));
  if (c.flag((key + "capped").c_str()).value_or(false) && wall_m < outer_m) {
    all = together(all, mass_of({.begin_m = forwards ? at_m - length_m : at_m + length_m - wall_m,
                                 .length_m = wall_m,
                                 .radius_m = [=](double) { return outer_m - wall_m; },
                                 .wall_m = outer_m,
                                 .density_kg_m3 = c.density()}));
  }
  return all;
}

}  // namespace

void Reader::add_nose(const Component& c) {
  Geometry& g = design_.geometry;
  const std::string shape = c.text("shape");
  const auto* const found = std::ranges::find(nose_shapes, shape, [](const auto& one) { return one.first; });
  if (found == nose_shapes.end()) {
    design_.assumed.push_back(
        fmt::format("Nose \"{}\": its shape is \"{}\"; an ogive is used instead.", c.name(), shape));
  }
  g.nose_shape = found == nose_shapes.end() ? NoseShape::ogive : found->second;
  if (found != nose_shapes.end()) {
    take_parameter(c, g.nose_shape, design_.assumed);
  }
  g.nose_length_m = c.number("length", 0.005, 10.0);
  const auto radius_m = c.number_or_auto("aftradius", 0.0005, widest_m);
  radius_m_ = radius_m ? *radius_m : radius_behind(c, c.xml().next_sibling());
  g.diameter_m = 2.0 * radius_m_;
  const double wall_m = wall_of(c);
  const Geometry::Mass own = mass_of({.length_m = g.nose_length_m,
                                      .radius_m = [&g](double x_m) { return model::radius_m(g, x_m); },
                                      .wall_m = wall_m,
                                      .density_kg_m3 = c.density()});
  const Place place{.length_m = g.nose_length_m, .outer_m = radius_m_, .inner_m = std::max(0.0, radius_m_ - wall_m)};
  add_with_children(c, place, with_shoulder(c, "aft", g.nose_length_m, false, own), g.masses);
  end_m_ = g.nose_length_m;
}

void Reader::add_tube(const Component& c) {
  const double length_m = c.number("length", 0.0005, longest_m);
  const double outer_m = front_radius_m(c).value_or(radius_m_);
  step_to(c, outer_m);
  const double wall_m = wall_of(c);
  const Place place{
      .begin_m = end_m_, .length_m = length_m, .outer_m = outer_m, .inner_m = std::max(0.0, outer_m - wall_m)};
  note_motor(c, place, {});
  add_with_children(c, place,
                    mass_of({.begin_m = end_m_,
                             .length_m = length_m,
                             .radius_m = [=](double) { return outer_m; },
                             .wall_m = wall_m,
                             .density_kg_m3 = c.density()}),
                    design_.geometry.masses);
  end_m_ += length_m;
  radius_m_ = outer_m;
}

/// Where one part ends with another radius than the next begins with, the change counts as one over a millimetre.
void Reader::step_to(const Component& c, double radius_m) {
  constexpr double worth_a_word = 0.02;
  if (std::abs(radius_m - radius_m_) > worth_a_word * radius_m_) {
    design_.assumed.push_back(
        fmt::format("{} \"{}\": it begins with a diameter of {:.4g} mm where {:.4g} mm end; the step is taken for a "
                    "cone of a millimetre.",
                    c.kind(), c.name(), 2e3 * radius_m, 2e3 * radius_m_));
  }
  if (radius_m != radius_m_) {
    design_.geometry.transitions.push_back(
        {.position_m = end_m_, .length_m = 0.5 * a_millimetre_m, .aft_diameter_m = 2.0 * radius_m});
  }
  radius_m_ = radius_m;
}

void Reader::add_transition(const Component& c, pugi::xml_node behind) {
  const bool is_tail_nose = c.kind() == "nosecone";  // turned around: its base is in front
  const double length_m = c.number("length", 0.001, longest_m);
  const double front_m =
      (is_tail_nose ? c.number_or_auto("aftradius", 0.0, widest_m) : front_radius_m(c)).value_or(radius_m_);
  const auto aft_radius_m = is_tail_nose ? std::optional{0.0} : c.number_or_auto("aftradius", 0.0, widest_m);
  const double aft_m = aft_radius_m ? *aft_radius_m : radius_behind(c, behind);
  if (c.text("shape") != "conical") {
    design_.assumed.push_back(
        fmt::format("{} \"{}\": a cone is used instead of its shape.", is_tail_nose ? "Nose" : "Transition", c.name()));
  }
  step_to(c, front_m);
  if (front_m != aft_m) {
    design_.geometry.transitions.push_back(
        {.position_m = end_m_, .length_m = length_m, .aft_diameter_m = 2.0 * std::max(aft_m, 0.5 * a_millimetre_m)});
  }
  const double wall_m = wall_of(c);
  const auto radius = [=](double x_m) { return front_m + (aft_m - front_m) * x_m / length_m; };
  Geometry::Mass own = mass_of(
      {.begin_m = end_m_, .length_m = length_m, .radius_m = radius, .wall_m = wall_m, .density_kg_m3 = c.density()});
  own = is_tail_nose ? with_shoulder(c, "aft", end_m_, true, own)
                     : with_shoulder(c, "aft", end_m_ + length_m, false, with_shoulder(c, "fore", end_m_, true, own));
  add_with_children(c,
                    {.begin_m = end_m_,
                     .length_m = length_m,
                     .outer_m = std::max(front_m, aft_m),
                     .inner_m = std::max(0.0, std::min(front_m, aft_m) - wall_m)},
                    own, design_.geometry.masses);
  end_m_ += length_m;
  radius_m_ = std::max(aft_m, 0.5 * a_millimetre_m);
}

double Reader::radius_behind(const Component& c, pugi::xml_node behind) const {
  for (; behind; behind = behind.next_sibling()) {
    if (const auto radius_m = front_radius_m(Component{file_, behind})) {
      return *radius_m;
    }
  }
  c.refuse("its radius is \"auto\", and no part behind it states one");
}

}  // namespace fantail::airframe::openrocket
