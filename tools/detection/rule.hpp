// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"

namespace fantail::detection {

/// One way to detect a launch and to let control begin, and the plans that have it.
struct Rule {
  std::vector<std::string> names;
  core::FlightPlan plan;
  bool judged = true;  ///< a false actuation of it is a failure of the campaign

  [[nodiscard]] std::string name() const;  ///< of all of them, with commas
};

/// The second launch's rule as it was printed: two accelerometers, 2.5 g for 0.1 s raw, height alone opens the gate,
/// and height counts from detection. No plan of it is shipped.
inline constexpr const char* published_launch_2 = "published_launch2";

/// The rules of these plans (shipped names, files, or the one above), each once: plans whose launch detection, guide,
/// motion, sensors and start are the same are one rule. Without names: all shipped launch plans and the one above, and
/// judged are those that ask two accelerometers; the others are shown beside them. A plan that is named is judged,
/// except the one above. Throws text::Error: for a name or a file that is none, and for a plan that does not start by
/// launch detection.
[[nodiscard]] std::vector<Rule> rules_of(std::span<const std::string> plans);

/// What makes a rule this one and no other, as text.
[[nodiscard]] std::string identity_of(const Rule& rule);

}  // namespace fantail::detection
