// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "flight/flight.hpp"
#include "text/degrees.hpp"

// How control begins: canards at trim until the plan's gate opens, the state then, and capture. The same of a simulated
// flight and of a log; empty: not known.
namespace fantail::report {

/// How far the canards stood from trim before control: the largest of the four, from the last arming on (a record of
/// the avionics begins shortly before launch detection) to control start, or to the end of a flight without control.
struct Neutral {
  std::optional<double> from_s{};  ///< first row of that time, on the rows' clock
  std::optional<double> until_s{};
  std::optional<double> command_rad{};
  std::optional<double> encoder_rad{};
  double unread_s = 0.0;   ///< for so long in all, one of the encoders or more could not be read
  double missing_s = 0.0;  ///< for so long in all, no row is on record

  friend bool operator==(const Neutral&, const Neutral&) = default;
};

class NeutralWatch {
 public:
  /// Each row, in order.
  void add(const flight::Row& row, const flight::Flight& flight);
  [[nodiscard]] Neutral found(const flight::Clock& clock) const;

 private:
  Neutral neutral_{};
  bool is_over_ = false;
};

/// The state at control start, true where the truth is known, and the wait before it.
struct Opening {
  std::optional<double> speed_m_s{};
  std::optional<double> roll_angle_rad{};  ///< from where the law counts it
  std::optional<double> roll_rate_rad_s{};
  /// Net, while the canards waited for the gate, every time; empty: they did not, or a hole hides when they did.
  std::optional<double> dormant_turns{};
  std::size_t closings = 0;  ///< so often the gate closed again under control

  friend bool operator==(const Opening&, const Opening&) = default;
};

class OpeningWatch {
 public:
  /// Each row, in order. `roll_rad`: from where the law counts it.
  void add(const flight::Row& row, double roll_rad);
  [[nodiscard]] const Opening& found() const { return opening_; }
  /// A hole lies before the first row under control, or nothing at all: that row shows another time.
  [[nodiscard]] bool misses_start() const { return misses_start_; }

 private:
  Opening opening_{};
  bool misses_start_ = false;
  std::optional<double> last_s_{};
  std::optional<core::Phase> before_{};
  double dormant_from_rad_ = 0.0;
  double turns_before_ = 0.0;  ///< of earlier waits
  bool is_waiting_ = false;    ///< since a row that is on record
  bool knows_turns_ = true;    ///< no wait began or ended in a hole
  bool is_open_ = false;
};

/// How the roll comes to where it is held, from control start, or from where the gate reopened, to the first change of
/// the reference.
struct Capture {
  static constexpr double near_rad = text::radians(10.0);
  static constexpr double stays_s = 1.0;
  static constexpr double stays_at_end_s = 0.5;  ///< where control or the reference does not last longer

  std::optional<double> turn{};  ///< whole turns that capture chose; empty: the plan does not ask for it
  /// From control start until the roll was within `near_rad` of where the law settles, and stayed. Where the fin offset
  /// is not known: of where the roll came to rest.
  std::optional<double> after_s{};
  std::optional<double> watched_s{};           ///< how long it was looked at
  std::optional<double> saturated_fraction{};  ///< until then; where it did not come there, while it was looked at

  friend bool operator==(const Capture&, const Capture&) = default;
};

/// Control after the gate had closed again.
struct Reopening {
  double time_s = 0.0;
  Capture capture{};

  friend bool operator==(const Reopening&, const Reopening&) = default;
};

/// The one judge of capture, for reports, predictions and campaigns.
class CaptureWatch {
 public:
  /// In a tunnel the roll is held in slow air, too.
  explicit CaptureWatch(bool tunnel) : tunnel_{tunnel} {}

  /// Each row under control, in order; `error_rad`: from where its roll is to stay, empty: not known. In flight it ends
  /// where the air is slower than flight::slowest_held_m_s.
  void add(const flight::Row& row, const std::optional<double>& error_rad);
  /// Control pauses, or is over.
  void end() { is_over_ = is_over_ || first_s_; }
  /// Without Capture::turn.
  [[nodiscard]] Capture found(const flight::Clock& clock) const;

 private:
  struct Count {
    std::size_t ticks = 0;
    std::size_t saturated = 0;
  };

  bool tunnel_;
  bool is_over_ = false;
  bool knows_saturation_ = true;
  double reference_rad_ = 0.0;
  std::optional<double> first_s_{};
  double last_s_ = 0.0;
  std::optional<double> near_since_s_{};
  Count all_{};
  Count before_{};  ///< it came near
};

/// Does the law hold an angle at all?
[[nodiscard]] bool holds_an_angle(const flight::Flight& flight);

/// Of a log, where nobody knows the fin offset: from where the roll came to rest. `control`: rows under control,
/// without a pause.
[[nodiscard]] Capture measured_capture(const flight::Flight& flight, std::span<const flight::Row> control);

}  // namespace fantail::report
