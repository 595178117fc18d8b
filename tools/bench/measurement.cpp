// SPDX-License-Identifier: MIT
#include "bench/measurement.hpp"

#include <algorithm>
#include <cmath>

#include "bench/readings.hpp"
#include "bench/trace.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

constexpr double moves = 0.15;  // less slope than this is not a movement
constexpr std::size_t usual_delay = 4;
constexpr double usual_lag_s = 0.02;

bool ramp(Part part) {
  return part == Part::ramp_positive || part == Part::return_from_positive || part == Part::ramp_negative ||
         part == Part::return_from_negative;
}

// Everything slow, before the first step: at a step a rate limit bends the answer, which a lag alone cannot explain.
Window before_steps(const CanardTrace& trace) {
  const auto step = std::ranges::find(trace.part, Part::step_out);
  return {0, static_cast<std::size_t>(step - trace.part.begin())};
}

// The command as this canard follows it; as a usual servo would when it follows nothing.
std::vector<double> follow(const CanardTrace& trace, const Window& window, Figures& f) {
  const std::optional<LagFit> fit = fit_lag(trace, window);
  std::vector<double> model = fit ? lagged(trace.command_rad, fit->delay_ticks, fit->lag_s)
                                  : lagged(trace.command_rad, usual_delay, usual_lag_s);
  if (const auto line = regress(model, trace, window)) {
    f.slope = line->slope;
    f.sign = line->slope > moves ? 1 : line->slope < -moves ? -1 : 0;
    if (fit && f.sign != 0) {
      f.lag_s = fit->total_s();
    }
  }
  return model;
}

}  // namespace

bool beyond_bus(double angle_rad) { return std::abs(angle_rad) > text::radians(20.46); }

Figures measure(const link::Recording& recording, const Exercise& exercise, const Turn& turn, std::size_t canard) {
  Figures f;
  const CanardTrace own = trace_of(recording, exercise, turn, canard);
  f.received_ticks = own.received;
  f.dropouts = own.dropouts;
  f.undriven = own.undriven;
  if (own.size() == 0) {
    return f;
  }
  double largest_rad = 0.0;
  for (const double command_rad : own.command_rad) {
    largest_rad = std::max(largest_rad, std::abs(command_rad));
  }
  f.largest_command_rad = largest_rad;
  add_rest(own, f);

  Window window{0, own.size()};
  if (exercise.kind() == ExerciseKind::limits) {
    window = before_steps(own);
  }
  const std::vector<double> model = follow(own, window, f);
  switch (exercise.kind()) {
    case ExerciseKind::limits:
      f.tracking_error_rad = largest_difference_rad(own, model, ramp);
      f.tracking_rms_rad = rms_difference_rad(own, model, ramp);
      add_ends(own, f);
      add_centre(own, f);
      add_steps(own, Part::step_across, f);
      break;
    case ExerciseKind::step: add_steps(own, Part::step_out, f); break;
    case ExerciseKind::sine:
      add_wave(own, exercise.wave()->frequency_hz, f);
      add_sent_wave(own, exercise, canard, f);
      break;
  }
  if (!turn.canard) {
    return f;
  }
  // Another canard that moves with this one's command, and by how much over this one's whole way to one side. A slope,
  // and not the distance it moved: noise has distance, and its slope is nothing.
  for (std::size_t other = 0; other < core::canard_count; ++other) {
    const CanardTrace others = other == canard ? CanardTrace{} : trace_of(recording, exercise, turn, other);
    const auto line = others.size() == own.size() ? regress(model, others, window) : std::nullopt;
    if (!line) {
      continue;
    }
    const double way_rad = std::abs(line->slope) * largest_rad;
    if (!f.others_moved_rad || way_rad > *f.others_moved_rad) {
      f.others_moved_rad = way_rad;
      f.other_canard = other;
    }
  }
  return f;
}

std::optional<double> slowest_ratio(const link::Recording& recording, const Exercise& exercise, const Turn& turn,
                                    std::size_t canard, const sim::CanardTolerances& tolerances) {
  CanardTrace trace = trace_of(recording, exercise, turn, canard);
  if (trace.size() == 0) {
    return std::nullopt;
  }
  const double factor = 1.0 - std::exp(-tick_s * std::log(9.0) / tolerances.longest_step_time_s);
  const double most_rad = tick_s * tolerances.slowest_slew_rad_s;
  double angle_rad = trace.command_rad.front();
  for (std::size_t i = 0; i < trace.size(); ++i) {
    trace.encoder_rad[i] = angle_rad;
    angle_rad += std::clamp(factor * (trace.command_rad[i] - angle_rad), -most_rad, most_rad);
  }
  Figures slowest;
  add_wave(trace, exercise.wave()->frequency_hz, slowest);
  return slowest.amplitude_ratio;
}

}  // namespace fantail::bench
