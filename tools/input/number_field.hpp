// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "input/scenario_file.hpp"
#include "input/section.hpp"

namespace fantail::input {

/// A number that a file of the run may say, in the unit of the files.
struct NumberField {
  std::string section;
  std::string key;
  std::string unit;            ///< empty for a pure number
  Limits range{};              ///< both ends allowed
  std::vector<double> values;  ///< as the files say now, or what is usual where they are silent
  bool is_list = false;        ///< written as one, even with one value

  [[nodiscard]] std::string name() const { return section + "." + key; }
  /// With these values in its place, as many as it has now. Every digit is kept.
  [[nodiscard]] Override with(const std::vector<double>& new_values) const;
};

/// The field of "section.key", whose file is `files`. Throws text::Error (bad_configuration), saying what is wrong with
/// the name: no such section or key, no number, a whole number, or none that a file states and none that is usual.
[[nodiscard]] NumberField number_field(const ScenarioFiles& files, const std::string& name);

}  // namespace fantail::input
