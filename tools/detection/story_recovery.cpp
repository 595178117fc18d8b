// SPDX-License-Identifier: MIT
// From the first opening of a parachute to the hands that carry the rocket home.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "detection/shapes.hpp"
#include "detection/story.hpp"

namespace fantail::detection {

void Story::come_down() {
  open_parachute(Part::drogue, 0.0F);
  begin(Part::descent);
  hang(draw(2.0, 8.0));
  begin(Part::main);
  if (one_in(2.0)) {
    open_parachute(Part::main, 1.0F);
    hang(draw(2.0, 8.0));
  }
  begin(Part::landing);
  land();
  if (one_in(5.0)) {
    be_dragged();
  }
  begin(Part::lying);
  at_ += steps(draw(1.0, 8.0));
}

// What is carried before is less than the weight where it falls; afterwards the parachute carries it.
void Story::open_parachute(Part part, float carried_before) {
  begin(part);
  const double width_s = draw_log(0.05, 1.0);
  const auto peak = static_cast<float>(draw(2.0, 20.0));
  const bool is_square = one_in(2.0);
  const std::size_t length = steps(width_s);
  Oscillator wave{0.5 / width_s, 0.0};
  for (std::size_t i = 0; i < length; ++i, wave.advance()) {
    const float least = 2 * i < length ? carried_before : 1.0F;
    motion_.carried[at_ + i] = is_square ? peak : std::max(least, peak * static_cast<float>(wave.sine()));
  }
  // While it opens, or soon after, the rocket turns to the way in which it is going to hang.
  turn(draw(0.0, width_s), draw(0.3, 2.0), any_hanging_rad() - pitch_rad_);
  at_ += length;
}

void Story::hang(double time_s) {
  const std::size_t length = steps(time_s);
  const double swing_rad = draw_log(0.1, 30.0) * degree;
  const double frequency_hz = 1.0 / draw(1.0, 4.0);
  const double w = 2.0 * std::numbers::pi * frequency_hz;
  const auto spin_rad_s = static_cast<float>(draw_log(0.5, 360.0) * degree * (one_in(2.0) ? 1.0 : -1.0));
  Oscillator swing{frequency_hz, 0.0};
  for (std::size_t i = at_; i < at_ + length; ++i, swing.advance()) {
    motion_.pitch_rate_rad_s[i] += static_cast<float>(swing_rad * w * swing.cosine());
    motion_.roll_rate_rad_s[i] = spin_rad_s;
  }
  pitch_rad_ += swing_rad * swing.sine();
  const std::span<float> carried = from_now(motion_.carried).first(length);
  add_band_noise(carried, draw_log(0.005, 0.2), draw_log(1.0, 10.0), random_);
  const auto jolts = static_cast<int>(draw(0.0, 6.0));
  for (int i = 0; i < jolts; ++i) {
    add_half_sine(carried, draw(0.0, time_s), draw_log(0.02, 0.3), draw(0.5, 2.0));
  }
  at_ += length;
}

void Story::land() {
  const double width_s = draw_log(0.005, 0.05);
  const double peak = draw_log(5.0, 100.0);
  add_half_sine(from_now(motion_.carried), 0.0, width_s, peak);
  const double fall_s = draw(0.3, 1.0);
  turn(0.0, fall_s, (one_in(2.0) ? 1.0 : -1.0) * draw(70.0, 110.0) * degree - pitch_rad_);
  if (one_in(2.0)) {
    const double bounce_s = draw(0.1, 0.4);
    std::fill_n(from_now(motion_.carried).begin() + static_cast<std::ptrdiff_t>(steps(width_s)), steps(bounce_s), 0.0F);
    add_half_sine(from_now(motion_.carried), width_s + bounce_s, width_s, draw(0.1, 0.5) * peak);
  }
  at_ += steps(std::max(fall_s, 0.6) + 0.002);
}

void Story::be_dragged() {
  const std::size_t length = steps(draw(1.0, 4.0));
  const double frequency_hz = draw_log(2.0, 20.0);
  const double rms = draw(0.1, 1.0) * g;
  add_band_noise(from_now(motion_.axial_m_s2).first(length), rms, frequency_hz, random_);
  if (all_) {
    add_band_noise(from_now(motion_.across_m_s2).first(length), rms, frequency_hz, streams_.across);
  }
  add_band_noise(from_now(motion_.roll_rate_rad_s).first(length), draw(5.0, 90.0) * degree, 1.0, random_);
  at_ += length;
}

void Story::be_carried_home() {
  begin(Part::crew);
  lift();
  const auto acts = 2 + static_cast<int>(draw(0.0, 3.0));
  for (int i = 0; i < acts; ++i) {
    const double act = draw(0.0, 5.0);
    if (act < 1.0) {
      walk();
    } else if (act < 2.0) {  // upright, or nearly
      const double time_s = draw(0.5, 1.5);
      turn(0.0, time_s, draw(-30.0, 30.0) * degree - pitch_rad_);
      at_ += steps(time_s + draw(0.0, 1.0));
    } else if (act < 3.0) {
      const std::size_t length = steps(draw(1.0, 2.5));
      add_shaking(random_, motion_, at_, at_ + length, 0.1);
      at_ += length;
    } else if (act < 4.0) {
      put_down();
    } else {
      drive();
    }
  }
  motion_.length = at_;
}

void Story::lift() {
  const double width_s = draw(0.15, 0.5);
  const double peak = draw(0.3, 1.5) * std::numbers::pi / (2.0 * width_s * g);
  const double slow_down_s = width_s + draw(0.0, 0.2);
  add_half_sine(from_now(motion_.carried), 0.0, width_s, peak);
  add_half_sine(from_now(motion_.carried), slow_down_s, width_s, -peak);
  turn(0.0, slow_down_s + width_s, draw(-60.0, 60.0) * degree);
  at_ += steps(slow_down_s + width_s);
}

void Story::walk() {
  const double time_s = draw(1.0, 2.5);
  const std::size_t length = steps(time_s);
  const double walk_hz = draw(1.4, 2.5);
  const double bounce = draw(0.1, 0.5);
  const double heel = draw(0.2, 1.0);
  Oscillator step{walk_hz, draw(0.0, 6.28)};
  const std::span<float> carried = from_now(motion_.carried).first(length);
  for (float& value : carried) {
    value += static_cast<float>(bounce * step.sine());
    step.advance();
  }
  double heel_s = 0.0;
  while (heel_s < time_s) {
    add_half_sine(carried, heel_s, draw(0.03, 0.08), heel);
    heel_s += 1.0 / walk_hz;
  }
  turn(0.0, time_s, draw(-30.0, 30.0) * degree);
  at_ += length;
}

void Story::put_down() {
  add_half_sine(from_now(motion_.carried), 0.0, draw(0.005, 0.03), draw(1.0, 6.0));
  at_ += steps(0.03 + draw(0.5, 3.5));
}

void Story::drive() {
  const std::size_t length = steps(draw(1.0, 3.0));
  const std::span<float> carried = from_now(motion_.carried).first(length);
  add_band_noise(carried, draw(0.1, 0.4), draw(2.0, 5.0), random_);
  add_band_noise(carried, draw(0.1, 1.1), draw_log(10.0, 150.0), random_);
  const auto holes = static_cast<int>(draw(0.0, 3.0));
  for (int i = 0; i < holes; ++i) {
    add_half_sine(carried, draw(0.0, 1.0), draw(0.015, 0.06), draw(1.0, 6.0));
  }
  at_ += length;
}

}  // namespace fantail::detection
