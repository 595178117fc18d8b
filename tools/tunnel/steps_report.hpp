// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "identify/model/roll_model.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tunnel {

// What `fantail tunnel steps` says, three times: for the terminal, for a script, and as a page with pictures.

/// What a table of steps was made from.
struct StepsHeading {
  std::string log{};
  std::string vehicle{};
  identify::model::Airframe airframe{};
  std::optional<double> speed_m_s{};  ///< empty: the log's own, which varies
  std::string speed_source{};         ///< "tunnel.csv", "--speed", "the log"
  double density_kg_m3 = 0.0;
  StepOptions options{};
};

[[nodiscard]] std::string steps_text(const StepsHeading& heading, const StepTable& table);
[[nodiscard]] std::string steps_json(const StepsHeading& heading, const StepTable& table);
[[nodiscard]] std::string steps_html(const StepsHeading& heading, const StepTable& table);

/// One sentence on vehicle, air and method.
[[nodiscard]] std::string steps_basis(const StepsHeading& heading);

}  // namespace fantail::tunnel
