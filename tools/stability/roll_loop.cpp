// SPDX-License-Identifier: MIT
#include "stability/roll_loop.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/gain_schedule.hpp"
#include "sim/deflection_range.hpp"
#include "sim/servo.hpp"

namespace fantail::stability {
namespace {

// Far beyond what a rocket or a servo does at either end.
constexpr double lowest_rad_s = 1e-6;
constexpr double highest_rad_s = 1e7;
constexpr double half_turn_rad = std::numbers::pi;

/// The same loop without schedule and observer, by other gains.
RollLoop with_gains_alone(RollLoop loop) {
  const double proportional_gain = loop.gain_factor * loop.proportional_gain;
  const double derivative_gain_s = loop.gain_factor * loop.derivative_gain_s;
  const ObserverModel model = loop.observer;
  const double w = model.bandwidth_rad_s;
  loop.proportional_gain = proportional_gain;
  loop.derivative_gain_s = derivative_gain_s;
  loop.integral_gain_per_s *= loop.gain_factor;
  if (w > 0.0) {
    loop.proportional_gain += w * (derivative_gain_s + model.damping_rate_per_s / model.authority_per_s2);
    loop.derivative_gain_s += w / model.authority_per_s2;
    loop.integral_gain_per_s += w * proportional_gain;
  }
  loop.gain_factor = 1.0;
  loop.observer = {};
  return loop;
}

/// The imaginary part of kp + ki / s + kd s.
double quadrature(const RollLoop& loop, double w) { return loop.derivative_gain_s * w - loop.integral_gain_per_s / w; }

/// What servos make of a swing: (1 - share) / (1 + x i) + share / (1 + k x i), which is (1 + m x i) / ((1 + x i) (1 + k
/// x i)). A search asks for it millions of times, and here it takes no division of complex numbers.
class Servos {
 public:
  Servos(const RollLoop& loop, double w)
      : x_{loop.servo_lag_s * w}, m_{sim::slow_times - loop.slow_share * (sim::slow_times - 1.0)} {}

  [[nodiscard]] double gain_squared() const {
    const double x2 = x_ * x_;
    return (1.0 + m_ * m_ * x2) / ((1.0 + x2) * (1.0 + sim::slow_times * sim::slow_times * x2));
  }

  /// Within a quarter turn, because m is not below one.
  [[nodiscard]] double phase_rad() const {
    const double x2 = x_ * x_;
    constexpr double k = sim::slow_times;
    return std::atan2(x_ * (m_ - 1.0 - k - m_ * k * x2), 1.0 + (m_ + m_ * k - k) * x2);
  }

