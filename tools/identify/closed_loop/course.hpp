// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "identify/closed_loop/loop.hpp"
#include "identify/model/roll_model.hpp"

namespace fantail::identify::closed_loop {

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
  core::Adaptation adaptation;
  Law law;
};

/// The roll equation of a sub-step: in the air at its middle.
struct CourseAir {
  double duration_s;
  model::RollEquation equation;
};

/// A record cut into sub-steps of about a controller period. A sample's sub-steps begin at it and end at the next one;
/// the last sample of a segment has one of no length, so that the command there is computed too.
struct Course {
  const model::Record* record;
  core::ControllerPlan controller;
  std::size_t node_count;
  std::vector<std::size_t> first_step;  ///< of each sample, and one more for the end
  std::vector<CourseStep> steps;
  std::vector<CourseAir> air;
  std::vector<Servo> servo;  ///< empty: the canard is where it was told to be
  double half_play_rad;
  bool holds;  ///< some sub-steps hold the command of an earlier one

  /// A lag above zero, or none without any play.
  void set_servo(double lag_s, double play_rad);

  [[nodiscard]] std::size_t segments() const { return record->segment_begin.size(); }
  [[nodiscard]] std::size_t segment_begin(std::size_t segment) const { return record->segment_begin[segment]; }
  [[nodiscard]] std::size_t segment_end(std::size_t segment) const {
    return segment + 1 < segments() ? segment_begin(segment + 1) : record->size();
  }
  /// Where the lagging canards stand at a sample, as far as that is known.
  [[nodiscard]] double canard_at(std::size_t sample) const {
    return record->canard_rad.empty() ? 0.0 : record->canard_rad[sample];
  }
};

/// The controller drives. Reference and in_control hold from sample to sample; the excitation, which swings within a
/// few samples of a slow log, runs straight, as do the estimate of the offset and the speed of the gain schedule. The
/// record must live as long as the course. Throws text::Error: bad_data when the record lacks the reference, or what
/// the modes of the law need (the estimate of the offset, the speed that the law went by); bad_configuration for a
/// period that is not above zero or a lag below zero.
[[nodiscard]] Course make_course(const model::Record& record, const model::Airframe& airframe, const Control& control,
                                 const model::NodeTimes& node_time_s);

enum class Slopes : std::uint8_t { none, by_alpha };

/// The plant of one alpha: what each sub-step does.
struct Plant {
  std::vector<model::HeldStep> step{};
  std::vector<model::HeldStep> by_alpha{};  ///< derivatives; empty unless asked for

  /// Memory is used again.
  void set_alpha(const Course& course, double alpha_m2, Slopes slopes);
};

}  // namespace fantail::identify::closed_loop
