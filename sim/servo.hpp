// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "sim/elementary.hpp"
#include "sim/random.hpp"
#include "sim/shaft_load.hpp"
#include "sim/units.hpp"

namespace fantail::sim {

inline constexpr double shortest_lag_s = 0.0005;
inline constexpr double longest_lag_s = 1.0;
inline constexpr double longest_delay_s = 0.05;

struct ServoParameters {
  double lag_s = 0.020;                                  ///< first-order; 0.0005 to 1
  double delay_s = 0.003;                                ///< from latched to acted upon; 0 to 0.05
  double frame_period_s = 1.0 / 333.0;                   ///< 0.001 or more
  double rate_limit_rad_s = 600.0 * radians_per_degree;  ///< above 0
  double stop_rad = 25.0 * radians_per_degree;           ///< mechanical stop of the shaft, both ways; above 0
  double backlash_rad = 0.1 * radians_per_degree;        ///< whole width of the play; 0 or more
  double pulse_centre_us = 1500.0;                       ///< commands the centre
  double pulse_per_degree_us = 10.0;                     ///< negative when it turns the other way; not 0
  double centre_rad = 0.0;                               ///< shaft angle of the centre; within the stop
  std::optional<double> torque_n_m{};                    ///< at stall, at the shaft; above 0; empty: no load slows it
};

/// How much the servos of one vehicle differ from each other. Zeros: all are the same.
struct ServoSpread {
  double share = 0.0;       ///< of lag, delay, rate limit and play: each is multiplied by 1 +- this; 0 to 0.3
  double centre_rad = 0.0;  ///< each centre is off by +- this; 0 to the servo's stop
};

/// One servo off the shelf: evenly spread about `typical`, and inside Servo's ranges where that is. Five numbers are
/// drawn whatever the spread, so that one kind of spread does not change the other.
[[nodiscard]] ServoParameters one_of_the_spread(const ServoParameters& typical, const ServoSpread& spread,
                                                Random& random);

enum class ServoFault : std::uint8_t {
  none,
  stuck,       ///< the gear is jammed: the shaft stays where it is, or at the angle given with the fault
  hardover,    ///< runs to the positive stop at the rate limit, whatever the pulse
  dead,        ///< torn from its gear: the air turns the shaft back to zero, with the time constant of the lag
  slipping,    ///< the horn slips: the shaft loses a third of every movement from here on
  reversed,    ///< moves the other way about the centre
  slow,        ///< four times the lag, a quarter of the rate limit
  wrong_trim,  ///< the horn was fitted off: the shaft stands an angle away from where the servo believes
};

/// Wrong enough to spin a rocket, and small enough to be overlooked by eye. (A whole tooth of a horn is 14 degrees.)
inline constexpr double usual_wrong_trim_rad = 2.5 * radians_per_degree;

/// What is left of a movement of a slipping horn, and how much longer a slow servo takes.
inline constexpr double slipping_grip = 2.0 / 3.0;
inline constexpr double slow_times = 4.0;

/// One canard servo, from the pulse on the wire to the angle of the canard shaft (on which the encoder sits).
///
/// What happens to a pulse, in this order:
///   1. frame: it is looked at when the next frame begins; frames begin at whole multiples of the period since t = 0;
///   2. range: outside 500 to 2500 us, or NaN, it is ignored; none at all takes the power away, and friction holds the
///      shaft;
///   3. delay: that much later the servo acts on it;
///   4. direction, centre and trim: the goal, an angle of the shaft (faults: `reversed`, `wrong_trim`);
///   5. rate limit, while the goal is farther away than limit times lag, and then the first-order lag: the gear
///      (faults: `slow`, `hardover`, `dead`, `stuck`);
///   6. stop: of the gear, half of the play beyond that of the shaft;
///   7. play: the shaft follows half of it behind;
///   8. grip: a `slipping` horn loses a third of every movement.
/// Every stage is exact in time, so the angle does not depend on how a time is cut into steps, as long as the pulse is
/// the same. Under a load the speeds of stage 5 are those of speeds_under_load(); the load is that of the angle at
/// which a step begins, and follows the angle in the step where nothing but the load limits the speed. Without power
/// friction holds up to the torque, too. A stuck shaft holds any load, and a dead one is not the servo's.
///
/// Example, with the defaults: from 1 ms on the pulse is 1700 us. It is taken over at 3.003 ms and acted upon at 6.003
/// ms. The goal is 20 degrees; 600 deg/s times 20 ms is 12 degrees, so the gear turns its first 8 degrees at the rate
/// limit, until 19.336 ms. From there the lag has it: 20 ms later 12 / e = 4.41 degrees are missing, the gear stands
/// at 15.59 degrees and the shaft, 0.05 behind it, at 15.54. At rest it will be at 19.95.
class Servo {
 public:
  /// Starts at its centre, without power. Throws std::invalid_argument for a parameter outside its range.
  explicit Servo(const ServoParameters& parameters);

  /// Breaks, from now on; ServoFault::none repairs, and the servo goes on from where its shaft stands.
  /// `fault_angle_rad`: where a stuck shaft is jammed (not given: where it stands), how far off a wrong trim is (not
  /// given: the usual); the others have none. Both move the shaft at once, as far as the stop allows.
  void fail(ServoFault fault, std::optional<double> fault_angle_rad = std::nullopt);

  /// On the shaft from now on; empty: none. Does nothing to a servo whose torque is not given.
  void set_load(const std::optional<ShaftLoad>& load) {
    if (parameters_.torque_n_m) {
      load_ = load;
      next_event_s_ = at_once;
    }
  }

