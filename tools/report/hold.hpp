// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "flight/flight.hpp"
#include "report/extent.hpp"

namespace fantail::report {

/// When it is known under control how far the roll is from where the law should settle, and what that lacks elsewhere.
struct HoldRecord {
  bool is_ever_known = false;
  Extent known{};
  double control_from_s = 0.0;  ///< first row under control
  double control_to_s = 0.0;    ///< and the last
  bool lacks_roll = false;      ///< at some row, that from which the reference counts
  bool lacks_reference = false;
  bool lacks_fin_offset = false;
  bool lacks_speed = false;  ///< and the gains go by it

  friend bool operator==(const HoldRecord&, const HoldRecord&) = default;
};

/// Hold errors, row by row.
class RunningHold {
 public:
  explicit RunningHold(double settling_time_s) : settling_time_s_{settling_time_s} {}

  /// Each row under control, in order. `roll_rad`: from where the reference counts.
  void add(const flight::Row& row, double roll_rad, const flight::Flight& flight);

  /// Of the settled part; empty: there is none.
  [[nodiscard]] std::optional<double> largest_error_rad() const { return largest_error_rad_; }
  [[nodiscard]] std::optional<double> mean_error_rad() const;
  /// How long all of that was, without the holes between its rows.
  [[nodiscard]] double judged_time_s() const;

  /// `usual_step_s`: between rows that know the roll.
  [[nodiscard]] HoldRecord record(const flight::Clock& clock, double usual_step_s) const;

 private:
  void note_what_is_missing(const flight::Row& row, double roll_rad, const flight::Flight& flight);

  double settling_time_s_;
  RunningExtent known_{};
  HoldRecord record_{};
  bool has_begun_ = false;
  std::optional<double> last_known_s_{};
  double reference_rad_ = 0.0;
  double settles_at_s_ = 0.0;
  std::optional<double> largest_error_rad_{};
  double sum_of_errors_rad_ = 0.0;
  std::size_t settled_ = 0;
  std::optional<double> last_settled_s_{};  ///< of this stretch
  double judged_time_s_ = 0.0;
};

}  // namespace fantail::report
