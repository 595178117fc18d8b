// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "flight/table.hpp"
#include "trajectory/columns.hpp"

namespace fantail::trajectory {

/// What a table says over time, in SI and radians.
struct Series {
  std::vector<double> times_s;                     ///< increasing; the clock of the file
  std::vector<std::size_t> lines;                  ///< of the file, counted from 1
  std::map<Quantity, std::vector<double>> values;  ///< at those times; without Quantity::time
  std::vector<Quantity> needed;                    ///< time, the height and the speed by which the flight was found
  std::size_t liftoff = 0;                         ///< the last row at rest
  std::size_t apogee = 0;                          ///< the highest row; the last one, if it still climbs there
  bool climbs_to_the_end = false;
  std::vector<std::string> notes;  ///< what was left out or filled in, a sentence each

  [[nodiscard]] const std::vector<double>* find(Quantity quantity) const {
    const auto found = values.find(quantity);
    return found == values.end() ? nullptr : &found->second;
  }
};

/// Height above the launch site stands in it in any case, and a speed, total or vertical. Rows without a number for one
/// of these or for the time are left out, up to 1 % of all, and so are rows with the time of the one before (both
/// programs write an event's row twice). Other columns may lack numbers for up to 0.1 s in flight, and for as long as
/// they like before lift-off and after apogee; they are filled from the neighbours.
///
/// Throws text::Error (bad_data) that names file, line and column: a needed column that is not there, no row, more
/// than 1 % without numbers, time that goes back, more than 0.1 s between two rows from lift-off to apogee, a number
/// beyond what a rocket can have, a rocket that moves in the first row or never moves, or that stands more than 50 m
/// above or below the launch site.
[[nodiscard]] Series read_series(const flight::Table& table, const Columns& columns);

}  // namespace fantail::trajectory
