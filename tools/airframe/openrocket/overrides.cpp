// SPDX-License-Identifier: MIT
// What a person has weighed and written over what the parts weigh by their sizes.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/core.h>

#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/solids.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;

/// Up to document version 1.8 one tag is for all overrides of a component, later each override has its own.
bool is_of_all(const Component& c, const char* key) {
  return c.flag(c.has(key) ? key : "overridesubcomponents").value_or(false);
}

double sum_kg(const Geometry::Mass& own, const std::vector<Geometry::Mass>& children) {
  double sum = own.mass_kg;
  std::ranges::for_each(children, [&](const Geometry::Mass& child) { sum += child.mass_kg; });
  return sum;
}

}  // namespace

Overrides overrides_of(const Component& c, double begin_m) {
  Overrides found;
  if (c.has("overridemass")) {
    found.mass_kg = c.number("overridemass", 0.0, heaviest_kg);
    found.mass_is_of_all = is_of_all(c, "overridesubcomponentsmass");
  }
  if (c.has("overridecg")) {
    found.centre_m = begin_m + c.number("overridecg", -longest_m, longest_m);
    found.centre_is_of_all = is_of_all(c, "overridesubcomponentscg");
  }
  return found;
}

void Reader::apply_overrides(const Component& c, const Overrides& o, Geometry::Mass& own, Masses& children) {
  if (c.has("overridecd")) {
    design_.not_used.push_back(fmt::format("{} \"{}\": its drag coefficient; drag is not read.", c.kind(), c.name()));
  }
  if (o.mass_kg && o.centre_m && o.mass_is_of_all != o.centre_is_of_all && sum_kg({}, children) > 0.0) {
    c.refuse(
        "overrides mass or centre of gravity with the parts inside it, and the other without them. Versions of "
        "OpenRocket read that differently. Override both with them, or both without");
  }
  const double sum = sum_kg(own, children);
  if (o.mass_kg && o.mass_is_of_all && !o.centre_m && sum > 0.0) {
    Geometry::Mass whole = own;
    std::ranges::for_each(children, [&](const Geometry::Mass& child) { whole = together(whole, child); });
    if (own.mass_kg > 0.0 && std::abs(whole.position_m - own.position_m) > a_millimetre_m) {
      design_.left_out.push_back(
          {.what = fmt::format("{} \"{}\": its mass is overridden with the parts inside, but not its centre of "
                               "gravity. Versions of OpenRocket put that at {:.3f} or {:.3f} m (taken: the first)",
                               c.kind(), c.name(), whole.position_m, own.position_m)});
    }
    own.mass_kg *= *o.mass_kg / sum;
    std::ranges::for_each(children, [&](Geometry::Mass& child) { child.mass_kg *= *o.mass_kg / sum; });
  } else if ((o.mass_kg && o.mass_is_of_all) || (o.centre_m && o.centre_is_of_all)) {
    const std::string name = own.name;
    std::ranges::for_each(children, [&](const Geometry::Mass& child) { own = together(own, child); });
    children.clear();
    own.name = name;
    own.mass_kg = o.mass_kg.value_or(own.mass_kg);
    own.position_m = o.centre_m.value_or(own.position_m);
  } else {
    own.mass_kg = o.mass_kg.value_or(own.mass_kg);
    own.position_m = o.centre_m.value_or(own.position_m);
  }
}

/// A stage, or a rocket of one stage, that was weighed as a whole. It has no mass of its own.
void Reader::weigh_whole(const Component& c) {
  const Overrides o = overrides_of(c, 0.0);
  if ((o.mass_kg && !o.mass_is_of_all) || (o.centre_m && !o.centre_is_of_all)) {
    c.refuse("overrides mass or centre of gravity without its components, and has none of its own; override with them");
  }
  Geometry::Mass whole{.name = c.name()};
  apply_overrides(c, o, whole, design_.geometry.masses);
  if (!(whole.mass_kg > 0.0)) {
    return;
  }
  if (!o.centre_m) {
    c.refuse("overrides the mass of parts that weigh nothing, so it has no place; override the centre of gravity, too");
  }
  design_.geometry.masses.push_back(whole);
  if (o.mass_kg) {
    std::erase_if(design_.left_out, [](const LeftOut& one) { return !one.is_force; });
  }
}

}  // namespace fantail::airframe::openrocket
