// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <stdexcept>
#include <string>

#include "airframe/openrocket/read.hpp"

namespace fantail::airframe::openrocket {

inline constexpr double pi = std::numbers::pi;

inline const std::string nose =
    "<nosecone><name>Nose</name><material type='bulk' density='1000'>x</material><length>0.3</length>"
    "<thickness>filled</thickness><shape>conical</shape><aftradius>auto 0.05</aftradius></nosecone>";

inline std::string tube(const std::string& inside, const std::string& more = "") {
  return "<bodytube><name>Tube</name><material type='bulk' density='800'>x</material><length>1.2</length>"
         "<thickness>0.002</thickness><radius>0.05</radius>" +
         more + "<subcomponents>" + inside + "</subcomponents></bodytube>";
}

inline std::string fins(const std::string& name, int count, const std::string& offset_m) {
  return "<trapezoidfinset><name>" + name + "</name><instancecount>" + std::to_string(count) +
         "</instancecount><axialoffset method='bottom'>" + offset_m +
         "</axialoffset><material type='bulk' density='1000'>x</material><thickness>0.004</thickness><cant>1.5</cant>"
         "<rootchord>0.1</rootchord><tipchord>0.1</tipchord><sweeplength>0.02</sweeplength><height>0.08</height>"
         "</trapezoidfinset>";
}

inline const sim::Geometry::Mass& part(const Design& design, const std::string& name) {
  for (const sim::Geometry::Mass& mass : design.geometry.masses) {
    if (mass.name == name) {
      return mass;
    }
  }
  throw std::out_of_range{name};
}

}  // namespace fantail::airframe::openrocket
