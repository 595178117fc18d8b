// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "flight/flight.hpp"
#include "report/activity.hpp"
#include "report/beginning.hpp"
#include "report/extent.hpp"
#include "report/figures.hpp"
#include "report/hold.hpp"

namespace fantail::report {

/// Where the law counts the true roll angle from: from where the rocket stood at launch detection (tunnel: at control
/// start), which the truth counts from the pad.
class TrueZero {
 public:
  explicit TrueZero(bool tunnel) : begins_with_{tunnel ? core::Phase::controlling : core::Phase::launched} {}

  /// Each row, in order; from the first under control on it stays.
  void add(const flight::Row& row);

  /// 0 where nobody knows it.
  [[nodiscard]] double rad() const { return rad_; }

  /// False where that moment, or its true angle, is not on record; rad() is then that of the first row behind it, or 0.
  [[nodiscard]] bool is_known() const { return is_known_; }

 private:
  core::Phase begins_with_;
  core::Phase phase_ = core::Phase::safe;
  std::optional<double> last_s_{};
  bool is_known_ = true;
  double rad_ = 0.0;
};

/// The figures of a flight, row by row, while it is flown or afterwards: whoever wants no more than them keeps no rows.
class RunningFigures {
 public:
  explicit RunningFigures(bool tunnel);

  /// Each row, in order. `flight` is all of it or what is known up to then, its times on the clock of the rows: what it
  /// is flown with (plan, canards) from the beginning, and the apogee from its own row on.
  void add(const flight::Row& row, const flight::Flight& flight);

  /// Of the rows up to now, but for Figures::side_deflection. `flight` is the whole one, on the clock that its rows
  /// have or, where they were added before that was known, were to be put by `clock`.
  [[nodiscard]] Figures figures(const flight::Flight& flight, const flight::Clock& clock = {}) const;

 private:
  /// Paused: the plan's gate closed again, and may open.
  enum class Stage : std::uint8_t { before_control, under_control, paused, after_control };

  struct Start {
    double time_s = 0.0;
    double height_m = 0.0;
  };
  /// Control without a pause.
  struct Spell {
    double from_s = 0.0;
    double from_rad = 0.0;  ///< roll angle
    CaptureWatch capture;
    std::optional<double> turn{};  ///< that capture chose
    [[nodiscard]] Capture found(const flight::Clock& clock) const {
      Capture all = capture.found(clock);
      all.turn = turn;
      return all;
    }
  };
  struct End {
    double time_s = 0.0;
    double roll_angle_rad = 0.0;
    double command_rad = 0.0;
  };
  /// Ticks in a row that are saturated, up to now.
  struct Saturation {
    double begin_s = 0.0;
    double end_s = 0.0;
    std::optional<double> largest_offset_rad{};
    std::optional<flight::Truth> truth{};  ///< of the last that has one
    double command_rad = 0.0;              ///< at that one
  };

  void add_motion(const flight::Row& row);
  void change_stage(const flight::Row& row, const flight::Flight& flight);
  void begin_spell(const flight::Row& row, const flight::Flight& flight);
  void pause_control();
  void add_controlled(const flight::Row& row, double roll_rad, const flight::Flight& flight);
  void judge_saturation(const flight::Row& row);
  void look_after_control(const flight::Row& row, const flight::Flight& flight);
  void tell_authority(Figures& f, const flight::Flight& flight) const;
  void tell_saturation(Figures& f, const flight::Flight& flight, const flight::Clock& clock) const;
  void tell_end(Figures& f, const flight::Flight& flight) const;

  /// Is it a figure of the flight, or only of the rows that are left of it?
  [[nodiscard]] bool top_speed_is_known(const flight::Flight& flight, const flight::Clock& clock) const;

  std::size_t rows_ = 0;
  RunningExtent roll_{};
  RunningExtent speed_{};
  RunningExtent height_{};
  core::Phase phase_ = core::Phase::safe;
  std::optional<double> largest_speed_m_s_{};
  double largest_speed_at_s_ = 0.0;
  double last_speed_m_s_ = 0.0;
  bool begins_under_control_ = false;
  std::optional<double> largest_height_m_{};
  bool in_still_air_ = true;
  TrueZero zero_;
  CameraRollWatch camera_roll_{};
  NeutralWatch neutral_{};
  OpeningWatch opening_{};
  std::vector<Spell> spells_{};

  Stage stage_ = Stage::before_control;
  std::size_t controlled_ = 0;
  Start start_{};
  End end_{};
  double paused_s_ = 0.0;    ///< in all
  double turned_rad_ = 0.0;  ///< in the spells before the last
  bool tunnel_;
  RunningHold hold_{};
  RunningRest rest_{};
  std::optional<double> largest_offset_rad_{};
  std::optional<double> least_offset_rad_{};
  std::optional<double> most_offset_rad_{};
  std::size_t saturated_ = 0;
  bool knows_saturation_ = true;  ///< of every row under control
  std::optional<Saturation> saturation_{};
  OscillationWatch oscillation_;

  std::optional<double> first_rolled_rad_{};         ///< of the first row after control
  std::optional<double> rolled_until_apogee_rad_{};  ///< the largest
  std::optional<double> rolled_beyond_rad_{};        ///< likewise, behind an apogee that may yet turn out a hop's
};

}  // namespace fantail::report
