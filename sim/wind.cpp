// SPDX-License-Identifier: MIT
#include "sim/wind.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sim/elementary.hpp"

namespace fantail::sim {
namespace {

constexpr double metres_per_foot = 0.3048;

}  // namespace

// Below 1000 ft the formulas of the specification, in feet; from 2000 ft on isotropic; straight lines between.
Wind::Eddies Wind::eddies_at(double height_m) {
  constexpr double low_ft = 1000.0;
  constexpr double high_ft = 2000.0;
  constexpr double high_length_ft = 1750.0;
  const double height_ft = std::max(height_m / metres_per_foot, 10.0);
  const double below_ft = std::min(height_ft, low_ft);
  const double log_base = natural_log(0.177 + 0.000823 * below_ft);
  const double blend = std::clamp((height_ft - low_ft) / (high_ft - low_ft), 0.0, 1.0);
  const auto upwards = [blend](double low, double high) { return low + blend * (high - low); };
  return {.horizontal_length_m = metres_per_foot * upwards(below_ft * exponential(-1.2 * log_base), high_length_ft),
          .vertical_length_m = metres_per_foot * upwards(below_ft, high_length_ft),
          .vertical_share = exponential(0.4 * log_base)};
}

// Both spectra are the specification's: (1 + sqrt(3) T s) / (1 + T s)^2 is sqrt(3) / (1 + T s) and (1 - sqrt(3)) / (1 +
// T s)^2, and of the two lags the variances are 1 and 1/2, their covariance 1/2.
double Wind::Transverse::value() const {
  return (std::numbers::sqrt3 * first + (1.0 - std::numbers::sqrt3) * second) / std::numbers::sqrt2;
}

Wind::Wind(const WindParameters& parameters, Random random) : parameters_{parameters}, random_{random}, vertical_{0.0} {
  const auto [sine, cosine] = sine_cosine(parameters.from_rad);
  direction_ = {.x = -cosine, .y = sine};
  if (parameters.turbulence > 0.0) {
    const std::array<double, 5> start = random_.gaussians<5>();
    vertical_ = start[0];
    along_ = {.first = start[1], .second = 0.5 * start[1] + 0.5 * start[2]};
    across_ = {.first = start[3], .second = 0.5 * start[3] + 0.5 * start[4]};
  }
}

double Wind::mean_m_s(double height_m) const {
  constexpr double lowest_m = 0.1;  // the profile ends at the grass
  if (parameters_.exponent == 0.0) {
    return parameters_.speed_m_s;
  }
  const double ratio = std::max(height_m, lowest_m) / parameters_.reference_height_m;
  return parameters_.speed_m_s * exponential(parameters_.exponent * natural_log(ratio));
}

void Wind::step_turbulence(double dt_s, const Eddies& eddies, double past_m_s) {
  const std::array<double, 5> drawn = random_.gaussians<5>();

  const double kept = exponential(-dt_s * past_m_s / eddies.vertical_length_m);
  vertical_ = kept * vertical_ + std::sqrt(1.0 - kept * kept) * drawn[0];

  const double x = dt_s * past_m_s / eddies.horizontal_length_m;
  const double decay = exponential(-x);
  const double square = decay * decay;
  // What the noise of the step adds to the variances of the two lags, and to their covariance.
  const double first = 1.0 - square;
  const double both = 0.5 - square * (x + 0.5);
  const double second = 0.5 - square * (x * x + x + 0.5);
  const double a = std::sqrt(std::max(first, 0.0));
  const double b = a > 0.0 ? both / a : 0.0;
  const double c = std::sqrt(std::max(second - b * b, 0.0));
  const auto step = [&](Transverse& t, double n1, double n2) {
    t = {.first = decay * t.first + a * n1, .second = decay * (x * t.first + t.second) + b * n1 + c * n2};
  };
  step(along_, drawn[1], drawn[2]);
  step(across_, drawn[3], drawn[4]);
}

Vector3 Wind::step(double time_s, double dt_s, double height_m, double air_speed_m_s) {
  const double mean = mean_m_s(height_m);
  double speed_m_s = mean;
  const double into_gust = (time_s - parameters_.gust_time_s) / parameters_.gust_duration_s;
  if (into_gust > 0.0 && into_gust < 1.0) {
    speed_m_s += 0.5 * parameters_.gust_m_s * (1.0 - sine_cosine(2.0 * std::numbers::pi * into_gust).cosine);
  }
  if (parameters_.turbulence == 0.0) {
    return speed_m_s * direction_;
  }
  if (height_m != eddies_height_m_) {  // on its pad a rocket stays for most of a run
    eddies_ = eddies_at(height_m);
    eddies_height_m_ = height_m;
  }
  constexpr double slowest_m_s = 1.0;  // even in still air an eddy does not last for ever
  step_turbulence(dt_s, eddies_, std::max({air_speed_m_s, mean, slowest_m_s}));
  const double deviation_m_s = parameters_.turbulence * mean;
  const Vector3 sideways{.x = -direction_.y, .y = direction_.x};
  Vector3 wind_m_s =
      (speed_m_s + deviation_m_s * along_.value()) * direction_ + (deviation_m_s * across_.value()) * sideways;
  wind_m_s.z = deviation_m_s * eddies_.vertical_share * vertical_;
  return wind_m_s;
}

}  // namespace fantail::sim
