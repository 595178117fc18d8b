// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "files/quantities.hpp"
#include "files/rows.hpp"
#include "flight/table.hpp"

namespace fantail::trajectory {

using files::Quantity;

struct FoundColumn {
  Quantity quantity;
  std::string name;  ///< as in the file, without the unit
  files::Found found;
};

/// The columns of an exported trajectory that mean something here, one for each quantity (files::exported_columns()),
/// in capitals or not, the unit in parentheses behind the name.
class Columns {
 public:
  /// Throws text::Error (bad_data), with file, line and column: a unit that nobody knows.
  explicit Columns(const flight::Table& table);

  [[nodiscard]] const FoundColumn* find(Quantity quantity) const;
  [[nodiscard]] const std::vector<FoundColumn>& all() const { return found_; }

 private:
  std::vector<FoundColumn> found_;
};

/// How both programs call it: "Altitude (OpenRocket) or Altitude AGL (RocketPy, altitude)".
[[nodiscard]] std::string names_of(Quantity quantity);

}  // namespace fantail::trajectory
