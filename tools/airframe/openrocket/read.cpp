// SPDX-License-Identifier: MIT
#include "airframe/openrocket/read.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "airframe/openrocket/document.hpp"
#include "airframe/openrocket/reader.hpp"
#include "airframe/openrocket/stored_flight.hpp"
#include "text/error.hpp"
#include "text/number.hpp"
#include "text/quoting.hpp"

namespace fantail::airframe::openrocket {
namespace {

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

}  // namespace

void Reader::leave_out(const Component& c, const std::string& what, bool is_force) {
  design_.left_out.push_back({.what = fmt::format("{} \"{}\": {}", c.kind(), c.name(), what), .is_force = is_force});
}

/// A motor in a later stage lifts the first one as a load.
void refuse_load(const std::filesystem::path& file, pugi::xml_node stage) {
  const auto has_mount = [](pugi::xml_node node) { return !node.select_node(".//motormount").node().empty(); };
  if (has_mount(stage)) {
    return;
  }
  for (pugi::xml_node next = stage.next_sibling("stage"); next; next = next.next_sibling("stage")) {
    if (has_mount(next)) {
      const auto name = [](pugi::xml_node node) { return node.child("name").text().as_string(); };
      refuse(file, fmt::format("its first stage \"{}\" has no motor mount, and the stage \"{}\" has. Only the first "
                               "stage is read: move the parts of both into one stage in OpenRocket, and save",
                               name(stage), name(next)));
    }
  }
}

void Reader::read(pugi::xml_node rocket) {
  const pugi::xml_node stage = rocket.child("subcomponents").child("stage");
  const pugi::xml_node second = stage.next_sibling("stage");
  refuse_load(file_, stage);
  for (const pugi::xml_node node : stage.child("subcomponents").children()) {
    const Component c{file_, node};
    const std::string kind = c.kind();
    if (end_m_ == 0.0 && kind != "nosecone") {
      c.refuse("the first component of the stage; allowed: a nose cone");
    }
    note_unknown(c);
    if (kind == "nosecone" && end_m_ == 0.0) {
      add_nose(c);
    } else if (kind == "bodytube") {
      add_tube(c);
    } else if (kind == "transition" || (kind == "nosecone" && c.flag("isflipped").value_or(false))) {
      add_transition(c, node.next_sibling());
    } else {
      design_.not_used.push_back(fmt::format("{} \"{}\": the whole part.", kind, c.name()));
      leave_out(c, "not read", true);
    }
  }
  sim::Geometry& g = design_.geometry;
  if (!(end_m_ > g.nose_length_m)) {
    refuse(file_, "its first stage has no body tube");
  }
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

Design read_design(const std::filesystem::path& file, const std::string& canards) {
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
  Reader{file, canards, design}.read(rocket);
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
