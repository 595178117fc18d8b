// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "flight/flight.hpp"
#include "report/extent.hpp"

namespace fantail::report {

/// Rows are a millisecond apart and their times are rounded to the microsecond.
inline constexpr double row_time_rounding_s = 1e-6;
/// Over less time than this the mean of a wobble is not where it rests.
inline constexpr double shortest_rest_s = 0.5;

[[nodiscard]] inline std::optional<double> if_finite(double value) {
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

/// So long a capture may take from any angle.
inline constexpr double longest_capture_s = 1.2;

/// What the hold error leaves out after control start: a second, in the slow air of the tunnel two, and with capture
/// longest_capture_s.
[[nodiscard]] double first_settling_time_s(const flight::Flight& flight);
/// And after each change of the reference.
[[nodiscard]] double step_settling_time_s(const flight::Flight& flight);

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
  /// Each row under control, in order. `roll_rad`: from where the reference counts.
  void add(const flight::Row& row, double roll_rad, const flight::Flight& flight);
  /// Control pauses, and begins anew with the next row.
  void pause() { begins_ = true; }

  /// Of the settled part; empty: there is none.
  [[nodiscard]] std::optional<double> largest_error_rad() const { return largest_error_rad_; }
  [[nodiscard]] std::optional<double> mean_error_rad() const;
  /// How long all of that was, without the holes between its rows.
  [[nodiscard]] double judged_time_s() const;

  /// `usual_step_s`: between rows that know the roll.
  [[nodiscard]] HoldRecord record(const flight::Clock& clock, double usual_step_s) const;

 private:
  void note_what_is_missing(const flight::Row& row, double roll_rad, const flight::Flight& flight);

  RunningExtent known_{};
  HoldRecord record_{};
  bool has_begun_ = false;
  bool begins_ = true;
  double last_known_s_ = 0.0;
  double reference_rad_ = 0.0;
  double settles_at_s_ = 0.0;
  std::optional<double> largest_error_rad_{};
  double sum_of_errors_rad_ = 0.0;
  std::size_t settled_ = 0;
  std::optional<double> last_settled_s_{};  ///< of this stretch
  double judged_time_s_ = 0.0;
};

/// How far the roll is from what was asked, its reference R, row by row under control. The law plays no part in what is
/// measured; where it is known, its settle point counts as well.
class RunningRest {
 public:
  /// Each row under control, in order. `roll_rad`: from where the reference counts.
  void add(const flight::Row& row, double roll_rad, const flight::Flight& flight);
  /// Control pauses, and begins anew with the next row.
  void pause() { begins_ = true; }

  /// Its size, the farthest of: the mean of phi - R over each settled stretch of one reference, and the settle
  /// points in them. A stretch is half a second or longer where there is one. Empty: nothing settled, or R is not
  /// known.
  [[nodiscard]] std::optional<double> rest_error_rad() const;
  /// Mean of |phi - R| over all time under control that knows both.
  [[nodiscard]] std::optional<double> mean_error_rad() const;

 private:
  /// Of one reference, settled.
  struct Stretch {
    double begin_s = 0.0;
    double end_s = 0.0;
    double sum_rad = 0.0;
    std::size_t rows = 0;
  };
  [[nodiscard]] std::optional<double> farthest_with(const Stretch& stretch) const;

  bool begins_ = true;
  double reference_rad_ = 0.0;
  double settles_at_s_ = 0.0;
  Stretch stretch_{};                     ///< the present one
  std::optional<double> farthest_rad_{};  ///< mean of the earlier ones
  std::optional<double> of_law_rad_{};    ///< the farthest settle point from R
  double sum_of_errors_rad_ = 0.0;
  std::size_t rows_ = 0;
};

/// What the hold error leaves out: "the first second of control and of each step". `again`: control ended and began
/// anew, and each time that is left out.
[[nodiscard]] std::string settling_left_out(const flight::Flight& flight, bool again);
/// "after" that.
[[nodiscard]] std::string once_settled(const flight::Flight& flight, bool again);

/// Where the law of the plan comes to rest: "R + u_d/kp".
[[nodiscard]] std::string settle_point_name(const flight::Flight& flight);

/// Why it comes to rest there, with this flight's own numbers where they are known and it can get there.
[[nodiscard]] std::string settle_point_text(const flight::Flight& flight, bool can_settle);

}  // namespace fantail::report
