// SPDX-License-Identifier: MIT
// From the pad to the first opening of a parachute.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "detection/shapes.hpp"
#include "detection/story.hpp"

namespace fantail::detection {
namespace {

constexpr double longest_way_up_s = 13.0;
constexpr double late_s = 0.3;  // a detection that is so late after the burn is still of this launch

}  // namespace

Story::Story(Streams& streams, Motion& motion, bool all)
    : streams_{streams}, random_{streams.model}, motion_{motion}, all_{all}, at_{steps(lead_s)}, pitch_rad_{} {
  pitch_rad_ = draw(0.0, 15.0 * degree);
  motion.begin(Motion::most, pitch_rad_);
  motion.turns = motion.rolls = true;
  ignition_ = steps(0.25 + draw(0.0, 0.1));
}

double Story::draw(double low, double high) { return uniform(random_, low, high); }
double Story::draw_log(double low, double high) { return log_uniform(random_, low, high); }

void Story::turn(double after_s, double time_s, double angle_rad) {
  add_half_sine(from_now(motion_.pitch_rate_rad_s), after_s, time_s, angle_rad * std::numbers::pi / (2.0 * time_s));
  pitch_rad_ += angle_rad;
}

double Story::any_hanging_rad() {
  const double third = draw(0.0, 3.0);
  const double size = third < 1.0   ? draw(0.0, 60.0)      // nose up
                      : third < 2.0 ? draw(60.0, 120.0)    // across
                                    : draw(120.0, 180.0);  // nose down
  return size * degree * (one_in(2.0) ? 1.0 : -1.0);
}

void Story::fly_missed() {
  const double way = draw(0.0, 5.0);
  SensorTrouble& trouble = motion_.trouble;
  trouble.accelerometer = one_in(2.0) ? 0 : 1;
  Burn burn{.peak = 0.0, .rise_s = draw_log(0.01, 0.3), .sag_per_s = draw(0.0, 0.1), .burn_s = 0.0, .least = g};
  double rms_g = draw(0.0, 1.0);
  if (way < 1.0) {
    burn.peak = draw(1.6, 2.45) * g;
    burn.burn_s = draw(2.0, 4.0);
  } else if (way < 2.0) {
    burn.peak = draw_log(5.0, 15.0) * g;
    burn.burn_s = draw(0.5, 2.0);
    const double apart = draw(2.1, 4.0) * g;
    if (one_in(2.0)) {
      trouble.low = {0, Motion::most};
      trouble.low_share = static_cast<float>(apart / burn.peak);
    } else {
      trouble.low = {ignition_, ignition_ + steps(burn.burn_s)};
      trouble.low_by_m_s2 = static_cast<float>(apart);
    }
  } else if (way < 3.0) {
    burn.peak = draw_log(4.0, 12.0) * g;
    burn.burn_s = draw(0.5, 2.0);
    trouble.accelerometer_silent = {ignition_ - steps(0.1), ignition_ + steps(burn.burn_s + draw(0.0, 1.0))};
  } else if (way < 4.0) {
    burn.peak = draw_log(10.0, 25.0) * g;
    burn.rise_s = 0.01;
    burn.burn_s = draw(0.1, 0.19);
  } else {
    burn.peak = draw(3.0, 5.0) * g;
    burn.burn_s = draw(1.0, 2.5);
    rms_g = 2.0;
  }
  fly(burn, rms_g);
}

void Story::fly_uncontrolled() {
  const double way = draw(0.0, 3.0);
  SensorTrouble& trouble = motion_.trouble;
  trouble.accelerometer = one_in(2.0) ? 0 : 1;
  Burn burn{.peak = draw_log(4.0, 12.0) * g,
            .rise_s = draw_log(0.01, 0.1),
            .sag_per_s = draw(0.0, 0.1),
            .burn_s = draw(0.6, 2.0),
            .least = g};
  if (way < 1.0) {
    trouble.gyro_silent = {ignition_ - steps(draw(0.0, 0.2)), ignition_ + steps(burn.burn_s + draw(0.0, 2.0))};
  } else if (way < 2.0) {
    burn.peak = draw(3.0, 4.0) * g;
    burn.burn_s = draw(0.4, 0.6);
  } else {
    trouble.low = {ignition_ + steps(draw(0.15, 0.3)), ignition_ + steps(burn.burn_s + 2.0)};
    trouble.low_by_m_s2 = static_cast<float>(draw(2.1, 4.0) * g);
  }
  fly(burn, draw(0.0, 1.0));
}

void Story::fly(const Burn& burn, double rms_g) {
  constexpr double fastest_m_s = 70.0;
  Burn shorter = burn;
  shorter.burn_s = std::min(burn.burn_s, fastest_m_s / (burn.peak - g));
  const std::size_t burnt_out = ignition_ + steps(shorter.burn_s);
  motion_.flight_end = burnt_out + steps(late_s);
  motion_.length = ignition_ + steps(longest_way_up_s);
  const std::size_t highest = rise(shorter, {.rms_m_s2 = rms_g * g, .frequency_hz = draw_log(40.0, 450.0)}, pitch_rad_,
                                   0, ignition_, streams_, motion_, all_);
  motion_.length = Motion::most;
  at_ = burnt_out;
  begin(Part::coast);
  // The ejection's kick, up to a second early and two late, and then the parachute streams out.
  const double way_up_s = step_s * static_cast<double>(highest - burnt_out);
  const double ejection_s = std::max(0.3, way_up_s + draw(-1.0, 2.0));
  const double streaming_s = draw(0.1, 1.0);
  const std::size_t opening = burnt_out + steps(ejection_s + streaming_s);
  const auto fill = [](std::array<float, Motion::most>& values, std::size_t first, std::size_t last, float value) {
    if (first < last) {
      std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(first), last - first, value);
    }
  };
  fill(motion_.carried, highest, opening, 0.0F);
  fill(motion_.carried, opening, highest, 1.0F);
  fill(motion_.axial_m_s2, opening, highest, 0.0F);
  add_half_sine(from_now(motion_.axial_m_s2), ejection_s, draw(0.003, 0.01), draw(-15.0, 15.0) * g);
  const double turning_s = std::min(draw(0.3, 3.0), ejection_s + streaming_s);
  turn(ejection_s + streaming_s - turning_s, turning_s, any_hanging_rad() - pitch_rad_);
  // It rolls faster until it has burnt out, and then evenly.
  const double roll_rad_s = draw_log(1.0, 720.0) * degree * (one_in(2.0) ? 1.0 : -1.0);
  const double risen = roll_rad_s / static_cast<double>(burnt_out - ignition_);
  for (std::size_t i = ignition_; i < opening; ++i) {
    motion_.roll_rate_rad_s[i] =
        static_cast<float>(i < burnt_out ? risen * static_cast<double>(i - ignition_) : roll_rad_s);
  }
  at_ = opening;
}

void make_missed_flight(Streams& streams, Motion& motion, bool all) {
  Story story{streams, motion, all};
  story.fly_missed();
  story.come_down();
  story.be_carried_home();
}

void make_uncontrolled_flight(Streams& streams, Motion& motion, bool all) {
  Story story{streams, motion, all};
  story.fly_uncontrolled();
  story.come_down();
  story.be_carried_home();
}

}  // namespace fantail::detection
