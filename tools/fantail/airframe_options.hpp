// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fantail/command_line.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::tool {

/// Whose inertia and reference area a roll model is identified with.
struct AirframeOptions {
  std::string vehicle;  ///< the default, when the verb has one
  std::optional<double> inertia_kg_m2{};
  std::optional<double> area_m2{};
};

struct NamedAirframe {
  std::string name;
  identify::model::Airframe airframe{};
};

/// --vehicle, --inertia and --area.
void add_airframe_options(const Verb& verb, AirframeOptions& options);

/// The vehicle's, but for what is given as a number. Throws text::Error.
[[nodiscard]] NamedAirframe airframe(const AirframeOptions& options);

}  // namespace fantail::tool
