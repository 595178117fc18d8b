// SPDX-License-Identifier: MIT
#include "sim/barometer_model.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "sim/elementary.hpp"

namespace fantail::sim {
namespace {

constexpr double tick_s = 1e-3;

// Written so that a NaN is refused too.
void require(bool allowed, const char* what) {
  if (!allowed) {
    throw std::invalid_argument{std::string{"barometer: "} + what};
  }
}

const BarometerParameters& validated(const BarometerParameters& p) {
  require(p.noise_pa >= 0.0 && p.noise_pa <= 500.0, "noise_pa must be 0 to 500");
  require(p.port_error >= -1.0 && p.port_error <= 1.0, "port_error must be -1 to 1");
  require(p.vent_lag_s >= 0.0 && p.vent_lag_s <= 5.0, "vent_lag_s must be 0 to 5");
  require(p.offset_pa >= -5000.0 && p.offset_pa <= 5000.0, "offset_pa must be -5000 to 5000");
  return p;
}

double shock_coefficient(double mach) {
  constexpr double half_width = 0.1;
  const double from_one = std::abs(mach - 1.0);
  return from_one < half_width ? BarometerModel::shock_error * (1.0 - from_one / half_width) : 0.0;
}

double ejection_now_pa(const std::optional<double>& since_s) {
  return since_s && *since_s >= 0.0 && *since_s < BarometerModel::ejection_lasts_s
             ? BarometerModel::ejection_pa * (1.0 - *since_s / BarometerModel::ejection_lasts_s)
             : 0.0;
}

std::uint32_t whole_pascals(double pressure_pa) {
  constexpr double most_pa = 1e6;
  const double within = pressure_pa > 0.0 ? (pressure_pa < most_pa ? pressure_pa : most_pa) : 0.0;
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): nothing here is below zero
  return static_cast<std::uint32_t>(within + 0.5);
}

}  // namespace

BarometerModel::BarometerModel(const BarometerParameters& parameters, Random random)
    : parameters_{validated(parameters)},
      random_{random},
      kept_{parameters.vent_lag_s > 0.0 ? exponential(-tick_s / parameters.vent_lag_s) : 0.0},
      lag_ticks_{parameters.vent_lag_s / tick_s} {}

const hal::BarometerSample& BarometerModel::sample(hal::Microseconds time, const AirAtPorts& air,
                                                   const BarometerFault& wrong) {
  const double coefficient = parameters_.port_error + shock_coefficient(air.mach);
  let_bay_follow(air.static_pa + coefficient * air.dynamic_pa, wrong.blocked);
  if (wrong.hangs) {
    next_.reset();
    return latest_;
  }
  const hal::Microseconds into_period = time % period;
  if (into_period == period - ready_after) {
    next_ = measured(time, air, wrong.lit);
  } else if (into_period == hal::Microseconds{0} && next_) {
    latest_ = *next_;
    next_.reset();
  }
  return latest_;
}

// Exact where the pressure at the ports changes evenly within the millisecond.
void BarometerModel::let_bay_follow(double port_pa, bool blocked) {
  if (!bay_pa_) {
    bay_pa_ = port_pa;
  } else if (!blocked) {
    const double behind_pa = (port_pa - port_pa_) * lag_ticks_;  // after long at this rate of change
    *bay_pa_ = (port_pa - behind_pa) + (*bay_pa_ - port_pa_ + behind_pa) * kept_;
  }
  port_pa_ = port_pa;
}

hal::BarometerSample BarometerModel::measured(hal::Microseconds time, const AirAtPorts& air, bool lit) {
  const double pressure_pa = *bay_pa_ + ejection_now_pa(air.since_ejection_s) + parameters_.offset_pa +
                             (lit ? light_pa : 0.0) + parameters_.noise_pa * random_.gaussian();
  return {.time = time, .pressure_pa = whole_pascals(pressure_pa), .status = hal::Status::ok};
}

}  // namespace fantail::sim
