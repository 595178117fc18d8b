// SPDX-License-Identifier: MIT
#include "identify/closed_loop/course.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

#include "core/gain_schedule.hpp"
#include "text/error.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

// Zero where nothing was logged.
double between(const std::vector<double>& values, std::size_t sample, double share) {
  if (values.empty()) {
    return 0.0;
  }
  return share == 0.0 ? values[sample] : values[sample] + share * (values[sample + 1] - values[sample]);
}

core::Angle angle(double radians) { return core::Angle::from_radians(static_cast<float>(radians)); }

// Says at which sub-steps the controller runs. Where sub-steps are about as long as its period that is each of them.
class Timetable {
 public:
  explicit Timetable(double period_s) : period_s_{period_s} {}

  void restart(double time_s) { next_s_ = time_s; }

  bool runs(double time_s, double duration_s) {
    if (duration_s > 0.66 * period_s_) {
      next_s_ = time_s + duration_s;
      return true;
    }
    if (time_s < next_s_ - 0.5 * duration_s) {
      return false;
    }
    next_s_ += period_s_;
    return true;
  }

 private:
  double period_s_;
  double next_s_ = 0.0;
};

class CourseBuilder {
 public:
  CourseBuilder(const Record& record, const Airframe& airframe, const Control& control, const NodeTimes& node_time_s)
      : record_{record},
        control_{control},
        airframe_{airframe},
        node_time_s_{node_time_s},
        timetable_{control.controller_period_s},
        course_{.record = &record,
                .controller = control.controller,
                .node_count = node_time_s.size(),
                .first_step = {},
                .steps = {},
                .air = {},
                .servo = {},
                .half_play_rad = 0.0,
                .holds = false} {}

  Course build() {
    for (std::size_t segment = 0; segment < course_.segments(); ++segment) {
      const std::size_t begin = course_.segment_begin(segment);
      const std::size_t end = course_.segment_end(segment);
      timetable_.restart(record_.time_s[begin]);
      for (std::size_t sample = begin; sample < end; ++sample) {
        course_.first_step.push_back(course_.steps.size());
        if (sample + 1 < end) {
          add_sample(sample);
        } else {
          add_last(sample);
        }
      }
    }
    course_.first_step.push_back(course_.steps.size());
    course_.set_servo(control_.servo_lag_s, control_.servo_play_rad);
    return std::move(course_);
  }

 private:
  void add_sample(std::size_t sample) {
    const double interval_s = record_.time_s[sample + 1] - record_.time_s[sample];
    const double count = std::max(1.0, std::round(interval_s / control_.controller_period_s));
    const double duration_s = interval_s / count;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
      const double begin_share = static_cast<double>(i) / count;
      const double middle_share = (static_cast<double>(i) + 0.5) / count;
      add_step(sample, begin_share, interval_s, duration_s);
      Airframe now = airframe_;
      if (!record_.roll_inertia_kg_m2.empty()) {
        now.inertia_kg_m2 = between(record_.roll_inertia_kg_m2, sample, middle_share);
      }
      course_.air.push_back({.duration_s = duration_s,
                             .equation = roll_equation(now, between(record_.density_kg_m3, sample, middle_share),
                                                       between(record_.speed_m_s, sample, middle_share))});
    }
  }

  void add_last(std::size_t sample) {
    add_step(sample, 0.0, 0.0, 0.0);
    course_.air.push_back({.duration_s = 0.0, .equation = {}});
  }

  void add_step(std::size_t sample, double share_of_interval, double interval_s, double duration_s) {
    const double time_s = record_.time_s[sample] + share_of_interval * interval_s;
    const bool in_control = record_.in_control.empty() || record_.in_control[sample];
    const bool last = duration_s == 0.0;
    const bool runs = timetable_.runs(time_s, last ? control_.controller_period_s : duration_s);
    course_.holds = course_.holds || (in_control && !runs);
    const NodeShare share = node_share(node_time_s_, time_s + 0.5 * duration_s);
    course_.steps.push_back({.next_share = share.right_share,
                             .node = static_cast<std::uint32_t>(share.left),
                             .next_node = static_cast<std::uint32_t>(share.right),
                             .reference = angle(record_.reference_rad[sample]),
                             .excitation = angle(between(record_.excitation_rad, sample, share_of_interval)),
                             .adaptation = adaptation(sample, share_of_interval, time_s),
                             .law = !in_control ? Law::rests
                                    : runs      ? Law::runs
                                                : Law::holds});
  }

  [[nodiscard]] core::Adaptation adaptation(std::size_t sample, double share, double time_s) const {
    const auto speed_m_s = static_cast<float>(between(record_.law_speed_m_s, sample, share));
    return {.gain_factor = core::gain_factor(control_.gain_schedule, speed_m_s, time_s >= record_.law_speed_is_bound_s),
            .offset_estimate = angle(between(record_.offset_estimate_rad, sample, share))};
  }

  const Record& record_;
  const Control& control_;
  const Airframe& airframe_;
  const NodeTimes& node_time_s_;
  Timetable timetable_;
  Course course_;
};

}  // namespace

Course make_course(const Record& record, const Airframe& airframe, const Control& control,
                   const NodeTimes& node_time_s) {
  using text::Error;
  using text::ErrorKind;
  const auto need = [&record](const std::vector<double>& column, const char* name, const char* who) {
    if (column.size() != record.size()) {
      throw Error{ErrorKind::bad_data,
                  fmt::format("window {}: {} is missing; {} needs it in every row, the open loop does not",
                              record.window, name, who)};
    }
  };
  need(record.reference_rad, "reference_deg", "the closed loop");
  if (control.offset_rejection != core::OffsetRejection::none) {
    need(record.offset_estimate_rad, "offset_estimate_deg", "the closed loop with a plan that rejects the offset");
  }
  if (control.gain_schedule.speeds_count > 0) {
    need(record.law_speed_m_s, "speed_m_s", "the closed loop with a plan that has a gain schedule");
  }
  if (!(control.controller_period_s > 0.0)) {
    throw Error{ErrorKind::bad_configuration,
                fmt::format("controller period: {:g} s; allowed: above 0", control.controller_period_s)};
  }
  if (!(control.servo_lag_s >= 0.0)) {
    throw Error{ErrorKind::bad_configuration,
                fmt::format("servo lag: {:g} s; allowed: 0 or more", control.servo_lag_s)};
  }
  return CourseBuilder{record, airframe, control, node_time_s}.build();
}

void Course::set_servo(double lag_s, double play_rad) {
  half_play_rad = 0.5 * play_rad;
  servo.resize(lag_s > 0.0 || play_rad > 0.0 ? air.size() : 0);
  for (std::size_t i = 0; i < servo.size(); ++i) {
    servo[i] = lag_s > 0.0 ? servo_of(lag_s, air[i].duration_s) : no_servo;
  }
}

void Plant::set_alpha(const Course& course, double alpha_m2, Slopes slopes) {
  const std::size_t count = course.air.size();
  step.resize(count);
  by_alpha.resize(slopes == Slopes::by_alpha ? count : 0);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [duration_s, equation] = course.air[i];
    if (slopes == Slopes::by_alpha) {
      const HeldStepAndSlope both = held_step_and_slope(equation, alpha_m2, duration_s);
      step[i] = both.step;
      by_alpha[i] = both.by_alpha;
    } else {
      step[i] = held_step(equation, alpha_m2, duration_s);
    }
  }
}

}  // namespace fantail::identify::closed_loop