  /// Moves from t_s to t_s + dt_s (dt_s > 0) with `pulse_us` on the wire. The next step begins where this one ends.
  void step(double t_s, double dt_s, const std::optional<double>& pulse_us) {
    step(t_s, dt_s, [&] { return pulse_us; });
  }
  /// The pulse is asked for only when a frame begins: in two steps of three nobody needs it.
  template <std::invocable PulseUs>
  void step(double t_s, double dt_s, PulseUs pulse_us) {
    if (dt_s != whole_step_.duration_s) {
      whole_step_ = interval(dt_s);
    }
    const double end_s = t_s + dt_s - same_time_s;
    if (next_event_s_ < end_s) {
      if (next_frame_s_ < end_s) {
        latch(t_s, end_s, pulse_us());
      }
      const bool in_pieces = fault_ != ServoFault::none || load_ || (waiting_ > 0 && queue_[first_].arrival_s < end_s);
      if (in_pieces) {
        step_in_pieces(t_s, t_s + dt_s);
      }
      find_next_event();
      if (in_pieces) {
        return;
      }
    }
    const double before = horn_rad_;
    if (goal_rad_) {
      const double distance = *goal_rad_ - gear_rad_;
      if (std::abs(distance) > lag_reach_rad_) {
        step_in_pieces(t_s, t_s + dt_s);
        return;
      }
      turn_to(gear_rad_ + distance * whole_step_.settling.gain);
    }
    mean_horn_rad_ = before + whole_step_.settling.weight * (horn_rad_ - before);
  }

  /// Angle of the canard shaft, positive as the encoder counts.
  [[nodiscard]] double angle_rad() const { return on_shaft(horn_rad_); }

  /// Mean of that angle over the last step: what a plant that holds its input saw.
  [[nodiscard]] double mean_angle_rad() const { return on_shaft(mean_horn_rad_); }

 private:
  struct Interval {
    double duration_s;
    Settling settling;
  };
  struct Command {
    double arrival_s;
    std::optional<double> asked_rad;  ///< from the centre; empty: power off
  };

  /// Times nearer than this are the same: t_s is a sum of steps, a frame's time a product.
  static constexpr double same_time_s = 1e-9;
  static constexpr double at_once = -std::numeric_limits<double>::infinity();

  [[nodiscard]] Interval interval(double duration_s) const {
    return {.duration_s = duration_s, .settling = settling(duration_s * per_lag_s_)};
  }
  [[nodiscard]] double on_shaft(double horn_rad) const { return slip_from_rad_ + grip_ * (horn_rad - slip_from_rad_); }

  /// The gear stops a little beyond the shaft's stop, by half of the play; the shaft follows when the play is used up.
  void turn_to(double gear_rad) {
    gear_rad_ = gear_rad > gear_stop_rad_ ? gear_stop_rad_ : gear_rad < -gear_stop_rad_ ? -gear_stop_rad_ : gear_rad;
    const double lowest = gear_rad_ - half_play_rad_;
    const double highest = gear_rad_ + half_play_rad_;
    horn_rad_ = horn_rad_ < lowest ? lowest : horn_rad_ > highest ? highest : horn_rad_;
  }

  void find_next_event() {
    const double next_arrival_s = waiting_ > 0 ? queue_[first_].arrival_s : std::numeric_limits<double>::infinity();
    next_event_s_ = fault_ != ServoFault::none || load_ ? at_once : std::min(next_frame_s_, next_arrival_s);
  }
  void set_pace(double times_slower);
  void shift_shaft(double by_rad);
  void aim();
  void latch(double t_s, double end_s, const std::optional<double>& pulse_us);
  void step_in_pieces(double t_s, double end_s);
  [[nodiscard]] double move(const Interval& piece);
  [[nodiscard]] double drive(const Interval& piece, double goal_rad, double limit_rad_s, double reach_rad);
  [[nodiscard]] double drive_loaded(const Interval& piece);
  [[nodiscard]] double turn_at_speed(double speed_rad_s, double duration_s);

  ServoParameters parameters_;
  double per_lag_s_{};
  double rate_limit_rad_s_{};
  double lag_reach_rad_;  ///< farther from the goal than this, the rate limit rules; also of a slow servo
  double half_play_rad_;
  double gear_stop_rad_;
  Interval whole_step_{};

  ServoFault fault_ = ServoFault::none;
  std::optional<ShaftLoad> load_{};
  double trim_error_rad_ = 0.0;        ///< of a wrong trim
  std::optional<double> asked_rad_{};  ///< from the centre
  std::optional<double> goal_rad_{};   ///< where that is on the shaft
  double gear_rad_;                    ///< as an angle of the shaft
  double horn_rad_;                    ///< beyond the play; the shaft turns with it unless it slips
  double mean_horn_rad_;
  double slip_from_rad_ = 0.0;
  double grip_ = 1.0;  ///< share of the horn's movement that reaches the shaft

  double frame_ = 0.0;  ///< number of the next one
  double next_frame_s_ = at_once;
  double next_event_s_ =
      at_once;  ///< that frame or the arrival of a command; with a fault or a load every step has one
  std::optional<double> latched_us_{};
  std::size_t first_ = 0;
  std::size_t waiting_ = 0;
  std::array<Command, 64> queue_{};  ///< at most one a frame: 51 within the longest delay
};

}  // namespace fantail::sim
