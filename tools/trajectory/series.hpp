// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
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

/// How the rocket of a series moves in the plane in which it leans, at each row.
struct Motion {
  std::vector<double> up_m_s;          ///< over ground
  std::vector<double> across_m_s;      ///< over ground
  std::vector<double> along_axis_m_s;  ///< through the air
  std::vector<double> tilt_rad;        ///< of the axis, from the vertical
  std::vector<double> felt_m_s2;       ///< along the axis, gravity taken off; empty: it follows from the speeds
  std::vector<Quantity> read;          ///< from the file
  std::vector<std::string> derived;    ///< words for a person: "the tilt is that of the path"
};

/// What is not in the series follows from what is, as parse_trajectory() says; the tilt of the guide stands in for one
/// that nothing tells. Up to lift-off the rocket is at rest.
[[nodiscard]] Motion motion_of(const Series& series, double guide_tilt_rad);

}  // namespace fantail::trajectory
