// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/pd_controller.hpp"
#include "identify/closed_loop_course.hpp"

namespace fantail::identify {

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

/// What besides the nodes is unknown. The order of all unknowns is: alpha, beta, nodes, angle and rate at the begin of
/// each segment. One segment's derivatives stand in another order, because the nodes that are felt grow in number:
/// initial angle and rate, alpha, beta, then nodes from the first that this segment feels.
struct Unknowns {
  bool initial;  ///< angle and rate at the begin of each segment
  bool model;    ///< alpha and beta; all lanes have one alpha

  [[nodiscard]] std::size_t count(std::size_t node_count, std::size_t segments) const {
    return (model ? 2U : 0U) + node_count + (initial ? 2U * segments : 0U);
  }
  [[nodiscard]] std::size_t columns_before_nodes() const { return (initial ? 2U : 0U) + (model ? 2U : 0U); }
  /// Where a segment's column stands among the unknowns.
  [[nodiscard]] std::size_t place(std::size_t column, std::size_t first_node, std::size_t node_count,
                                  std::size_t segment) const {
    const std::size_t before_nodes = model ? 2U : 0U;
    if (initial && column < 2) {
      return before_nodes + node_count + 2 * segment + column;
    }
    const std::size_t rest = column - (initial ? 2U : 0U);
    return rest < before_nodes ? rest : rest + first_node;
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
  std::vector<Lane<lanes>> canard{};

  Tangents(Unknowns which, std::size_t node_count) : unknowns{which} {
    for (auto* columns : {&angle, &rate, &command, &canard}) {
      columns->resize(which.columns_before_nodes() + node_count);
    }
  }

  void begin_segment(std::size_t node) {
    for (auto* columns : {&angle, &rate, &command, &canard}) {
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
  void feel(std::size_t node) { active = std::max(active, unknowns.columns_before_nodes() + node + 1 - first_node); }
};

namespace detail {

template <std::size_t lanes>
struct LaneState {
  Lane<lanes> angle_rad{};
  Lane<lanes> rate_rad_s{};
  Lane<lanes> command_rad{};
  Lane<lanes> canard_rad{};
  Lane<lanes> effective_rad{};     ///< canard and disturbance, mean over the sub-step
  Lane<lanes> command_by_angle{};  ///< zero while saturated
  Lane<lanes> command_by_rate{};
};

template <std::size_t lanes>
void run_law(const core::ControllerPlan& plan, const CourseStep& step, LaneState<lanes>& state) {
  if (step.law == Law::rests) {
    state.command_rad.fill(0.0);
    state.command_by_angle.fill(0.0);
    state.command_by_rate.fill(0.0);
    return;
  }
  for (std::size_t l = 0; l < lanes; ++l) {
    const core::RollCommand command =
        core::pd_controller(plan, step.reference, core::Angle::from_radians(static_cast<float>(state.angle_rad[l])),
                            static_cast<float>(state.rate_rad_s[l]), step.excitation);
    const bool free = command.finite && !command.saturated;
    state.command_rad[l] = static_cast<double>(command.command.radians());
    state.command_by_angle[l] = free ? -static_cast<double>(plan.proportional_gain) : 0.0;
    state.command_by_rate[l] = free ? -static_cast<double>(plan.derivative_gain_s) : 0.0;
  }
}

// The canard is the command, and the command is new: two numbers a column, by one 2 x 2 matrix.
template <std::size_t lanes>
void advance_direct(const CourseTransition& transition, const Lane<lanes>& beta_m, const LaneState<lanes>& state,
                    Tangents<lanes>& tangents) {
  Lane<lanes> angle_by_angle;
  Lane<lanes> angle_by_rate;
  Lane<lanes> rate_by_angle;
  Lane<lanes> rate_by_rate;
  for (std::size_t l = 0; l < lanes; ++l) {
    const double by_angle = beta_m[l] * state.command_by_angle[l];
    const double by_rate = beta_m[l] * state.command_by_rate[l];
    angle_by_angle[l] = 1.0 + transition.angle_gain * by_angle;
    angle_by_rate[l] = transition.c1_s + transition.angle_gain * by_rate;
    rate_by_angle[l] = transition.rate_gain * by_angle;
    rate_by_rate[l] = transition.decay + transition.rate_gain * by_rate;
  }
  for (std::size_t column = 0; column < tangents.active; ++column) {
    Lane<lanes>& angle = tangents.angle[column];
    Lane<lanes>& rate = tangents.rate[column];
    for (std::size_t l = 0; l < lanes; ++l) {
      const double before = angle[l];
      angle[l] = angle_by_angle[l] * before + angle_by_rate[l] * rate[l];
      rate[l] = rate_by_angle[l] * before + rate_by_rate[l] * rate[l];
    }
  }
}

template <std::size_t lanes>
void advance_lagged(const CourseStep& step, const CourseServo& servo, const CourseTransition& transition,
                    const Lane<lanes>& beta_m, const LaneState<lanes>& state, Tangents<lanes>& tangents) {
  const bool anew = step.law != Law::holds;
  for (std::size_t column = 0; column < tangents.active; ++column) {
    Lane<lanes>& angle = tangents.angle[column];
    Lane<lanes>& rate = tangents.rate[column];
    Lane<lanes>& command = tangents.command[column];
    Lane<lanes>& canard = tangents.canard[column];
    for (std::size_t l = 0; l < lanes; ++l) {
      if (anew) {
        command[l] = state.command_by_angle[l] * angle[l] + state.command_by_rate[l] * rate[l];
      }
      const double behind = canard[l] - command[l];
      const double x = beta_m[l] * (command[l] + servo.mean_share * behind);
      canard[l] = command[l] + servo.decay * behind;
      angle[l] += transition.c1_s * rate[l] + transition.angle_gain * x;
      rate[l] = transition.decay * rate[l] + transition.rate_gain * x;
    }
  }
}

// What the unknowns do to the state directly, apart from what they did to it before.
template <std::size_t lanes>
void add_sources(const CourseStep& step, const CourseTransition& transition, const CourseTransition* slope,
                 const Lane<lanes>& beta_m, const LaneState<lanes>& state, Tangents<lanes>& tangents) {
  const std::size_t nodes = tangents.unknowns.columns_before_nodes() - tangents.first_node;
  const double next_share = step.next_share;
  for (std::size_t l = 0; l < lanes; ++l) {
    const double angle_by_node = beta_m[l] * transition.angle_gain;
    const double rate_by_node = beta_m[l] * transition.rate_gain;
    tangents.angle[nodes + step.node][l] += angle_by_node * (1.0 - next_share);
    tangents.rate[nodes + step.node][l] += rate_by_node * (1.0 - next_share);
    tangents.angle[nodes + step.next_node][l] += angle_by_node * next_share;
    tangents.rate[nodes + step.next_node][l] += rate_by_node * next_share;
  }
  if (slope != nullptr) {
    const std::size_t alpha = tangents.unknowns.initial ? 2 : 0;
    const std::size_t beta = alpha + 1;
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = beta_m[l] * state.effective_rad[l];
      tangents.angle[alpha][l] += slope->c1_s * state.rate_rad_s[l] + slope->angle_gain * x;
      tangents.rate[alpha][l] += slope->decay * state.rate_rad_s[l] + slope->rate_gain * x;
      tangents.angle[beta][l] += transition.angle_gain * state.effective_rad[l];
      tangents.rate[beta][l] += transition.rate_gain * state.effective_rad[l];
    }
  }
}

template <std::size_t lanes>
void move_canards(const CourseStep& step, const CourseServo& servo, const LanePoints<lanes>& points,
                  LaneState<lanes>& state) {
  const Lane<lanes>& node_rad = points.node_rad[step.node];
  const Lane<lanes>& next_rad = points.node_rad[step.next_node];
  for (std::size_t l = 0; l < lanes; ++l) {
    const double behind_rad = state.canard_rad[l] - state.command_rad[l];
    state.effective_rad[l] = state.command_rad[l] + servo.mean_share * behind_rad +
                             (node_rad[l] + step.next_share * (next_rad[l] - node_rad[l]));
    state.canard_rad[l] = state.command_rad[l] + servo.decay * behind_rad;
  }
}

template <std::size_t lanes>
void advance(const CourseTransition& transition, const Lane<lanes>& beta_m, LaneState<lanes>& state) {
  for (std::size_t l = 0; l < lanes; ++l) {
    const double x = beta_m[l] * state.effective_rad[l];
    state.angle_rad[l] += transition.c1_s * state.rate_rad_s[l] + transition.angle_gain * x;
    state.rate_rad_s[l] = transition.decay * state.rate_rad_s[l] + transition.rate_gain * x;
  }
}

}  // namespace detail

/// Flies all lanes through the record. `sink` is told
///   at_sample(sample, angles, rates) before a sample's first sub-step,
///   at_command(sample, commands) when the controller has answered it, and
///   end_segment(segment) when the segment's last sample has been told.
/// With `tangents` (asked for at compile time, because a flight without them takes half the time) they hold the
/// derivatives whenever the sink is told.
template <std::size_t lanes, bool with_tangents, class Sink>
void fly_lanes(const Course& course, const Transitions& transitions, const LanePoints<lanes>& points,
               Tangents<lanes>* tangents, Sink& sink) {
  static constexpr CourseServo no_servo{.decay = 0.0, .mean_share = 0.0};
  const bool direct = course.servo.empty() && !course.holds;
  detail::LaneState<lanes> state;
  for (std::size_t segment = 0; segment < course.segments(); ++segment) {
    const std::size_t begin = course.segment_begin(segment);
    const std::size_t end = course.segment_end(segment);
    state.angle_rad = points.angle_rad[segment];
    state.rate_rad_s = points.rate_rad_s[segment];
    state.canard_rad.fill(course.canard_at(begin));
    if constexpr (with_tangents) {
      tangents->begin_segment(course.steps[course.first_step[begin]].node);
    }
    for (std::size_t sample = begin; sample < end; ++sample) {
      sink.at_sample(sample, state.angle_rad, state.rate_rad_s);
      const std::size_t first = course.first_step[sample];
      for (std::size_t i = first; i < course.first_step[sample + 1]; ++i) {
        const CourseStep& step = course.steps[i];
        const CourseServo& servo = course.servo.empty() ? no_servo : course.servo[i];
        const CourseTransition& transition = transitions.value[i];
        if (step.law != Law::holds) {
          detail::run_law(course.controller, step, state);
        }
        if (i == first) {
          sink.at_command(sample, state.command_rad);
        }
        detail::move_canards(step, servo, points, state);
        if constexpr (with_tangents) {
          tangents->feel(step.next_node);
          if (direct) {
            detail::advance_direct(transition, points.beta_m, state, *tangents);
          } else {
            detail::advance_lagged(step, servo, transition, points.beta_m, state, *tangents);
          }
          const CourseTransition* slope = tangents->unknowns.model ? &transitions.slope[i] : nullptr;
          detail::add_sources(step, transition, slope, points.beta_m, state, *tangents);
        }
        detail::advance(transition, points.beta_m, state);
      }
    }
    sink.end_segment(segment);
  }
}

}  // namespace fantail::identify
