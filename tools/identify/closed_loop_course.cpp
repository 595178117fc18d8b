// SPDX-License-Identifier: MIT
#include "identify/closed_loop_course.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/core.h>

#include "identify/node_times.hpp"
#include "identify/response_basis.hpp"
#include "sim/input_error.hpp"
#include "sim/roll_plant.hpp"

namespace fantail::identify {
namespace {

double between(const std::vector<double>& values, std::size_t sample, double share) {
  return values[sample] + share * (values[sample + 1] - values[sample]);
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
  CourseBuilder(const Record& record, const Airframe& airframe, const ClosedLoop& loop, const NodeTimes& node_time_s)
      : record_{record},
        loop_{loop},
        airframe_{airframe},
        node_time_s_{node_time_s},
        timetable_{loop.controller_period_s},
        course_{.record = &record,
                .controller = loop.controller,
                .node_count = node_time_s.size(),
                .first_step = {},
                .steps = {},
                .air = {},
                .servo = {},
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
    return std::move(course_);
  }

 private:
  void add_sample(std::size_t sample) {
    const double interval_s = record_.time_s[sample + 1] - record_.time_s[sample];
    const double count = std::max(1.0, std::round(interval_s / loop_.controller_period_s));
    const double duration_s = interval_s / count;
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(count); ++i) {
      const double begin_share = static_cast<double>(i) / count;
      const double middle_share = (static_cast<double>(i) + 0.5) / count;
      const double excitation_rad =
          record_.excitation_rad.empty() ? 0.0 : between(record_.excitation_rad, sample, begin_share);
      add_step(sample, record_.time_s[sample] + begin_share * interval_s, duration_s, excitation_rad);
      const double speed_m_s = between(record_.speed_m_s, sample, middle_share);
      const double density_kg_m3 = between(record_.density_kg_m3, sample, middle_share);
      course_.air.push_back({.duration_s = duration_s,
                             .damping_per_alpha = damping_per_m2_s(airframe_, density_kg_m3, speed_m_s),
                             .authority_per_beta = authority_per_m_s2(airframe_, density_kg_m3, speed_m_s)});
    }
  }

  void add_last(std::size_t sample) {
    const double excitation_rad = record_.excitation_rad.empty() ? 0.0 : record_.excitation_rad[sample];
    add_step(sample, record_.time_s[sample], 0.0, excitation_rad);
    course_.air.push_back({.duration_s = 0.0, .damping_per_alpha = 0.0, .authority_per_beta = 0.0});
  }

  void add_step(std::size_t sample, double time_s, double duration_s, double excitation_rad) {
    const bool in_control = record_.in_control.empty() || record_.in_control[sample];
    const bool last = duration_s == 0.0;
    const bool runs = timetable_.runs(time_s, last ? loop_.controller_period_s : duration_s);
    course_.holds = course_.holds || (in_control && !runs);
    const NodeShare share = node_share(node_time_s_, time_s + 0.5 * duration_s);
    course_.steps.push_back({.next_share = share.right_share,
                             .node = static_cast<std::uint32_t>(share.left),
                             .next_node = static_cast<std::uint32_t>(share.right),
                             .reference = angle(record_.reference_rad[sample]),
                             .excitation = angle(excitation_rad),
                             .law = !in_control ? Law::rests
                                    : runs      ? Law::runs
                                                : Law::holds});
    if (loop_.servo_lag_s > 0.0) {
      const double lags = duration_s / loop_.servo_lag_s;
      const double decay = std::exp(-lags);
      course_.servo.push_back({.decay = decay, .mean_share = last ? 1.0 : -std::expm1(-lags) / lags});
    }
  }

  const Record& record_;
  const ClosedLoop& loop_;
  const Airframe& airframe_;
  const NodeTimes& node_time_s_;
  Timetable timetable_;
  Course course_;
};

// Derivative of a transition by x = damping rate times dt, in units of dt. With phi1 = (1 - e^-x) / x, phi2 =
// (x - 1 + e^-x) / x^2 and phi3 the next of the kind, the slopes are phi2 - phi1 and 2 phi3 - phi2: no difference of
// nearly equal numbers but in phi3.
CourseTransition slope_by_damping(const CourseAir& air, double alpha_m2, const sim::RollTransition& value) {
  const double dt_s = air.duration_s;
  if (dt_s <= 0.0) {
    return {};
  }
  const double x = air.damping_per_alpha * alpha_m2 * dt_s;
  const double phi1 = value.c1_s / dt_s;
  const double phi2 = value.c2_s2 / (dt_s * dt_s);
  const double phi3 =
      x < 0.01 ? 1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720 - x * (1.0 / 5040)))) : (0.5 - phi2) / x;
  const double by_alpha = air.damping_per_alpha * dt_s;
  const double c1_slope_s = by_alpha * dt_s * (phi2 - phi1);
  const double c2_slope_s2 = by_alpha * dt_s * dt_s * (2.0 * phi3 - phi2);
  return {.decay = -by_alpha * value.decay,
          .c1_s = c1_slope_s,
          .rate_gain = air.authority_per_beta * c1_slope_s,
          .angle_gain = air.authority_per_beta * c2_slope_s2};
}

}  // namespace

Course closed_loop_course(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                          const NodeTimes& node_time_s) {
  using sim::InputError;
  using sim::InputFault;
  if (record.reference_rad.size() != record.size()) {
    throw InputError{InputFault::bad_data,
                     fmt::format("window {}: reference_deg is missing, and without it nobody knows what the controller "
                                 "wanted; the open loop needs none",
                                 record.window)};
  }
  if (!(loop.controller_period_s > 0.0)) {
    throw InputError{InputFault::bad_configuration,
                     fmt::format("controller period: {:g} s; allowed: above 0", loop.controller_period_s)};
  }
  if (!(loop.servo_lag_s >= 0.0)) {
    throw InputError{InputFault::bad_configuration,
                     fmt::format("servo lag: {:g} s; allowed: 0 or more", loop.servo_lag_s)};
  }
  return CourseBuilder{record, airframe, loop, node_time_s}.build();
}

void fill_transitions(const Course& course, double alpha_m2, Slopes slopes, Transitions& transitions) {
  transitions.value.resize(course.air.size());
  transitions.slope.resize(slopes == Slopes::by_alpha ? course.air.size() : 0);
  for (std::size_t i = 0; i < course.air.size(); ++i) {
    const CourseAir& air = course.air[i];
    const sim::RollTransition value = sim::roll_transition(air.damping_per_alpha * alpha_m2, air.duration_s);
    transitions.value[i] = {.decay = value.decay,
                            .c1_s = value.c1_s,
                            .rate_gain = air.authority_per_beta * value.c1_s,
                            .angle_gain = air.authority_per_beta * value.c2_s2};
    if (slopes == Slopes::by_alpha) {
      transitions.slope[i] = slope_by_damping(air, alpha_m2, value);
    }
  }
}

}  // namespace fantail::identify
