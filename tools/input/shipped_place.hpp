// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "input/shipped.hpp"

namespace fantail::input {

/// Where the shipped files of a kind lie in the project, and what they are called.
struct ShippedPlace {
  std::string_view noun;       ///< for people: "flight plan"
  std::string_view folder;     ///< "firmware/plans"
  std::string_view extension;  ///< ".toml"
};

[[nodiscard]] constexpr ShippedPlace place_of(Shipped kind) {
  switch (kind) {
    case Shipped::scenario: return {"scenario", "sim/scenarios", ".toml"};
    case Shipped::vehicle: return {"vehicle", "sim/vehicles", ".toml"};
    case Shipped::motor: return {"motor", "sim/motors", ".eng"};
    case Shipped::tunnel_result: return {"tunnel result", "sim/tunnel_results", ".csv"};
    case Shipped::plan: break;
  }
  return {"flight plan", "firmware/plans", ".toml"};
}

}  // namespace fantail::input
