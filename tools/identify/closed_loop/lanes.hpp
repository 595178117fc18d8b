// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "identify/closed_loop/course.hpp"
#include "identify/closed_loop/loop.hpp"

namespace fantail::identify::closed_loop {

// Several candidates ("lanes") of one alpha are flown side by side. One flight is a chain of operations that wait for
// each other; several chains keep the processor busy, and their numbers lie beside each other as its wide registers
// want them.

template <std::size_t lanes>
using Lane = std::array<double, lanes>;

/// What tells the lanes apart.
template <std::size_t lanes>
struct LanePoints {
  Lane<lanes> beta_m{};
  std::vector<Lane<lanes>> node_rad{};
  std::vector<Lane<lanes>> angle_rad{};   ///< at the begin of each segment
  std::vector<Lane<lanes>> rate_rad_s{};  ///< likewise
};

/// What besides the nodes is unknown. The order of all unknowns is: alpha, beta, lag and half play, nodes, angle and
/// rate at the begin of each segment. One segment's derivatives stand in another order, because the nodes that are felt
/// grow in number: initial angle and rate, alpha, beta, lag and play, then nodes from the first that this segment
/// feels.
struct Unknowns {
  bool initial;        ///< angle and rate at the begin of each segment
  bool model;          ///< alpha and beta; all lanes have one alpha
  bool servo = false;  ///< its lag and half of its play; with `model` only

  [[nodiscard]] std::size_t before_nodes() const { return (model ? 2U : 0U) + (servo ? 2U : 0U); }
  [[nodiscard]] std::size_t count(std::size_t node_count, std::size_t segments) const {
    return before_nodes() + node_count + (initial ? 2U * segments : 0U);
  }
  [[nodiscard]] std::size_t columns_before_nodes() const { return (initial ? 2U : 0U) + before_nodes(); }
  /// Where a segment's column stands among the unknowns.
  [[nodiscard]] std::size_t place(std::size_t column, std::size_t first_node, std::size_t node_count,
                                  std::size_t segment) const {
    if (initial && column < 2) {
      return before_nodes() + node_count + 2 * segment + column;
    }
    const std::size_t rest = column - (initial ? 2U : 0U);
    return rest < before_nodes() ? rest : rest + first_node;
  }
};

template <std::size_t lanes>
struct LaneState {
  Lane<lanes> angle_rad{};
  Lane<lanes> rate_rad_s{};
  Lane<lanes> command_rad{};
  Lane<lanes> gear_rad{};
  Lane<lanes> canard_rad{};
  Lane<lanes> apart_rad{};     ///< gear from command, at the begin of the sub-step
  Lane<lanes> side_of_mean{};  ///< Played::side, of the mean and of the end of the sub-step
  Lane<lanes> side{};
  Lane<lanes> effective_rad{};     ///< canard and disturbance, mean over the sub-step
  Lane<lanes> command_by_angle{};  ///< zero while saturated
  Lane<lanes> command_by_rate_s{};

  void run_law(const core::ControllerPlan& plan, const CourseStep& step) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const Command command = law(plan, step.reference, step.excitation, step.adaptation, angle_rad[l], rate_rad_s[l]);
      command_rad[l] = command.command_rad;
      command_by_angle[l] = command.by_angle;
      command_by_rate_s[l] = command.by_rate_s;
    }
  }

  void rest() {
    command_rad.fill(0.0);
    command_by_angle.fill(0.0);
    command_by_rate_s.fill(0.0);
  }

  void move_canards(const CourseStep& step, const Servo& servo, double half_play_rad, const LanePoints<lanes>& points) {
    const Lane<lanes>& node_rad = points.node_rad[step.node];
    const Lane<lanes>& next_rad = points.node_rad[step.next_node];
    for (std::size_t l = 0; l < lanes; ++l) {
      apart_rad[l] = gear_rad[l] - command_rad[l];
      const Played mean = follow(canard_rad[l], servo.mean(gear_rad[l], command_rad[l]), half_play_rad);
      gear_rad[l] = servo.end(gear_rad[l], command_rad[l]);
      const Played end = follow(canard_rad[l], gear_rad[l], half_play_rad);
      effective_rad[l] = mean.canard_rad + (node_rad[l] + step.next_share * (next_rad[l] - node_rad[l]));
      canard_rad[l] = end.canard_rad;
      side_of_mean[l] = mean.side;
      side[l] = end.side;
    }
  }

  void roll(const model::HeldStep& plant, const Lane<lanes>& beta_m) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = beta_m[l] * effective_rad[l];
      angle_rad[l] += plant.angle_change(rate_rad_s[l], x);
      rate_rad_s[l] = plant.rate_after(rate_rad_s[l], x);
    }
  }
};

