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
#include "airframe/openrocket/stored_flight.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

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

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, file.string() + ": " + complaint};
}

/// Zeros are halves of letters in UTF-16, and nothing in XML otherwise.
bool is_utf_8_or_16(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const bool is_ascii = static_cast<unsigned char>(text[i]) < 0x80;
    const std::size_t length = is_ascii ? 1 : text::printable_character(text.substr(i));
    if (length == 0) {
      return text.find('\0') != std::string_view::npos;
    }
    i += length;
  }
  return true;
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
        fmt::format("The document version {} is newer than 1.{:.0f}: its new features.", version, newest_minor));
    design.left_out.push_back(
        {.what = fmt::format("the new features of document version {}", version), .is_force = true});
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
    design_.assumed.push_back(fmt::format("Transition \"{}\": a cone is used instead of its shape.", c.name()));
  }
  for (const char* shoulder : {"foreshoulderlength", "aftshoulderlength"}) {
    if (c.number_or(shoulder, 0.0, longest_m, 0.0) > 0.0) {
      design_.left_out.push_back({.what = fmt::format("transition \"{}\": the mass of its shoulders", c.name())});
      break;
    }
  }
  std::optional<Geometry::Transition>& known = design_.geometry.transition;
  if (known) {
    design_.not_used.push_back(fmt::format("Transition \"{}\": its force, because it is the second one.", c.name()));
    design_.left_out.push_back({.what = fmt::format("transition \"{}\": its force", c.name()), .is_force = true});
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
  c.refuse("its radius is \"auto\", and no part behind it states one");
}

void Reader::read(pugi::xml_node rocket) {
  const pugi::xml_node stage = rocket.child("subcomponents").child("stage");
  const pugi::xml_node second = stage.next_sibling("stage");
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
      design_.not_used.push_back(fmt::format("{} \"{}\": the whole part.", kind, c.name()));
      design_.left_out.push_back({.what = fmt::format("{} \"{}\": not read", kind, c.name()), .is_force = true});
    }
  }
  if (!(end_m_ > design_.geometry.nose_length_m)) {
    refuse(file_, "its first stage has no body tube");
  }
  Geometry& g = design_.geometry;
  g.length_m = end_m_;
  weigh_whole(Component{file_, stage});
  const Component whole{file_, rocket};
  if (!second) {
    weigh_whole(whole);
  } else if (whole.has("overridemass") || whole.has("overridecg")) {
    whole.refuse("overrides the mass or centre of gravity of all stages, and only the first is read");
  }
  check_places();
  choose_fins();
}

Design read_design(const std::filesystem::path& file) {
  const std::string text = document_text(file);
  pugi::xml_document document;
  constexpr unsigned how = pugi::parse_default | pugi::parse_doctype;
  const bool is_latin = !is_utf_8_or_16(text);
  if (const pugi::xml_parse_result result =
          document.load_buffer(text.data(), text.size(), how, is_latin ? pugi::encoding_latin1 : pugi::encoding_auto);
      !result) {
    refuse(file, fmt::format("is not XML: {} at byte {}", result.description(), result.offset));
  }
  // Its entities would not be replaced in any case.
  if (std::ranges::any_of(document.children(), [](pugi::xml_node node) { return node.type() == pugi::node_doctype; })) {
    refuse(file, "declares a document type or entities, which no design needs");
  }
  const pugi::xml_node root = document.child("openrocket");
  if (!root) {
    refuse(file, "is not an OpenRocket design: its XML has no <openrocket>");
  }
  Design design;
  if (is_latin) {
    design.assumed.emplace_back("Text of the design: read as Latin-1, because it is not UTF-8.");
  }
  check_version(file, root, design);
  const pugi::xml_node rocket = root.child("rocket");
  const pugi::xml_node stage = rocket.child("subcomponents").child("stage");
  if (!stage) {
    refuse(file, "has no rocket with a stage");
  }
  design.name = rocket.child("name").text().as_string();
  Reader{file, design}.read(rocket);
  for (pugi::xml_node next = stage.next_sibling("stage"); next; next = next.next_sibling("stage")) {
    design.not_used.push_back(
        fmt::format("Stage \"{}\": only the first stage is read.", next.child("name").text().as_string()));
    design.left_out.push_back(
        {.what = fmt::format("stage \"{}\": not read", next.child("name").text().as_string()), .is_force = true});
  }
  design.flights = stored_flights(root.child("simulations"), design.not_used);
  return design;
}

}  // namespace fantail::airframe::openrocket