 private:
  double x_;
  double m_;
};

/// What the fins leave of a torque that swings.
std::complex<double> left_by_fins(const RollLoop& loop, double w) {
  return 1.0 - std::polar(loop.wash, -loop.wash_delay_s * w);
}

/// Without a logarithm, because most who ask want to know whether it is above one.
double gain_squared(const RollLoop& loop, double w) {
  const double fins = loop.wash == 0.0 ? 1.0 : std::norm(left_by_fins(loop, w));
  const double b = loop.authority_per_s2;
  const double a = loop.damping_rate_per_s;
  const double in_phase = loop.proportional_gain;
  const double across = quadrature(loop, w);
  return fins * b * b * (in_phase * in_phase + across * across) / (w * w * (w * w + a * a)) *
         Servos{loop, w}.gain_squared();
}

/// Followed from frequency zero on, not wrapped: with a wash below one its part stays within a quarter turn.
double phase_rad(const RollLoop& loop, double w) {
  const double fins = loop.wash == 0.0 ? 0.0 : std::arg(left_by_fins(loop, w));
  return fins + std::atan2(quadrature(loop, w), loop.proportional_gain) - 0.5 * half_turn_rad -
         std::atan2(w, loop.damping_rate_per_s) + Servos{loop, w}.phase_rad() - loop.delay_s * w;
}

/// Where a function of the frequency changes its sign between two frequencies, which it does.
template <typename Function>
double root(const Function& function, double low, double high) {
  const bool rises = function(low) < 0.0;
  while (high / low > 1.0 + 1e-13) {
    const double middle = std::sqrt(low * high);
    ((function(middle) < 0.0) == rises ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// Whether the gain falls with the frequency all the way, but for the fins: of (kp^2 + (kd w - ki / w)^2) / w^2 that
/// can be seen.
bool falls(const RollLoop& loop) {
  return loop.proportional_gain * loop.proportional_gain >= 2.0 * loop.derivative_gain_s * loop.integral_gain_per_s;
}

struct HalfTurn {
  double rad_s;
  double gain_margin;
};

/// Where the phase passes half a turn more than once, the pass at the gain nearest to one is where a change of gain
/// first makes it swing.
std::optional<HalfTurn> half_turn(const RollLoop& loop) {
  // The answer of the fins makes waves, and an integral beside little proportional gain turns the phase at once.
  const double step = loop.wash == 0.0 && falls(loop) ? 1.1 : 1.02;
  const auto above_half_turn = [&loop](double w) { return phase_rad(loop, w) + half_turn_rad; };
  std::optional<HalfTurn> nearest;
  double nearest_logarithm = 0.0;
  double w = lowest_rad_s;
  bool is_below = above_half_turn(w) < 0.0;
  while (w < highest_rad_s) {
    const double next = step * w;
    const bool next_is_below = above_half_turn(next) < 0.0;
    if (next_is_below != is_below) {
      const double pass = root(above_half_turn, w, next);
      const double logarithm = -0.5 * std::log(gain_squared(loop, pass));
      if (!nearest || std::abs(logarithm) < std::abs(nearest_logarithm)) {
        nearest = {.rad_s = pass, .gain_margin = std::exp(logarithm)};
        nearest_logarithm = logarithm;
      }
    }
    w = next;
    is_below = next_is_below;
  }
  return nearest;
}

constexpr double tick_s = 1e-3;

/// Where the gain of a loop whose gain falls is one over the factor.
double pass_with(const RollLoop& loop, double factor) {
  return root([&](double w) { return factor * factor * gain_squared(loop, w) - 1.0; }, lowest_rad_s, highest_rad_s);
}

/// All passes of the gain through one lie above this frequency ...
double before_all_passes(RollLoop loop) {
  const double wash = loop.wash;
  loop.wash = 0.0;
  if (!falls(loop)) {
    loop.derivative_gain_s = 0.0;
    loop.integral_gain_per_s = 0.0;
  }
  return loop.proportional_gain > 0.0 || falls(loop) ? 0.999 * pass_with(loop, 1.0 - wash) : lowest_rad_s;
}

/// ... and below this one: the two parts that are opposed to each other, added.
double after_all_passes(RollLoop loop) {
  const double wash = loop.wash;
  loop.wash = 0.0;
  if (!falls(loop)) {
    loop.integral_gain_per_s = -loop.integral_gain_per_s;
  }
  return 1.001 * pass_with(loop, 1.0 + wash);
}

/// Where the fins answer, the gain can pass one several times, all of them between the frequencies at which it would
/// if they always took their share away, and always added it. So it can where integral and derivative parts cancel and
/// leave little. The pass with the least phase counts.
double worst_crossover_rad_s(const RollLoop& loop) {
  const auto above_one = [&loop](double w) { return gain_squared(loop, w) - 1.0; };
  const double last = after_all_passes(loop);
  // Where they cancel the gain may dip for less than a step.
  const double dip = falls(loop) ? last : std::sqrt(loop.integral_gain_per_s / loop.derivative_gain_s);
  double worst = last;
  bool found = false;
  for (double w = before_all_passes(loop); w < last;) {
    double next = std::min(1.02 * w, w + 0.2 / loop.wash_delay_s);
    next = w < dip && dip < next ? dip : next;
    if ((above_one(w) < 0.0) != (above_one(next) < 0.0)) {
      const double pass = root(above_one, w, next);
      worst = !found || phase_rad(loop, pass) < phase_rad(loop, worst) ? pass : worst;
      found = true;
    }
    w = next;
  }
  return worst;
}

std::optional<double> crossover_rad_s(const RollLoop& loop) {
  const bool has_gain =
      loop.authority_per_s2 > 0.0 && loop.wash < 1.0 &&
      (loop.proportional_gain > 0.0 || loop.derivative_gain_s > 0.0 || loop.integral_gain_per_s > 0.0);
  if (!has_gain || gain_squared(loop, lowest_rad_s) < 1.0) {
    return std::nullopt;
  }
  return loop.wash > 0.0 || !falls(loop) ? worst_crossover_rad_s(loop) : pass_with(loop, 1.0);
}

std::optional<double> phase_margin_at_pass_rad(const RollLoop& loop) {
  const auto crossover = crossover_rad_s(loop);
  return crossover ? std::optional{half_turn_rad + phase_rad(loop, *crossover)} : std::nullopt;
}

ObserverModel observer_model(const core::FlightPlan& plan, double speed_m_s) {
  if (plan.offset.rejection != core::OffsetRejection::observer) {
    return {};
  }
  const core::RollModelPlan& model = plan.roll_model;
  const sim::RollPlant plant{.inertia_kg_m2 = static_cast<double>(model.roll_inertia_kg_m2),
                             .reference_area_m2 = static_cast<double>(model.reference_area_m2),
                             .damping_m2 = static_cast<double>(model.damping_m2),
                             .torque_m = static_cast<double>(model.torque_m)};
  const auto density_kg_m3 = static_cast<double>(model.density_kg_m3);
  return {.bandwidth_rad_s = static_cast<double>(plan.offset.observer_bandwidth_rad_s),
          .damping_rate_per_s = plant.damping_rate_per_s(density_kg_m3, speed_m_s),
          .authority_per_s2 = plant.authority_per_s2(density_kg_m3, speed_m_s)};
}

}  // namespace

std::optional<Margins> margins(const RollLoop& any_loop) {
  const RollLoop loop = with_gains_alone(any_loop);
  const auto crossover = crossover_rad_s(loop);
  if (!crossover) {
    return std::nullopt;
  }
  const auto found = half_turn(loop);
  return Margins{.phase_margin_rad = half_turn_rad + phase_rad(loop, *crossover),
                 .crossover_rad_s = *crossover,
                 .gain_margin = found ? std::optional{found->gain_margin} : std::nullopt,
                 .half_turn_rad_s = found ? std::optional{found->rad_s} : std::nullopt};
}

Response response(const RollLoop& any_loop, double w_rad_s) {
  const RollLoop loop = with_gains_alone(any_loop);
  return {.gain = std::sqrt(gain_squared(loop, w_rad_s)), .phase_rad = phase_rad(loop, w_rad_s)};
}

std::optional<double> phase_margin_rad(const RollLoop& loop) {
  return phase_margin_at_pass_rad(with_gains_alone(loop));
}

double loop_delay_s(const sim::Vehicle& vehicle) {
  // A pulse is as old as half a tick when its frame begins, in the mean, and then stands for a frame: half of it late.
  return vehicle.imu.delay_s + 0.5 * tick_s + 0.5 * vehicle.servo.frame_period_s + vehicle.servo.delay_s;
}

RollLoop loop_at_speed(const sim::Scenario& scenario, double speed_m_s) {
  const core::FlightPlan& plan = scenario.plan;
  const bool integrates = plan.offset.rejection == core::OffsetRejection::integral;
  // After burn-out, which is most of a flight and where the loop is fastest.
  sim::RollPlant plant = scenario.vehicle.roll_plant;
  if (scenario.surroundings == sim::Surroundings::flight && scenario.motion == sim::FlightMotion::six_dof) {
    plant.inertia_kg_m2 = scenario.vehicle.airframe.value_or(sim::Airframe{})
                              .roll_inertia_after_burnout_kg_m2.value_or(plant.inertia_kg_m2);
  }
  const double density_kg_m3 = scenario.atmosphere.density_kg_m3(0.0);
  const double compressibility = sim::compressibility_factor(scenario.vehicle.compressibility,
                                                             speed_m_s / scenario.atmosphere.speed_of_sound_m_s(0.0));
  const sim::CanardResponse canards = sim::canard_response(scenario);
  return {
      .proportional_gain = static_cast<double>(plan.controller.proportional_gain),
      .derivative_gain_s = static_cast<double>(plan.controller.derivative_gain_s),
      .integral_gain_per_s = integrates ? static_cast<double>(plan.offset.integral_gain_per_s) : 0.0,
      .gain_factor = static_cast<double>(core::gain_factor(plan.gain_schedule, static_cast<float>(speed_m_s), false)),
      .observer = observer_model(plan, speed_m_s),
      .damping_rate_per_s = compressibility * plant.damping_rate_per_s(density_kg_m3, speed_m_s),
      .authority_per_s2 = compressibility * (canards.effectiveness * plant.authority_per_s2(density_kg_m3, speed_m_s)),
      .servo_lag_s = scenario.vehicle.servo.lag_s,
      .delay_s = loop_delay_s(scenario.vehicle),
      .slow_share = canards.slow_share,
      .wash = scenario.vehicle.canard_air.wash,
      .wash_delay_s = scenario.vehicle.canard_air.wash_distance_m / speed_m_s};
}

}  // namespace fantail::stability
