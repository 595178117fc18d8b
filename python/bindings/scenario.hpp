// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scenario.hpp"

namespace fantail::python {

/// A scenario with what was asked of it, in the words of the command line.
struct Scenario {
  std::string source;                ///< a shipped name or a path
  std::vector<std::string> changes;  ///< "controller.canard_limit_deg=9"
  std::string seed;                  ///< empty: the scenario's own
  sim::Scenario scenario;

  /// Throws text::Error.
  [[nodiscard]] static Scenario load(std::string source, std::vector<std::string> changes, std::string seed);

  /// The changes with the seed, as results name them.
  [[nodiscard]] std::vector<std::string> all_changes() const;
};

}  // namespace fantail::python
