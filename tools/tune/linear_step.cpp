// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/servo.hpp"
#include "tune/linear_trial.hpp"

namespace fantail::tune {
namespace {

constexpr double dt_s = 5e-4;
constexpr int steps_per_sample = 2;
constexpr double sample_s = steps_per_sample * dt_s;

/// What a signal was some time ago; zero before there was any.
class DelayLine {
 public:
  explicit DelayLine(double delay_s)
      : values_(static_cast<std::size_t>(std::lround(std::min(delay_s, 10.0) / dt_s)) + 1, 0.0) {}

  double after(double value) {
    values_[next_] = value;
    next_ = next_ + 1 == values_.size() ? 0 : next_ + 1;
    return values_[next_];
  }

 private:
  std::vector<double> values_;
  std::size_t next_ = 0;
};

/// What a first-order lag leaves to be done in a step.
double share_of_step(double lag_s) { return lag_s > 0.0 ? 1.0 - std::exp(-dt_s / lag_s) : 1.0; }

}  // namespace

std::vector<double> step_response(const stability::RollLoop& loop, double duration_s) {
  const double f = loop.gain_factor;
  const stability::ObserverModel& model = loop.observer;
  const double fast = share_of_step(loop.servo_lag_s);
  const double slow = share_of_step(sim::slow_times * loop.servo_lag_s);
  DelayLine waiting{loop.delay_s};
  DelayLine on_the_way{loop.wash > 0.0 ? loop.wash_delay_s : 0.0};
  double angle = 0.0;
  double rate = 0.0;
  double estimate = 0.0;  // of the offset, by integral or observer
  double fast_canards = 0.0;
  double slow_canards = 0.0;
  std::vector<double> angles;
  for (int i = 0; i * dt_s < duration_s; ++i) {
    const double command = f * (loop.proportional_gain * (1.0 - angle) - loop.derivative_gain_s * rate) - estimate;
    const double arrived = waiting.after(command);
    fast_canards += fast * (arrived - fast_canards);
    slow_canards += slow * (arrived - slow_canards);
    const double canards = (1.0 - loop.slow_share) * fast_canards + loop.slow_share * slow_canards;
    const double torque = canards - loop.wash * on_the_way.after(canards);
    const double acceleration = loop.authority_per_s2 * torque - loop.damping_rate_per_s * rate;
    estimate -= dt_s * f * loop.integral_gain_per_s * (1.0 - angle);
    estimate += dt_s * model.bandwidth_rad_s *
                ((acceleration + model.damping_rate_per_s * rate) / model.authority_per_s2 - command - estimate);
    rate += dt_s * acceleration;
    angle += dt_s * rate;
    if (i % steps_per_sample == steps_per_sample - 1) {
      angles.push_back(angle);
    }
  }
  return angles;
}

std::optional<double> settling_s(const stability::RollLoop& loop, double longest_s) {
  constexpr double within = 0.1;
  // Long enough to see a slow swing return.
  const std::vector<double> angles = step_response(loop, 3.0 * longest_s);
  const auto last_outside =
      std::find_if(angles.rbegin(), angles.rend(), [](double angle) { return !(std::abs(angle - 1.0) <= within); });
  const double found_s = sample_s * static_cast<double>(angles.rend() - last_outside);
  return found_s <= longest_s ? std::optional{found_s} : std::nullopt;
}

}  // namespace fantail::tune