/// Derivatives of the state by the unknowns, in the order of a segment's columns.
template <std::size_t lanes>
struct Tangents {
  Unknowns unknowns;
  std::size_t first_node = 0;
  std::size_t active = 0;  ///< columns that are not all zero so far
  std::vector<Lane<lanes>> angle{};
  std::vector<Lane<lanes>> rate{};
  std::vector<Lane<lanes>> command{};
  std::vector<Lane<lanes>> gear{};
  std::vector<Lane<lanes>> canard{};

  Tangents(Unknowns which, std::size_t node_count) : unknowns{which} {
    for (auto* columns : {&angle, &rate, &command, &gear, &canard}) {
      columns->resize(which.columns_before_nodes() + node_count);
    }
  }

  void begin_segment(std::size_t node) {
    for (auto* columns : {&angle, &rate, &command, &gear, &canard}) {
      std::ranges::fill(*columns, Lane<lanes>{});
    }
    if (unknowns.initial) {
      angle[0].fill(1.0);
      rate[1].fill(1.0);
    }
    first_node = node;
    active = unknowns.columns_before_nodes();
  }

  /// From here on this node, and those before it, count.
  void activate(std::size_t node) {
    active = std::max(active, unknowns.columns_before_nodes() + node + 1 - first_node);
  }

  /// Without a servo and with a new command: two numbers a column, by one matrix.
  void advance_direct(const model::HeldStep& plant, const Lane<lanes>& beta_m, const LaneState<lanes>& state) {
    Lane<lanes> angle_by_angle;
    Lane<lanes> angle_by_rate_s;
    Lane<lanes> rate_by_angle;
    Lane<lanes> rate_by_rate;
    for (std::size_t l = 0; l < lanes; ++l) {
      const DirectLoop loop = direct_loop(plant, beta_m[l], state.command_by_angle[l], state.command_by_rate_s[l]);
      angle_by_angle[l] = loop.angle_by_angle;
      angle_by_rate_s[l] = loop.angle_by_rate_s;
      rate_by_angle[l] = loop.rate_by_angle;
      rate_by_rate[l] = loop.rate_by_rate;
    }
    for (std::size_t column = 0; column < active; ++column) {
      Lane<lanes>& angles = angle[column];
      Lane<lanes>& rates = rate[column];
      for (std::size_t l = 0; l < lanes; ++l) {
        const double before = angles[l];
        angles[l] = angle_by_angle[l] * before + angle_by_rate_s[l] * rates[l];
        rates[l] = rate_by_angle[l] * before + rate_by_rate[l] * rates[l];
      }
    }
  }

  void advance_lagged(const CourseStep& step, const Servo& servo, bool with_play, const model::HeldStep& plant,
                      const Lane<lanes>& beta_m, const LaneState<lanes>& state) {
    const bool anew = step.law != Law::holds;
    const std::size_t lag = unknowns.servo ? unknowns.columns_before_nodes() - 2 : canard.size();
    for (std::size_t column = 0; column < active; ++column) {
      Lane<lanes>& angles = angle[column];
      Lane<lanes>& rates = rate[column];
      Lane<lanes>& commands = command[column];
      Lane<lanes>& gears = gear[column];
      Lane<lanes>& canards = canard[column];
      for (std::size_t l = 0; l < lanes; ++l) {
        if (anew) {
          commands[l] = state.command_by_angle[l] * angles[l] + state.command_by_rate_s[l] * rates[l];
        }
        double mean = servo.mean(gears[l], commands[l]);
        gears[l] = servo.end(gears[l], commands[l]);
        if (column == lag) {
          mean += state.apart_rad[l] * servo.mean_by_lag_s;
          gears[l] += state.apart_rad[l] * servo.decay_by_lag_s;
        }
        if (with_play) {
          const double by_half_play = column == lag + 1 ? 1.0 : 0.0;
          mean = state.side_of_mean[l] == 0.0 ? canards[l] : mean + by_half_play * state.side_of_mean[l];
          canards[l] = state.side[l] == 0.0 ? canards[l] : gears[l] + by_half_play * state.side[l];
        }
        const double x = beta_m[l] * mean;
        angles[l] += plant.angle_change(rates[l], x);
        rates[l] = plant.rate_after(rates[l], x);
      }
    }
  }

