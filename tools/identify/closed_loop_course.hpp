// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "identify/identification.hpp"

namespace fantail::identify {

/// Where a sub-step's command comes from.
enum class Law : std::uint8_t {
  runs,   ///< the controller computes a new one
  holds,  ///< the log is faster than the controller: the last one still stands
  rests,  ///< zero outside control
};

/// What a sub-step is fed with, whatever alpha, beta and the disturbance are. The command holds over it.
struct CourseStep {
  double next_share;  ///< the disturbance is (1 - next_share) of `node` and next_share of `next_node`
  std::uint32_t node;
  std::uint32_t next_node;  ///< the same as `node` outside the nodes
  core::Angle reference;
  core::Angle excitation;
  Law law;
};

/// The air of a sub-step: at its middle.
struct CourseAir {
  double duration_s;
  double damping_per_alpha;   ///< 1/s for each m2: 1/2 rho |v| A / I
  double authority_per_beta;  ///< 1/s2 for each m: 1/2 rho v^2 A / I
};

/// First-order lag over a sub-step.
struct CourseServo {
  double decay;       ///< how much of the distance to the command is left at the end
  double mean_share;  ///< and on average
};

/// A record cut into sub-steps of about a controller period. A sample's sub-steps begin at it and end at the next one;
/// the last sample of a segment has one of no length, so that the command there is computed too.
struct Course {
  const Record* record;
  core::ControllerPlan controller;
  std::size_t node_count;
  std::vector<std::size_t> first_step;  ///< of each sample, and one more for the end
  std::vector<CourseStep> steps;
  std::vector<CourseAir> air;
  std::vector<CourseServo> servo;  ///< empty: the canard is where it was told to be
  bool holds;                      ///< some sub-steps hold the command of an earlier one

  [[nodiscard]] std::size_t segments() const { return record->segment_begin.size(); }
  [[nodiscard]] std::size_t segment_begin(std::size_t segment) const { return record->segment_begin[segment]; }
  [[nodiscard]] std::size_t segment_end(std::size_t segment) const {
    return segment + 1 < segments() ? segment_begin(segment + 1) : record->size();
  }
  /// Where the lagging canards stand at a sample, as far as anybody knows.
  [[nodiscard]] double canard_at(std::size_t sample) const {
    return record->canard_rad.empty() ? 0.0 : record->canard_rad[sample];
  }
};

/// The controller drives. Reference and in_control hold from sample to sample; the excitation, which swings within a
/// few samples of a slow log, runs straight. The record must live as long as the course. Throws sim::InputError:
/// bad_data when the record has no reference, bad_configuration for a period that is not above zero or a lag below
/// zero.
[[nodiscard]] Course closed_loop_course(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                                        const NodeTimes& node_time_s);

/// What each sub-step does for one alpha: rate and angle gain
///   p' = decay p + rate_gain x,   phi' = phi + c1 p + angle_gain x   from   x = beta (canard + disturbance).
struct CourseTransition {
  double decay;
  double c1_s;
  double rate_gain;
  double angle_gain;
};
struct Transitions {
  std::vector<CourseTransition> value;
  std::vector<CourseTransition> slope;  ///< derivatives by alpha; empty unless asked for
};

enum class Slopes : std::uint8_t { none, by_alpha };

/// `transitions` is overwritten; its memory is used again.
void fill_transitions(const Course& course, double alpha_m2, Slopes slopes, Transitions& transitions);

}  // namespace fantail::identify
