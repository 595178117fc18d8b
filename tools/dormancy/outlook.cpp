// SPDX-License-Identifier: MIT
#include "dormancy/outlook.hpp"

#include <algorithm>
#include <chrono>

#include "fly/describe.hpp"
#include "sim/lean_board.hpp"
#include "sim/world.hpp"

namespace fantail::dormancy {
namespace {

double in_seconds(core::Microseconds time) { return std::chrono::duration<double>{time}.count(); }

/// From power-up, tick by tick.
class Ascent {
 public:
  explicit Ascent(const sim::Scenario& scenario)
      : scenario_{scenario}, flight_{fly::describe(scenario)}, watch_{flight_.tunnel} {
    const auto last_s = scenario.path ? std::nullopt : last_thrust_s(scenario.vehicle.motor);
    if (last_s) {
      last_thrust_s_ = scenario.pad_time_s + *last_s;
      thrust_end_s_ = scenario.pad_time_s + scenario.vehicle.motor.burnout_s();
    }
  }

  void look(const sim::World& world, const core::TickRecord& record) {
    const double time_s = in_seconds(world.now());
    const sim::Truth truth = world.truth();
    const Moment now{.time_s = time_s, .height_m = truth.height_m, .speed_m_s = truth.speed_m_s};
    flight::note_tick(flight_, record, time_s);
    flight::Row row = flight::row(record, time_s);
    row.truth = flight::Truth{.roll_angle_rad = truth.roll_angle_rad,
                              .roll_rate_rad_s = truth.roll_rate_rad_s,
                              .canard_rad = truth.canard_rad,
                              .height_m = truth.height_m,
                              .speed_m_s = truth.speed_m_s,
                              .disturbance_rad = truth.disturbance_rad};
    watch_.add(row, flight_);
    if (core::is_flight(record.phase)) {
      found_.gyro_was_at_its_end = found_.gyro_was_at_its_end || record.motion.rate_is_lower_bound;
      thrust_since_s_ = in_seconds(record.motion.thrust_since);
    }
    if (world.events().liftoff && !found_.apogee) {
      follow(world, now);
    }
  }

  [[nodiscard]] Outlook found(const sim::World& world) {
    if (!world.events().liftoff) {
      return {};
    }
    const double zero_s = in_seconds(*world.events().liftoff);
    for (std::optional<Moment>* moment :
         {&found_.guide_clear, &found_.thrust_is_drag, &found_.last_thrust, &found_.thrust_end, &found_.most_pressure,
          &found_.at_height, &found_.apogee}) {
      if (*moment) {
        (*moment)->time_s -= zero_s;
      }
    }
    found_.opening = watch_.found({.zero_s = zero_s});
    if (!found_.opening && !flight_.phase_changes.empty()) {
      found_.stayed_because = flight_.phase_changes.back().reason;
    }
    if (last_thrust_s_ && thrust_since_s_) {
      found_.burn_s = *last_thrust_s_ - *thrust_since_s_;
    }
    return found_;
  }

 private:
  static void note(std::optional<Moment>& moment, bool is_so, const Moment& now) {
    if (is_so && !moment) {
      moment = now;
    }
  }

  void follow(const sim::World& world, const Moment& now) {
    note(found_.guide_clear, world.events().guide_clear.has_value(), now);
    note(found_.last_thrust, last_thrust_s_ && now.time_s >= *last_thrust_s_, now);
    note(found_.thrust_end, thrust_end_s_ && now.time_s >= *thrust_end_s_, now);
    note(found_.apogee, world.events().apogee.has_value(), now);
    if (found_.apogee) {
      return;
    }
    const auto height_m = static_cast<double>(scenario_.plan.dormancy.height_m);
    note(found_.at_height, now.height_m >= height_m, now);
    if (world.motion().specific_force_m_s2.x >= 0.0) {
      found_.thrust_is_drag.reset();
    } else {
      note(found_.thrust_is_drag, true, now);
    }
    const double pressure = scenario_.atmosphere.density_kg_m3(now.height_m) * now.speed_m_s * now.speed_m_s;
    if (pressure > most_pressure_) {
      most_pressure_ = pressure;
      found_.most_pressure = now;
    }
    if (!flight_.events.control_start_s) {
      found_.top_speed_m_s = std::max(found_.top_speed_m_s, now.speed_m_s);
    }
  }

  const sim::Scenario& scenario_;
  flight::Flight flight_;
  OpeningWatch watch_;
  Outlook found_{};
  std::optional<double> last_thrust_s_{};
  std::optional<double> thrust_end_s_{};
  std::optional<double> thrust_since_s_{};
  double most_pressure_ = 0.0;
};

}  // namespace

std::optional<double> Outlook::opens_after_thrust_s() const {
  return opening && last_thrust ? std::optional{opening->time_s - last_thrust->time_s} : std::nullopt;
}

std::optional<double> Outlook::height_costs_s() const {
  return opening && at_height ? std::optional{opening->time_s - at_height->time_s} : std::nullopt;
}

std::optional<double> last_thrust_s(const sim::ThrustCurve& motor) {
  constexpr double share_of_peak = 0.02;
  const auto& points = motor.points();
  if (points.empty()) {
    return std::nullopt;
  }
  const double least_n = share_of_peak * std::ranges::max(points, {}, &sim::ThrustPoint::thrust_n).thrust_n;
  std::size_t i = points.size() - 1;
  while (points[i - 1].thrust_n < least_n) {
    --i;  // the peak is above it
  }
  const sim::ThrustPoint& from = points[i - 1];
  const sim::ThrustPoint& to = points[i];
  return from.time_s + (to.time_s - from.time_s) * (from.thrust_n - least_n) / (from.thrust_n - to.thrust_n);
}

Outlook outlook(const sim::Scenario& scenario) {
  sim::World world{scenario, sim::World::small_flash, sim::unrecorded_board(scenario)};
  Ascent ascent{scenario};
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    if (!world.is_down()) {
      ascent.look(world, record);
    }
    world.advance();
  }
  return ascent.found(world);
}

}  // namespace fantail::dormancy