  /// What the unknowns do to the state directly, apart from what they did to it before. `by_alpha` only where alpha and
  /// beta are unknown.
  void add_sources(const CourseStep& step, const model::HeldStep& plant, const model::HeldStep* by_alpha,
                   const Lane<lanes>& beta_m, const LaneState<lanes>& state) {
    const std::size_t nodes = unknowns.columns_before_nodes() - first_node;
    for (std::size_t l = 0; l < lanes; ++l) {
      const double angle_by_node = beta_m[l] * plant.angle_gain;
      const double rate_by_node = beta_m[l] * plant.rate_gain;
      angle[nodes + step.node][l] += angle_by_node * (1.0 - step.next_share);
      rate[nodes + step.node][l] += rate_by_node * (1.0 - step.next_share);
      angle[nodes + step.next_node][l] += angle_by_node * step.next_share;
      rate[nodes + step.next_node][l] += rate_by_node * step.next_share;
    }
    if (by_alpha != nullptr) {
      const std::size_t alpha = unknowns.initial ? 2 : 0;
      const std::size_t beta = alpha + 1;
      for (std::size_t l = 0; l < lanes; ++l) {
        const double x = beta_m[l] * state.effective_rad[l];
        angle[alpha][l] += by_alpha->angle_change(state.rate_rad_s[l], x);
        rate[alpha][l] += by_alpha->rate_after(state.rate_rad_s[l], x);
        angle[beta][l] += plant.angle_gain * state.effective_rad[l];
        rate[beta][l] += plant.rate_gain * state.effective_rad[l];
      }
    }
  }
};

/// Flies all lanes through the record. `sink` is told
///   at_sample(sample, angles, rates) before a sample's first sub-step,
///   at_command(sample, commands) when the controller has answered it, and
///   end_segment(segment) when the segment's last sample has been told.
/// With `tangents` (asked for at compile time, because a flight without them takes half the time) they hold the
/// derivatives whenever the sink is told.
template <std::size_t lanes, bool with_tangents, class Sink>
void fly_lanes(const Course& course, const Plant& plant, const LanePoints<lanes>& points, Tangents<lanes>* tangents,
               Sink& sink) {
  const bool direct = course.servo.empty() && !course.holds;
  LaneState<lanes> state;
  for (std::size_t segment = 0; segment < course.segments(); ++segment) {
    const std::size_t begin = course.segment_begin(segment);
    const std::size_t end = course.segment_end(segment);
    state.angle_rad = points.angle_rad[segment];
    state.rate_rad_s = points.rate_rad_s[segment];
    state.gear_rad.fill(course.canard_at(begin));
    state.canard_rad = state.gear_rad;
    if constexpr (with_tangents) {
      tangents->begin_segment(course.steps[course.first_step[begin]].node);
    }
    for (std::size_t sample = begin; sample < end; ++sample) {
      sink.at_sample(sample, state.angle_rad, state.rate_rad_s);
      const std::size_t first = course.first_step[sample];
      for (std::size_t i = first; i < course.first_step[sample + 1]; ++i) {
        const CourseStep& step = course.steps[i];
        const Servo& servo = course.servo.empty() ? no_servo : course.servo[i];
        if (step.law == Law::runs) {
          state.run_law(course.controller, step);
        } else if (step.law == Law::rests) {
          state.rest();
        }
        if (i == first) {
          sink.at_command(sample, state.command_rad);
        }
        state.move_canards(step, servo, course.half_play_rad, points);
        if constexpr (with_tangents) {
          tangents->activate(step.next_node);
          if (direct) {
            tangents->advance_direct(plant.step[i], points.beta_m, state);
          } else {
            tangents->advance_lagged(step, servo, course.half_play_rad > 0.0, plant.step[i], points.beta_m, state);
          }
          const model::HeldStep* by_alpha = tangents->unknowns.model ? &plant.by_alpha[i] : nullptr;
          tangents->add_sources(step, plant.step[i], by_alpha, points.beta_m, state);
        }
        state.roll(plant.step[i], points.beta_m);
      }
    }
    sink.end_segment(segment);
  }
}

}  // namespace fantail::identify::closed_loop
