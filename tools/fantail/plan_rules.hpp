// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/flight_plan.hpp"
#include "json/value.hpp"
#include "rules/judge.hpp"

namespace fantail::tool {

/// The clauses of a rule pack that name neither a flight nor a rocket. The others need both: fantail rules.
class PlanRules {
 public:
  /// `pack` is a shipped name or a path, or empty: then nothing is judged. `plan` is that of `file`. Throws
  /// text::Error.
  PlanRules(const std::optional<std::string>& pack, const std::filesystem::path& file, const core::FlightPlan& plan);

  /// With a member "rules"; a clause that fails makes the answer no.
  [[nodiscard]] json::Value added_to(json::Value all) const;
  /// Throws RequirementNotMet where a clause fails or could not be judged.
  void end(bool shows) const;

 private:
  [[nodiscard]] bool fails() const;
  void show() const;

  std::filesystem::path file_;
  std::optional<rules::Pack> pack_;
  std::vector<rules::Judged> judged_;
};

}  // namespace fantail::tool
