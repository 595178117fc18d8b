// SPDX-License-Identifier: MIT
#include "detection/rehearsal.hpp"

#include <algorithm>
#include <cmath>

#include "core/autopilot.hpp"
#include "core/launch_detector.hpp"
#include "core/trig.hpp"

namespace fantail::detection {
namespace {

core::Microseconds time_of(std::size_t step) {
  return InputMaker::event_begin + core::Microseconds{static_cast<std::int64_t>(step) * 1'000};
}

core::AccelerometerSample axial_sample(const Readings& readings, std::size_t which, std::size_t step) {
  return {.time = time_of(step),
          .specific_force_m_s2 = {readings.axial_m_s2[which][step], 0.0F, 0.0F},
          .quality = readings.quality[which][step]};
}

float share_of_gate(const core::GuidePlan& guide, const core::Motion& motion) {
  const float distance = motion.distance_along_guide_m / (guide.length_m + guide.clearance_m);
  const float speed = guide.minimum_speed_m_s > 0.0F ? motion.speed_m_s / guide.minimum_speed_m_s : 1.0F;
  return std::max(0.0F, std::min(distance, speed));
}

/// Nothing more can come: control has begun or is over for good, or the launch was none and there is no time left for
/// the rest without which another one is not listened for.
bool is_settled(const core::FlightPlan& plan, const Answer& answer, core::Phase phase, std::size_t steps_left) {
  return answer.controlling || answer.flown || phase == core::Phase::finished ||
         (answer.detected && phase == core::Phase::armed &&
          core::Microseconds{static_cast<std::int64_t>(steps_left) * 1'000} < plan.motion.rest_time);
}

}  // namespace

bool fires(const core::FlightPlan& plan, const Readings& readings, std::size_t length) {
  core::LaunchDetector detector{plan.launch_detection, plan.motion.stale_time};
  for (std::size_t i = 0; i < length; ++i) {
    if (detector.update(time_of(i), {axial_sample(readings, 0, i), axial_sample(readings, 1, i)}) ==
        core::DetectionState::detected) {
      return true;
    }
  }
  return false;
}

Rehearsal::Rehearsal(std::span<const Rule> rules)
    : rules_{rules},
      motion_{std::make_unique<Motion>()},
      readings_{std::make_unique<Readings>()},
      answers_(rules.size()),
      wanted_(rules.size()),
      screened_(rules.size()),
      is_in_flight_(rules.size()) {}

const std::vector<Answer>& Rehearsal::play(std::uint64_t seed, Kind kind, std::uint64_t event, Path path) {
  answers_.assign(rules_.size(), {});
  is_in_flight_.assign(rules_.size(), false);
  Streams streams = streams_of(seed, kind, event);
  const bool whole = path == Path::full || is_launch(kind);
  make_event(kind, streams, *motion_, whole);
  begin_readings(kind, event, *motion_, streams.axial, *readings_);
  wanted_.assign(rules_.size(), whole);
  if (whole) {
    finish_readings(*motion_, streams.axial, *readings_);
  } else {
    if (!any_fires(streams.axial)) {
      return answers_;
    }
    // Once more, now with what goes on across the axis.
    streams = streams_of(seed, kind, event);
    make_event(kind, streams, *motion_, true);
  }
  fly(wanted_, streams.others);
  return answers_;
}

bool Rehearsal::any_fires(sim::Random& axial) {
  bool any = false;
  for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
    screened_[rule] = screened(rules_[rule].plan, *motion_, *readings_);
    any = any || screened_[rule] != Screened::quiet;
  }
  if (!any) {
    return false;
  }
  finish_readings(*motion_, axial, *readings_);
  any = false;
  for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
    wanted_[rule] = screened_[rule] == Screened::law_decides || (screened_[rule] == Screened::detector_decides &&
                                                                 fires(rules_[rule].plan, *readings_, motion_->length));
    any = any || wanted_[rule];
  }
  return any;
}

void Rehearsal::fly(const std::vector<bool>& wanted, sim::Random others) {
  std::vector<std::unique_ptr<core::Autopilot>> laws(rules_.size());
  std::size_t at_work = 0;
  for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
    if (wanted[rule]) {
      laws[rule] = std::make_unique<core::Autopilot>(rules_[rule].plan);
      ++at_work;
    }
  }
  InputMaker maker{*motion_, *readings_, others};
  for (int tick = 0; tick < InputMaker::pad_ticks; ++tick) {
    const core::Inputs& inputs = maker.pad(tick);
    for (const auto& law : laws) {
      if (law) {
        law->step(inputs);
      }
    }
  }
  for (std::size_t step = 0; step < motion_->length && at_work > 0; ++step) {
    const core::Inputs& inputs = maker.step(step);
    for (std::size_t rule = 0; rule < rules_.size(); ++rule) {
      if (laws[rule]) {
        const core::TickRecord& record = laws[rule]->step(inputs);
        follow(rule, step, record);
        if (!on_tick && is_settled(rules_[rule].plan, answers_[rule], record.phase, motion_->length - step)) {
          laws[rule].reset();
          --at_work;
        }
      }
    }
  }
}

void Rehearsal::follow(std::size_t rule, std::size_t step, const core::TickRecord& record) {
  Answer& answer = answers_[rule];
  const core::FlightPlan& plan = rules_[rule].plan;
  const bool has_thrust = motion_->ignition > 0;
  if (on_tick) {
    on_tick(rule, step, record);
  }
  if (has_thrust && !answer.crossing && step >= motion_->ignition &&
      motion_->thrust_m_s2[step] >= plan.launch_detection.threshold_m_s2) {
    answer.crossing = step;
  }
  const bool believes = core::is_flight(record.phase);
  if (motion_->flight_end > 0) {
    is_in_flight_[rule] = believes && (is_in_flight_[rule] || step < motion_->flight_end);
    if (is_in_flight_[rule]) {
      answer.flown = record.phase == core::Phase::controlling;
      return;
    }
  }
  if (!believes) {
    return;
  }
  if (has_thrust && !answer.detected) {
    const float true_tilt = core::atan2(std::abs(readings_->up_z[step]), readings_->up_x[step]).radians();
    answer.tilt_error_rad = record.motion.tilt.radians() - true_tilt;
  }
  answer.detected = answer.detected.value_or(step);
  if (record.phase != core::Phase::controlling) {
    answer.nearness = std::max(answer.nearness, std::min(Answer::held_back, share_of_gate(plan.guide, record.motion)));
  } else if (!answer.controlling) {
    answer.controlling = step;
    answer.part = motion_->part_of(step);
    answer.nearness = 1.0F;
    if (has_thrust) {
      answer.distance_m = motion_->distance_m[step];
      answer.distance_error_m = record.motion.distance_along_guide_m - answer.distance_m;
    }
  }
}

}  // namespace fantail::detection
