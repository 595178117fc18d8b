// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "flight/flight.hpp"
#include "report/beginning.hpp"
#include "report/running_figures.hpp"
#include "runs/row_text.hpp"

namespace fantail::dormancy {

/// Farther than this from where the law settles, a roll angle is not captured.
inline constexpr double captured_rad = report::Capture::near_rad;
/// So long it must have stayed there: no rocket that only turns past it is captured.
inline constexpr double shortest_capture_s = report::Capture::stays_at_end_s;
using flight::slowest_held_m_s;

/// How a rocket moves as its canards first leave trim, and how soon its roll is captured.
struct Opening {
  double time_s = 0.0;                       ///< on the clock of its flight
  bool was_waited_for = false;               ///< beyond the guide: the plan's gate was closed there
  double height_m = 0.0;                     ///< true height above the site, where truth is known
  double speed_m_s = 0.0;                    ///< likewise
  double rate_rad_s = 0.0;                   ///< likewise
  double angle_rad = 0.0;                    ///< as the law has it, whole turns and all
  double offset_rad = 0.0;                   ///< of the fins, where truth is known
  std::uint64_t reopenings = 0;              ///< how often the gate had closed and control began anew
  std::optional<double> captured_after_s{};  ///< report::Capture::after_s, from when control began last; empty: never
};

inline void fields(runs::RowText& text, Opening& opening) {
  text(opening.time_s, opening.was_waited_for, opening.height_m, opening.speed_m_s, opening.rate_rad_s,
       opening.angle_rad, opening.offset_rad, opening.reopenings, opening.captured_after_s);
}

/// Looks at a flight row by row.
class OpeningWatch {
 public:
  explicit OpeningWatch(bool tunnel) : tunnel_{tunnel}, zero_{tunnel}, capture_{tunnel} {}

  /// Each row, in order, and the flight as far as it is known by then.
  void add(const flight::Row& row, const flight::Flight& so_far);

  /// Empty: canards never left trim. `clock`: from the rows' to that of the flight.
  [[nodiscard]] std::optional<Opening> found(const flight::Clock& clock = {}) const;

 private:
  bool tunnel_;
  bool pauses_ = false;  ///< control, which has begun
  report::TrueZero zero_;
  std::optional<Opening> opening_{};
  report::CaptureWatch capture_;
};

}  // namespace fantail::dormancy
