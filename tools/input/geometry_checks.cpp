// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "input/file_checks.hpp"
#include "input/messages.hpp"
#include "input/section.hpp"

namespace fantail::input {
namespace {

constexpr double a_millimetre_m = 0.001;
constexpr Limits any{-1e9, 1e9};  // of what the table of fields has read and checked

std::string at_most(double value, const char* allowed, double limit) {
  return fmt::format("= {}; allowed: at most {}, {}", plain_number(value), allowed, plain_number(limit));
}

/// One whose keys are "transition_length_m", or "lengths_m" of a list.
void check_transition(const Section& section, const std::string& singular, const std::string& of,
                      const sim::Geometry::Transition& transition, double earliest_m, const char* earliest,
                      double rocket_m) {
  const auto key = [&](const char* what) {
    return singular.empty() ? fmt::format("{}s_m", what) : fmt::format("{}_{}_m", singular, what);
  };
  if (!(transition.length_m > 0.0)) {
    section.refuse(key("length"), fmt::format("= 0{}; allowed: above 0", of));
  }
  if (!(transition.aft_diameter_m > 0.0)) {
    section.refuse(key("diameter"), fmt::format("= 0{}; allowed: above 0", of));
  }
  if (transition.position_m < earliest_m - a_millimetre_m) {
    section.refuse(key("position"),
                   fmt::format("= {}{} is too far forwards; allowed: at least {}, {}",
                               plain_number(transition.position_m), of, earliest, plain_number(earliest_m)));
  }
  if (transition.position_m + transition.length_m > rocket_m + a_millimetre_m) {
    section.refuse(key("length"),
                   fmt::format("= {}{}; allowed: at most the distance to the tail, {}",
                               plain_number(transition.length_m), of, plain_number(rocket_m - transition.position_m)));
  }
}

/// All lists of a section are as long as the first; some may be missing.
void check_lengths(Section& section, const char* first, std::size_t count, std::initializer_list<const char*> must,
                   std::initializer_list<const char*> may = {}) {
  std::vector<const char*> keys{must};
  std::ranges::copy_if(may, std::back_inserter(keys), [&](const char* key) { return section.has(key); });
  for (const char* key : keys) {
    if (const std::size_t given = section.numbers(key, any, 100).size(); given != count) {
      section.refuse(key, fmt::format("has {} numbers; allowed: as many as {}, {}", given, first, count));
    }
  }
}

void check_more_transitions(const Document& document, const sim::Geometry& shape) {
  Section section{document, "more_transitions"};
  if (!section.is_there()) {
    return;
  }
  check_lengths(section, "positions_m", section.numbers("positions_m", any, 100).size(), {"lengths_m", "diameters_m"});
  for (std::size_t i = 1; i < shape.transitions.size(); ++i) {
    const sim::Geometry::Transition& before = shape.transitions[i - 1];
    check_transition(section, "", fmt::format(" (number {})", i), shape.transitions[i],
                     before.position_m + before.length_m, "the end of the one before", shape.length_m);
  }
}

void check_more_fins(const Document& document, const sim::Geometry& shape) {
  Section section{document, "more_fins"};
  if (!section.is_there()) {
    return;
  }
  check_lengths(section, "names", section.texts("names", 100).size(),
                {"counts", "positions_m", "root_chords_m", "tip_chords_m", "spans_m"},
                {"first_angles_deg", "sweeps_m", "cants_deg"});
  for (const auto& [name, first_angle_rad, set] : shape.more_fins) {
    if (set.position_m + set.root_chord_m > shape.length_m + a_millimetre_m) {
      section.refuse("positions_m",
                     fmt::format("= {} for \"{}\" puts the end of the root chord behind the tail; allowed: at most {}",
                                 plain_number(set.position_m), name, plain_number(shape.length_m - set.root_chord_m)));
    }
  }
}

void check_body(const Document& document, const sim::Geometry& shape) {
  Section section{document, "shape"};
  if (!(shape.diameter_m < shape.length_m)) {
    section.refuse("diameter_m", fmt::format("= {}; allowed: less than length_m = {}", plain_number(shape.diameter_m),
                                             plain_number(shape.length_m)));
  }
  if (shape.nose_length_m > shape.length_m) {
    section.refuse("nose_length_m", at_most(shape.nose_length_m, "length_m", shape.length_m));
  }
  if (shape.transitions.empty()) {
    return;
  }
  for (const char* key : {"transition_position_m", "transition_length_m", "transition_diameter_m"}) {
    if (!section.has(key)) {
      section.refuse(key,
                     "is missing; a transition needs transition_position_m, transition_length_m and "
                     "transition_diameter_m");
    }
  }
  check_transition(section, "transition", "", shape.transitions.front(), shape.nose_length_m, "shape.nose_length_m",
                   shape.length_m);
  check_more_transitions(document, shape);
}

void check_fins(const Document& document, const char* name, const sim::Geometry::FinSet& fins,
                const sim::Geometry& shape) {
  const Section section{document, name};
  if (fins.position_m < shape.nose_length_m) {
    section.refuse("position_m", fmt::format("= {} is on the nose; allowed: at least shape.nose_length_m = {}",
                                             plain_number(fins.position_m), plain_number(shape.nose_length_m)));
  }
  if (fins.position_m + fins.root_chord_m > shape.length_m + a_millimetre_m) {
    section.refuse("position_m",
                   fmt::format("= {} puts the end of the root chord behind the tail; allowed: at most {}",
                               plain_number(fins.position_m), plain_number(shape.length_m - fins.root_chord_m)));
  }
  if (fins.thickness_m > fins.root_chord_m) {
    section.refuse("thickness_m", at_most(fins.thickness_m, "root_chord_m", fins.root_chord_m));
  }
}

/// Of the body between two places; on the nose that of its base.
double largest_radius_m(const sim::Geometry& shape, double begin_m, double end_m) {
  double largest_m = 0.0;
  double here_m = 0.5 * shape.diameter_m;  // between the transitions that come before and behind it
  double from_m = 0.0;
  for (const sim::Geometry::Transition& transition : shape.transitions) {
    if (begin_m <= transition.position_m + transition.length_m && end_m >= from_m) {
      largest_m = std::max(largest_m, here_m);
    }
    here_m = 0.5 * transition.aft_diameter_m;
    from_m = transition.position_m;
  }
  return end_m >= from_m ? std::max(largest_m, here_m) : largest_m;
}

// No part has a larger radius of gyration than its outermost point. Any may be fins; a design that was read has more of
// them than [fins] and [canard_fins] say.
void check_radius(const Section& section, const sim::Geometry& shape, const sim::Geometry::Mass& mass) {
  if ((!shape.fins && !shape.canards) || shape.design) {
    return;
  }
  const double body_m =
      largest_radius_m(shape, mass.position_m - 0.5 * mass.length_m, mass.position_m + 0.5 * mass.length_m);
  double span_m = std::max(shape.fins ? shape.fins->span_m : 0.0, shape.canards ? shape.canards->span_m : 0.0);
  for (const sim::Geometry::MoreFins& more : shape.more_fins) {
    span_m = std::max(span_m, more.set.span_m);
  }
  if (mass.radius_of_gyration_m > body_m + span_m + a_millimetre_m) {
    section.refuse("radii_of_gyration_m", fmt::format("= {} for \"{}\"; allowed: at most {}, the radius of the body "
                                                      "there, {}, plus the longest span of fins or canards",
                                                      plain_number(mass.radius_of_gyration_m), mass.name,
                                                      plain_number(body_m + span_m), plain_number(body_m)));
  }
}

/// A retainer or the end of a motor may be behind the tail by a diameter.
void check_place(const Section& section, const char* key, const std::string& what, const sim::Geometry::Mass& mass,
                 const sim::Geometry& shape) {
  const double end_m = shape.length_m + shape.diameter_m;
  if (mass.position_m - 0.5 * mass.length_m < -a_millimetre_m ||
      mass.position_m + 0.5 * mass.length_m > end_m + a_millimetre_m) {
    section.refuse(key, fmt::format("= {} for {}, {} m long, reaches out of the rocket; allowed: a position that keeps "
                                    "it within 0 and {}, a diameter behind shape.length_m = {}",
                                    plain_number(mass.position_m), what, plain_number(mass.length_m),
                                    plain_number(end_m), plain_number(shape.length_m)));
  }
}

void check_propellant(Section& section, const sim::Geometry& shape) {
  const sim::Geometry::Mass& propellant = *shape.propellant;
  for (const char* key : {"propellant_position_m", "propellant_length_m", "propellant_radius_of_gyration_m"}) {
    if (!section.has(key)) {
      section.refuse(key, "is missing; the propellant needs position, length and radius of gyration");
    }
  }
  check_place(section, "propellant_position_m", "the propellant", propellant, shape);
  const double body_m = largest_radius_m(shape, propellant.position_m - 0.5 * propellant.length_m,
                                         propellant.position_m + 0.5 * propellant.length_m);
  if (propellant.radius_of_gyration_m > body_m + a_millimetre_m) {
    section.refuse("propellant_radius_of_gyration_m",
                   at_most(propellant.radius_of_gyration_m, "the radius of the body there", body_m));
  }
}

void check_masses(const Document& document, const sim::Geometry& shape) {
  Section section{document, "masses"};
  const std::size_t count = shape.masses.size();
  if (section.texts("names", 100).size() != count) {
    section.refuse("names", fmt::format("has {} names, and {} masses are described; allowed: one per mass",
                                        section.texts("names", 100).size(), count));
  }
  for (const char* key : {"masses_kg", "positions_m"}) {
    if (const std::size_t given = section.numbers(key, any, 100).size(); given != count) {
      section.refuse(key, fmt::format("has {} numbers; allowed: as many as names, {}", given, count));
    }
  }
  for (const char* key : {"lengths_m", "radii_of_gyration_m"}) {
    const std::size_t given = section.numbers(key, any, 100).size();
    if (given != count && given != 0) {
      section.refuse(key, fmt::format("has {} numbers; allowed: as many as names, {}, or none", given, count));
    }
  }
  for (const sim::Geometry::Mass& mass : shape.masses) {
    check_place(section, "positions_m", '"' + mass.name + '"', mass, shape);
    check_radius(section, shape, mass);
  }
  if (shape.propellant) {
    check_propellant(section, shape);
  }
}

}  // namespace

void check_geometry(const Document& document, const sim::Vehicle& vehicle) {
  if (!vehicle.geometry) {
    return;
  }
  const sim::Geometry& shape = *vehicle.geometry;
  if (!Section{document, "shape"}.is_there()) {
    for (const auto& [name, key] :
         {std::pair{"fins", "position_m"}, std::pair{"canard_fins", "position_m"}, std::pair{"more_fins", "names"},
          std::pair{"more_transitions", "positions_m"}, std::pair{"masses", "names"}, std::pair{"design", "file"}}) {
      if (const Section section{document, name}; section.is_there()) {
        section.refuse(key, "needs the section [shape], which gives the rocket's length and diameter");
      }
    }
  }
  check_body(document, shape);
  if (shape.fins) {
    check_fins(document, "fins", *shape.fins, shape);
  }
  if (shape.canards) {
    check_fins(document, "canard_fins", *shape.canards, shape);
    if (shape.canard_hinge_m.value_or(0.0) > shape.canards->root_chord_m) {
      Section{document, "canard_fins"}.refuse(
          "hinge_m", at_most(*shape.canard_hinge_m, "root_chord_m", shape.canards->root_chord_m));
    }
  }
  if (shape.fins && shape.canards && shape.canards->position_m + shape.canards->root_chord_m > shape.fins->position_m &&
      shape.canards->position_m < shape.fins->position_m + shape.fins->root_chord_m) {
    Section{document, "canard_fins"}.refuse(
        "position_m",
        fmt::format("= {}: their roots overlap those of the fins; allowed: in front of or behind {} to {} m",
                    plain_number(shape.canards->position_m), plain_number(shape.fins->position_m),
                    plain_number(shape.fins->position_m + shape.fins->root_chord_m)));
  }
  check_more_fins(document, shape);
  check_masses(document, shape);
  if (Section design{document, "design"}; design.is_there() && !design.has("file")) {
    design.refuse("file", "is missing; the section describes a design file");
  }
}

}  // namespace fantail::input
