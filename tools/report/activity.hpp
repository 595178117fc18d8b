// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "flight/flight.hpp"

namespace fantail::report {

/// Canards that go on swinging although nothing excites them and the reference stands still: a loop that oscillates.
struct Oscillation {
  double from_s = 0.0;  ///< where it was first seen
  double frequency_hz = 0.0;
  double lowest_rad = 0.0;  ///< canard angle, in the second with the widest swing
  double highest_rad = 0.0;

  friend bool operator==(const Oscillation&, const Oscillation&) = default;
};

/// Looks at the true canards, a second at a time: three or more swings of a degree to either side, that do not die
/// away. Where no truth is known, at the encoders' mean, and the command must swing as far; where that is unknown, too,
/// at the command alone. Left out are the excitation and what settles after control start, after a step of the
/// reference and after the excitation, for `settling_time_s` each.
class OscillationWatch {
 public:
  explicit OscillationWatch(double settling_time_s) : settling_time_s_{settling_time_s} {}

  /// Each row under control, in order.
  void add(const flight::Row& row);

  /// Control pauses, and begins anew with the next row.
  void pause() { reference_rad_.reset(); }

  /// Up to now. `clock`: that of the oscillation, from the rows' own.
  [[nodiscard]] std::optional<Oscillation> found(const flight::Clock& clock = {}) const;

 private:
  struct Sample {
    double time_s;
    double angle_rad;
    double command_rad;
    bool truth_is_known;
  };
  using Samples = std::span<const Sample>;
  struct Ends;
  /// A window in which the canards oscillate.
  struct Swings {
    double begin_s;  ///< of the first of them
    double end_s;
    int count;
    double lowest_rad;
    double highest_rad;
  };
  static Ends ends(Samples samples, double Sample::* angle = &Sample::angle_rad);
  static std::optional<Swings> look_at(Samples window);
  static std::optional<Swings> count_swings(Samples window, const Ends& ends);
  void look_through();

  double settling_time_s_;
  std::optional<double> reference_rad_{};
  double settles_at_s_ = 0.0;
  std::vector<Sample> quiet_{};  ///< from the next window's begin on: everything has settled, nothing excites
  std::optional<double> first_seen_s_{};
  std::optional<Swings> widest_{};
};

}  // namespace fantail::report
