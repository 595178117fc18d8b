// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/document.hpp"
#include "input/field.hpp"
#include "sim/scenario.hpp"

namespace fantail::input {

/// Everything that a scenario file may say, its faults apart.
[[nodiscard]] std::span<const Field<sim::Scenario>> scenario_fields();

/// The three files of a run, for who reads them again and again with other values. A section's name is in one of them
/// only.
class ScenarioFiles {
 public:
  /// A shipped name or a path. Throws text::Error.
  [[nodiscard]] static ScenarioFiles load(const std::string& name_or_path);

  /// Replaces or adds one value in the file that has its section. A change of vehicle or plan by name, which has no
  /// section, is refused. Throws text::Error.
  void apply(const Override& change);

  /// As they stand now. Throws text::Error.
  [[nodiscard]] sim::Scenario read() const;

  [[nodiscard]] const Document& scenario() const { return scenario_; }
  [[nodiscard]] const Document& plan() const { return plan_; }
  [[nodiscard]] const Document& vehicle() const { return vehicle_; }
  /// The one with such a section; none when no file may have one.
  [[nodiscard]] const Document* with_section(std::string_view section) const;

 private:
  Document scenario_;
  Document plan_;
  Document vehicle_;
};

/// "unknown section servos; did you mean servo?", of the three files.
[[nodiscard]] std::string unknown_section(const std::string& section);

/// Changes as a command line has them, section.key=value each. Throws text::Error.
[[nodiscard]] std::vector<Override> parse_overrides(std::span<const std::string> texts);

/// A shipped name or a path, with changes from the command line, which may reach into the scenario, its plan or its
/// vehicle. Throws text::Error.
[[nodiscard]] sim::Scenario load_scenario(const std::string& name_or_path, std::span<const Override> changes);

}  // namespace fantail::input
