// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "detection/burn.hpp"
#include "detection/event_models.hpp"

namespace fantail::detection {

/// A flight and what comes after it, part by part, each from where the last one ended.
class Story {
 public:
  Story(Streams& streams, Motion& motion, bool all);

  /// A launch that some rule misses, or one that is detected and of which control may not begin; up to the opening.
  void fly_missed();
  void fly_uncontrolled();

  /// The first opening, the descent, in every second story another opening, the landing, and the rocket lies still.
  void come_down();

  /// Somebody lifts it, and carries, turns, shakes, puts down or drives it.
  void be_carried_home();

 private:
  void fly(const Burn& burn, double rms_g);
  void begin(Part part) { motion_.part_begin[static_cast<std::size_t>(part)] = at_; }
  /// From now to the end of the room.
  [[nodiscard]] std::span<float> from_now(std::array<float, Motion::most>& values) const {
    return std::span<float>{values}.subspan(at_);
  }
  [[nodiscard]] double draw(double low, double high);
  [[nodiscard]] double draw_log(double low, double high);
  [[nodiscard]] bool one_in(double count) { return draw(0.0, count) < 1.0; }
  /// By this angle within this time, slowly at both ends, beginning this long from now.
  void turn(double after_s, double time_s, double angle_rad);
  /// Turned to any angle of the axis from the vertical that a parachute leaves it at.
  [[nodiscard]] double any_hanging_rad();
  void open_parachute(Part part, float carried_before);
  void hang(double time_s);
  void land();
  void be_dragged();
  void lift();
  void walk();
  void put_down();
  void drive();

  Streams& streams_;
  sim::Random& random_;
  Motion& motion_;
  bool all_;
  std::size_t at_;
  double pitch_rad_;
  std::size_t ignition_ = 0;
};

}  // namespace fantail::detection
