// SPDX-License-Identifier: MIT
#include "airframe/openrocket/read.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "airframe/model/body.hpp"
#include "airframe/openrocket/document.hpp"
#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/solids.hpp"
#include "text/error.hpp"
#include "text/number.hpp"

namespace fantail::airframe::openrocket {
namespace {

using sim::Geometry;
using NoseShape = Geometry::NoseShape;

constexpr double longest_m = 30.0;
constexpr double widest_m = 1.0;  // radius
constexpr std::array nose_shapes{
    std::pair<std::string_view, NoseShape>{"conical", NoseShape::cone},
    std::pair<std::string_view, NoseShape>{"ogive", NoseShape::ogive},
    std::pair<std::string_view, NoseShape>{"ellipsoid", NoseShape::ellipsoid},
    std::pair<std::string_view, NoseShape>{"parabolic", NoseShape::parabola},
    std::pair<std::string_view, NoseShape>{"haack", NoseShape::haack},
};

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, file.string() + ": " + complaint};
}

double wall_of(const Component& c) {
  return c.text("thickness") == "filled" ? widest_m : c.number("thickness", 0.0, widest_m);
}

void check_version(const std::filesystem::path& file, pugi::xml_node root, Design& design) {
  constexpr double newest_minor = 10.0;
  const std::string version = root.attribute("version").as_string();
  const bool is_version = version.find_first_not_of("0123456789.") == std::string::npos;
  const std::size_t dot = version.find('.');
  const auto major = text::number(version.substr(0, dot));
  const auto minor = text::number(dot == std::string::npos ? "0" : version.substr(dot + 1));
  if (!is_version || !major || !minor || *major != 1.0) {
    refuse(file, fmt::format("has the document version \"{}\"; allowed: 1.0 to 1.{:.0f}", version, newest_minor));
  }
  if (*minor > newest_minor) {
    design.not_used.push_back(
        fmt::format("The document version {} is newer than 1.{:.0f}: what is new in it.", version, newest_minor));
  }
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
  assumed.push_back(fmt::format("Nose \"{}\": its shape parameter is {}; {} is in its place.", c.name(), parameter,
                                shape == NoseShape::cone ? "a cone"
                                : is_haack               ? "von Karman's shape"
                                                         : "the full shape"));
}

/// The radius that a component has where it begins.
std::optional<double> front_radius_m(const Component& c) {
  const char* key = c.kind() == "transition" ? "foreradius" : "radius";
  return c.number_or_auto(key, 0.0, widest_m);
}

}  // namespace

void Reader::add_nose(const Component& c) {
  Geometry& g = design_.geometry;
  const std::string shape = c.text("shape");
  const auto* const found = std::ranges::find(nose_shapes, shape, [](const auto& one) { return one.first; });
  if (found == nose_shapes.end()) {
    design_.assumed.push_back(
        fmt::format("Nose \"{}\": its shape is \"{}\"; an ogive is in its place.", c.name(), shape));
  }
  g.nose_shape = found == nose_shapes.end() ? NoseShape::ogive : found->second;
  if (found != nose_shapes.end()) {
    take_parameter(c, g.nose_shape, design_.assumed);
  }
  g.nose_length_m = c.number("length", 0.005, 10.0);
  const auto radius_m = c.number_or_auto("aftradius", 0.005, widest_m);
  radius_m_ = radius_m ? *radius_m : radius_behind(c, c.xml().next_sibling());
  g.diameter_m = 2.0 * radius_m_;
  const double wall_m = wall_of(c);
  Geometry::Mass own = mass_of({.length_m = g.nose_length_m,
                                .radius_m = [&g](double x_m) { return model::radius_m(g, x_m); },
                                .wall_m = wall_m,
                                .density_kg_m3 = c.density()});
  if (const double shoulder_m = c.number_or("aftshoulderlength", 0.0, 10.0, 0.0); shoulder_m > 0.0) {
    const double outer_m = c.number("aftshoulderradius", 0.0, widest_m);
    own = together(own, mass_of({.begin_m = g.nose_length_m,
                                 .length_m = shoulder_m,
                                 .radius_m = [=](double) { return outer_m; },
                                 .wall_m = c.number_or("aftshoulderthickness", 0.0, widest_m, 0.0),
                                 .density_kg_m3 = c.density()}));
  }
  const Place place{.length_m = g.nose_length_m, .outer_m = radius_m_, .inner_m = std::max(0.0, radius_m_ - wall_m)};
  add_with_children(c, place, own, g.masses);
  end_m_ = g.nose_length_m;
}

