// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "bench/signal.hpp"
#include "bench/turn_figures.hpp"

namespace fantail::bench {
namespace {

constexpr std::size_t time_to_settle = 180;
constexpr std::size_t before_step = 60;
constexpr double least_share = 0.15;  // of the step commanded; less is not a step

// The rest of a hold, once the canard stands; all of it when it is too short for that.
Window settled(const Window& hold) {
  return hold.size() > time_to_settle + before_step ? Window{hold.begin + time_to_settle, hold.end} : hold;
}

double overshoot_rad(const Course& course, const Window& hold, double from_rad, double to_rad) {
  constexpr std::size_t length = 5;
  double farthest = 0.0;
  for (std::size_t begin = hold.begin; begin + length <= hold.end; ++begin) {
    double sum = 0.0;
    for (std::size_t i = begin; i < begin + length; ++i) {
      sum += course.encoder_rad[i];
    }
    const double beyond = (sum / static_cast<double>(length) - to_rad) * (to_rad > from_rad ? 1.0 : -1.0);
    farthest = beyond > farthest ? beyond : farthest;  // false for what was not read
  }
  return farthest;
}

}  // namespace

void add_steps(const Course& course, Part widest, Figures& f) {
  if (const std::size_t begin = step_begin(course, Part::step_out); begin < course.size()) {
    const Window hold = while_command_stands(course, begin);
    const auto from = level_rad(course, {begin > before_step ? begin - before_step : 0, begin});
    const auto to = level_rad(course, settled(hold));
    const double told_rad = course.command_rad[begin] - course.command_rad[begin - 1];
    if (from && to && std::abs(*to - *from) > least_share * std::abs(told_rad)) {
      f.step_time_s = rise_time_s(course, hold, *from, *to);
      f.overshoot_rad = overshoot_rad(course, hold, *from, *to);
    }
    if (widest == Part::step_out) {
      f.told_positive_rad = course.command_rad[begin];
      f.reached_positive_rad = to;
    }
  }
  const std::size_t across = step_begin(course, widest);
  if (across < course.size() && f.sign.value_or(0) != 0) {
    f.slew_rad_s = fastest_rad_s(course, while_command_stands(course, across));
    f.slew_way_rad = std::abs(course.command_rad[across] - course.command_rad[across - 1]);
  }
}

}  // namespace fantail::bench
