// SPDX-License-Identifier: MIT
#include "identify/model/planted.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace fantail::identify::model {
namespace {

double canard_rad(const Planting& p, double t) {
  return radians_per_degree * p.canard_amplitude_deg *
         (0.5 * std::sin(5.0 * t) + 0.3 * std::sin(17.0 * t + 1.0) + 0.2 * std::sin(31.0 * t + 2.0));
}

double speed_m_s(const Planting& p, double t) {
  return p.speed_begin_m_s + (p.speed_end_m_s - p.speed_begin_m_s) * t / p.seconds;
}

constexpr double density_kg_m3 = 1.2;

}  // namespace

double planted_disturbance_rad(const Planting& p, double t) {
  const std::vector<double>& time = p.node_time_s;
  if (t <= time.front()) {
    return radians_per_degree * p.node_deg.front();
  }
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (t <= time[k]) {
      const double share = (t - time[k - 1]) / (time[k] - time[k - 1]);
      return radians_per_degree * ((1.0 - share) * p.node_deg[k - 1] + share * p.node_deg[k]);
    }
  }
  return radians_per_degree * p.node_deg.back();
}

Record planted_record(const Planting& p) {
  constexpr int steps_per_sample = 40;
  const auto samples = static_cast<std::size_t>(std::lround(p.seconds * p.sample_hz)) + 1;
  const double h = 1.0 / (p.sample_hz * steps_per_sample);
  double angle = radians_per_degree * p.start_angle_deg;
  double rate = radians_per_degree * p.start_rate_deg_s;
  const auto acceleration = [&](double t, double at_rate) {
    const double v = speed_m_s(p, t);
    const double common = 0.5 * density_kg_m3 * v * tasha.reference_area_m2 / tasha.inertia_kg_m2;
    return common * (v * p.beta_m * (canard_rad(p, t) + planted_disturbance_rad(p, t)) - p.alpha_m2 * at_rate);
  };
  Record record;
  record.window = "planted";
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / p.sample_hz;
    record.time_s.push_back(t);
    record.roll_angle_rad.push_back(angle);
    record.roll_rate_rad_s.push_back(rate);
    record.canard_rad.push_back(canard_rad(p, t));
    record.speed_m_s.push_back(speed_m_s(p, t));
    record.density_kg_m3.push_back(density_kg_m3);
    for (int k = 0; k < steps_per_sample; ++k) {
      const double from = t + k * h;
      const double middle_rate = rate + 0.5 * h * acceleration(from, rate);
      const double middle = acceleration(from + 0.5 * h, middle_rate);
      angle += h * middle_rate;
      rate += h * middle;
    }
  }
  return record;
}

void add_noise(Record& record, const Noise& noise, std::uint64_t seed) {
  std::mt19937_64 generator{seed};
  std::normal_distribution<double> gauss;
  const double deviation = radians_per_degree * noise.angle_deg;
  double wander = deviation * gauss(generator);
  for (std::size_t i = 0; i < record.size(); ++i) {
    if (i > 0) {
      const double kept =
          noise.correlation_s > 0.0 ? std::exp(-(record.time_s[i] - record.time_s[i - 1]) / noise.correlation_s) : 0.0;
      wander = kept * wander + std::sqrt(1.0 - kept * kept) * deviation * gauss(generator);
    }
    record.roll_angle_rad[i] += wander;
    record.roll_rate_rad_s[i] += radians_per_degree * noise.rate_deg_s * gauss(generator);
  }
}

}  // namespace fantail::identify::model