void Reader::add_tube(const Component& c) {
  const double length_m = c.number("length", 0.0005, longest_m);
  const double outer_m = front_radius_m(c).value_or(radius_m_);
  const double wall_m = wall_of(c);
  const Place place{
      .begin_m = end_m_, .length_m = length_m, .outer_m = outer_m, .inner_m = std::max(0.0, outer_m - wall_m)};
  note_motor(c, place);
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

void Reader::add_transition(const Component& c, pugi::xml_node behind) {
  const double length_m = c.number("length", 0.001, longest_m);
  const double front_m = front_radius_m(c).value_or(radius_m_);
  const auto aft_radius_m = c.number_or_auto("aftradius", 0.0025, widest_m);
  const double aft_m = aft_radius_m ? *aft_radius_m : radius_behind(c, behind);
  if (c.text("shape") != "conical") {
    design_.assumed.push_back(fmt::format("Transition \"{}\": a cone in the place of its shape.", c.name()));
  }
  std::optional<Geometry::Transition>& known = design_.geometry.transition;
  if (known) {
    design_.not_used.push_back(fmt::format("Transition \"{}\": its force, as it is the second one.", c.name()));
  } else if (front_m != aft_m) {
    known = {.position_m = end_m_, .length_m = length_m, .aft_diameter_m = 2.0 * aft_m};
  }
  const double wall_m = wall_of(c);
  const auto radius = [=](double x_m) { return front_m + (aft_m - front_m) * x_m / length_m; };
  add_with_children(c,
                    {.begin_m = end_m_,
                     .length_m = length_m,
                     .outer_m = std::max(front_m, aft_m),
                     .inner_m = std::max(0.0, std::min(front_m, aft_m) - wall_m)},
                    mass_of({.begin_m = end_m_,
                             .length_m = length_m,
                             .radius_m = radius,
                             .wall_m = wall_m,
                             .density_kg_m3 = c.density()}),
                    design_.geometry.masses);
  end_m_ += length_m;
  radius_m_ = aft_m;
}

double Reader::radius_behind(const Component& c, pugi::xml_node behind) const {
  for (; behind; behind = behind.next_sibling()) {
    if (const auto radius_m = front_radius_m(Component{file_, behind})) {
      return *radius_m;
    }
  }
  c.refuse("its radius is \"auto\", and nothing behind it says one");
}

/// A person may have drawn a set as single fins, each turned to its own side.
void Reader::join_single_fins() {
  const auto alike = [](const Geometry::FinSet& a, const Geometry::FinSet& b) {
    return a.position_m == b.position_m && a.root_chord_m == b.root_chord_m && a.tip_chord_m == b.tip_chord_m &&
           a.span_m == b.span_m && a.sweep_m == b.sweep_m;
  };
  std::vector<std::pair<std::string, Geometry::FinSet>> joined;
  for (const auto& [name, set] : fins_) {
    const auto same = std::ranges::find_if(joined, [&](const auto& one) { return alike(one.second, set); });
    if (set.count == 1 && same != joined.end() && same->second.count < 8) {
      ++same->second.count;
    } else {
      joined.emplace_back(name, set);
    }
  }
  for (const auto& [name, set] : joined) {
    if (set.count == 1) {
      design_.not_used.push_back(fmt::format("Fin \"{}\": its force, as it is alone; only its mass.", name));
    }
  }
  std::erase_if(joined, [](const auto& one) { return one.second.count == 1; });
  fins_ = std::move(joined);
}

void Reader::choose_fins() {
  join_single_fins();
  std::ranges::sort(fins_, {}, [](const auto& one) { return one.second.position_m; });
  Geometry& g = design_.geometry;
  if (!fins_.empty() && fins_.back().second.position_m > 0.5 * g.length_m) {
    g.fins = fins_.back().second;
    fins_.pop_back();
  }
  const auto canards = std::ranges::find_if(fins_, [&](const auto& one) {
    return one.second.count == 4 && one.second.position_m < 0.5 * g.length_m &&
           one.second.position_m >= g.nose_length_m;
  });
  if (canards != fins_.end()) {
    g.canards = canards->second;
    design_.assumed.push_back(fmt::format("Fins \"{}\": taken as the canards.", canards->first));
    fins_.erase(canards);
  }
  for (const auto& [name, set] : fins_) {
    design_.not_used.push_back(fmt::format("Fins \"{}\": their forces; only their mass.", name));
  }
}

/// A stage that was weighed as a whole.
void Reader::scale_to_stage(const Component& stage) {
  if (!stage.has("overridemass")) {
    return;
  }
  Masses& masses = design_.geometry.masses;
  Geometry::Mass nothing;
  apply_overrides(stage, 0.0, nothing, masses);
  if (nothing.mass_kg > 0.0) {
    stage.refuse("overridemass without its components, which has no place; override them, too");
  }
}

void Reader::read(pugi::xml_node stage) {
  for (const pugi::xml_node node : stage.child("subcomponents").children()) {
    const Component c{file_, node};
    const std::string kind = c.kind();
    if (end_m_ == 0.0 && kind != "nosecone") {
      c.refuse("the first component of the stage; allowed: a nose cone");
    }
    if (kind == "nosecone" && end_m_ == 0.0) {
      add_nose(c);
    } else if (kind == "bodytube") {
      add_tube(c);
    } else if (kind == "transition") {
      add_transition(c, node.next_sibling());
    } else {
      design_.not_used.push_back(fmt::format("{} \"{}\": nothing of it was read.", kind, c.name()));
    }
  }
  if (!(end_m_ > design_.geometry.nose_length_m)) {
    refuse(file_, "its first stage has no body tube");
  }
  Geometry& g = design_.geometry;
  g.length_m = end_m_;
  scale_to_stage(Component{file_, stage});
  for (Geometry::Mass& mass : g.masses) {
    // A vehicle's parts lie within the rocket. What stands for a cone or a swept fin may be a little longer than it is.
    mass.position_m = std::clamp(mass.position_m, 0.0, g.length_m);
    mass.length_m = std::min(mass.length_m, 2.0 * std::min(mass.position_m, g.length_m - mass.position_m));
  }
  choose_fins();
}

Design read_design(const std::filesystem::path& file) {
  const std::string text = document_text(file);
  pugi::xml_document document;
  constexpr unsigned how = pugi::parse_default | pugi::parse_doctype;
  if (const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size(), how); !result) {
    refuse(file, fmt::format("is not XML: {} at byte {}", result.description(), result.offset));
  }
  // Its entities would not be replaced in any case.
  if (std::ranges::any_of(document.children(), [](pugi::xml_node node) { return node.type() == pugi::node_doctype; })) {
    refuse(file, "declares a document type or entities, which no design needs");
  }
  const pugi::xml_node root = document.child("openrocket");
  if (!root) {
    refuse(file, "is no design of OpenRocket: its XML has no <openrocket>");
  }
  Design design;
  check_version(file, root, design);
  const pugi::xml_node rocket = root.child("rocket");
  const pugi::xml_node stage = rocket.child("subcomponents").child("stage");
  if (!stage) {
    refuse(file, "has no rocket with a stage");
  }
  design.name = rocket.child("name").text().as_string();
  Reader{file, design}.read(stage);
  for (pugi::xml_node next = stage.next_sibling("stage"); next; next = next.next_sibling("stage")) {
    design.not_used.push_back(
        fmt::format("Stage \"{}\": only the first stage is read.", next.child("name").text().as_string()));
  }
  return design;
}

}  // namespace fantail::airframe::openrocket
