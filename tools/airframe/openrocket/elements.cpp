// SPDX-License-Identifier: MIT
// What the components of a design consist of: read, or known to change neither shape nor mass. Nothing else leaves
// without a word.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <fmt/core.h>

#include "airframe/openrocket/reader.hpp"

namespace fantail::airframe::openrocket {
namespace {

using Names = std::span<const std::string_view>;

/// Of any component. Colours and events change nothing here; drag is told of where it is overridden.
constexpr std::array<std::string_view, 36> of_all{"name",
                                                  "id",
                                                  "comment",
                                                  "preset",
                                                  "color",
                                                  "linestyle",
                                                  "appearance",
                                                  "insideappearance",
                                                  "finish",
                                                  "material",
                                                  "subcomponents",
                                                  "position",
                                                  "axialoffset",
                                                  "length",
                                                  "thickness",
                                                  "overridemass",
                                                  "overridecg",
                                                  "overridecd",
                                                  "overridesubcomponents",
                                                  "overridesubcomponentsmass",
                                                  "overridesubcomponentscg",
                                                  "overridesubcomponentscd",
                                                  "radialposition",
                                                  "radialdirection",
                                                  "instancecount",
                                                  "instanceseparation",
                                                  "motormount",
                                                  "radius",
                                                  "angleoffset",
                                                  "rotation",
                                                  "radiusoffset",
                                                  "deployevent",
                                                  "deployaltitude",
                                                  "deploydelay",
                                                  "deploymentconfiguration",
                                                  "decalimage"};
constexpr std::array<std::string_view, 14> of_outlines{"shape",
                                                       "shapeparameter",
                                                       "shapeclipped",
                                                       "aftradius",
                                                       "aftshoulderradius",
                                                       "aftshoulderlength",
                                                       "aftshoulderthickness",
                                                       "aftshouldercapped",
                                                       "foreradius",
                                                       "foreshoulderradius",
                                                       "foreshoulderlength",
                                                       "foreshoulderthickness",
                                                       "foreshouldercapped",
                                                       "isflipped"};
constexpr std::array<std::string_view, 13> of_fins{
    "fincount",  "crosssection", "cant",      "rootchord",   "tipchord",     "sweeplength",   "height",
    "finpoints", "tabheight",    "tablength", "tabposition", "filletradius", "filletmaterial"};
constexpr std::array<std::string_view, 5> of_rings{"outerradius", "innerradius", "clusterconfiguration", "clusterscale",
                                                   "clusterrotation"};
constexpr std::array<std::string_view, 12> of_packed{"packedlength", "packedradius", "mass",        "masscomponenttype",
                                                     "cd",           "diameter",     "linecount",   "linelength",
                                                     "linematerial", "cordlength",   "striplength", "stripwidth"};
constexpr std::array<std::string_view, 6> of_buttons{"outerdiameter", "innerdiameter", "height",
                                                     "baseheight",    "flangeheight",  "screwheight"};

struct Kind {
  std::string_view name;
  Names own;
};
constexpr std::array<Kind, 17> kinds{{
    {"nosecone", of_outlines},
    {"bodytube", {}},
    {"transition", of_outlines},
    {"trapezoidfinset", of_fins},
    {"ellipticalfinset", of_fins},
    {"freeformfinset", of_fins},
    {"innertube", of_rings},
    {"tubecoupler", of_rings},
    {"engineblock", of_rings},
    {"centeringring", of_rings},
    {"bulkhead", of_rings},
    {"launchlug", {}},
    {"railbutton", of_buttons},
    {"masscomponent", of_packed},
    {"parachute", of_packed},
    {"streamer", of_packed},
    {"shockcord", of_packed},
}};

bool has(Names names, std::string_view name) { return std::ranges::find(names, name) != names.end(); }

}  // namespace

void Reader::note_unknown(const Component& c) {
  const std::string name = c.kind();
  const auto* const kind = std::ranges::find(kinds, name, &Kind::name);
  if (kind == kinds.end()) {
    return;  // a part that is left out as a whole, with a word of its own
  }
  for (const pugi::xml_node element : c.xml().children()) {
    if (element.type() == pugi::node_element && !has(of_all, element.name()) && !has(kind->own, element.name())) {
      leave_out(c, fmt::format("<{}>, whose meaning is not known here", element.name()), true);
    }
  }
}

}  // namespace fantail::airframe::openrocket
