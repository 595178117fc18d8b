// SPDX-License-Identifier: MIT
#include "tunnel/swing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Core>
#include <fmt/core.h>

#include "linear/dense.hpp"
#include "text/number.hpp"
#include "tunnel/statistics.hpp"

namespace fantail::tunnel {
namespace {

using Eigen::Index;
using Eigen::Matrix;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index parameters = 5;  // c, a, b, s, w
using Parameters = Matrix<double, parameters, 1>;
using Normal = Matrix<double, parameters, parameters>;

struct Fit {
  Parameters at;
  double cost = std::numeric_limits<double>::infinity();  ///< sum of squares
};

class Samples {
 public:
  Samples(std::vector<double> time_s, std::vector<double> value)
      : time_s_{std::move(time_s)}, value_{std::move(value)} {}

  [[nodiscard]] double seconds() const { return time_s_.back(); }
  [[nodiscard]] std::size_t size() const { return time_s_.size(); }

  /// With decay and frequency given, the rest is linear.
  [[nodiscard]] Fit linear(double decay, double frequency) const {
    MatrixXd columns(static_cast<Index>(size()), 3);
    const VectorXd values = Eigen::Map<const VectorXd>(value_.data(), static_cast<Index>(size()));
    for (Index i = 0; i < columns.rows(); ++i) {
      const double t = time_s_[static_cast<std::size_t>(i)];
      const double envelope = std::exp(-decay * t);
      columns.row(i) << 1.0, envelope * std::cos(frequency * t), envelope * std::sin(frequency * t);
    }
    const Eigen::Vector3d solution = linear::least_squares(columns, values);
    return {.at = {solution[0], solution[1], solution[2], decay, frequency},
            .cost = (columns * solution - values).squaredNorm()};
  }

  [[nodiscard]] double value_at(const Parameters& p, std::size_t i) const {
    const double t = time_s_[i];
    return p[0] + std::exp(-p[3] * t) * (p[1] * std::cos(p[4] * t) + p[2] * std::sin(p[4] * t));
  }
  [[nodiscard]] double residual(const Parameters& p, std::size_t i) const { return value_[i] - value_at(p, i); }

  [[nodiscard]] Parameters slope(const Parameters& p, std::size_t i) const {
    const double t = time_s_[i];
    const double envelope = std::exp(-p[3] * t);
    const double cosine = envelope * std::cos(p[4] * t);
    const double sine = envelope * std::sin(p[4] * t);
    return {1.0, cosine, sine, -t * (p[1] * cosine + p[2] * sine), t * (p[2] * cosine - p[1] * sine)};
  }

  struct Equations {
    Normal normal;
    Parameters right;
    double cost;
  };
  [[nodiscard]] Equations equations(const Parameters& p) const {
    Equations e{.normal = Normal::Zero(), .right = Parameters::Zero(), .cost = 0.0};
    for (std::size_t i = 0; i < size(); ++i) {
      const Parameters row = slope(p, i);
      const double r = residual(p, i);
      e.normal += row * row.transpose();
      e.right += r * row;
      e.cost += r * r;
    }
    return e;
  }

 private:
  std::vector<double> time_s_;  ///< from zero
  std::vector<double> value_;
};

/// Levenberg and Marquardt, from the best of a grid of decays and frequencies.
Fit least_squares(const Samples& samples) {
  Fit best;
  double frequency = std::numbers::pi / samples.seconds();
  while (frequency < 60.0) {
    for (const double ratio : {0.0, 0.05, 0.15, 0.4, 1.0}) {
      if (const Fit found = samples.linear(ratio * frequency, frequency); found.cost < best.cost) {
        best = found;
      }
    }
    frequency *= 1.12;
  }
  double damping = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const Samples::Equations e = samples.equations(best.at);
    Normal damped = e.normal;
    damped.diagonal() *= 1.0 + damping;
    const Parameters next = best.at + linear::Factors{damped}.solve(e.right).col(0);
    const double cost = samples.equations(next).cost;
    if (!(cost < best.cost)) {
      damping *= 10.0;
      if (damping > 1e8) {
        break;
      }
      continue;
    }
    const bool done = best.cost - cost < 1e-12 * best.cost;
    best = {.at = next, .cost = cost};
    damping *= 0.1;
    if (done) {
      break;
    }
  }
  best.at[4] = std::abs(best.at[4]);
  return best;
}

/// Did the rocket leave where it hung ever faster, as an unstable one does without a push? From 1.25 to 5 degrees it
/// then takes as long as from 5 to 20. After a push it takes four times as long for the second, and pushed evenly twice
/// as long.
bool departs(const SwingLog& log, std::size_t first_too_large, double largest_rad) {
  constexpr double step = 4.0;
  constexpr double slower_than_a_push = 1.4;
  constexpr double shortest_s = 0.3;
  const auto last_below = [&](double angle_rad, std::size_t before) -> std::optional<std::size_t> {
    for (std::size_t i = before; i-- > 0;) {
      if (std::abs(log.angle_rad[i]) < angle_rad) {
        return i;
      }
    }
    return std::nullopt;
  };
  const auto beyond = last_below(largest_rad, first_too_large);
  const auto middle = beyond ? last_below(largest_rad / step, *beyond) : std::nullopt;
  const auto begin = middle ? last_below(largest_rad / (step * step), *middle) : std::nullopt;
  if (!begin) {
    return false;
  }
  const double first_s = log.time_s[*middle] - log.time_s[*begin];
  const double second_s = log.time_s[*beyond] - log.time_s[*middle];
  return first_s > shortest_s && second_s < slower_than_a_push * first_s;
}

/// Standard deviation of the noise, which is not alike from one sample to the next as a swing is: from the median of
/// the second differences.
double noise_of(const std::vector<double>& value) {
  std::vector<double> size;
  for (std::size_t i = 2; i < value.size(); ++i) {
    size.push_back(std::abs(value[i] - 2.0 * value[i - 1] + value[i - 2]));
  }
  const auto middle = size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2);
  std::ranges::nth_element(size, middle);
  constexpr double of_median = 0.6745;  // of a normal distribution
  return *middle / (of_median * std::sqrt(6.0));
}

/// Largest distance from the middle, in one third of the stretch.
double size_in_third(const std::vector<double>& value, std::size_t third) {
  const double middle = mean(value);
  double largest = 0.0;
  for (std::size_t i = third * value.size() / 3; i < (third + 1) * value.size() / 3; ++i) {
    largest = std::max(largest, std::abs(value[i] - middle));
  }
  return largest;
}

/// Of a function of decay and frequency, by its slopes.
double deviation(const Eigen::Matrix2d& covariance, double by_decay, double by_frequency) {
  const Eigen::Vector2d slope{by_decay, by_frequency};
  return std::sqrt(std::max(0.0, slope.dot(covariance * slope)));
}

Swing swing_of(const SwingStretch& stretch, const Samples& samples, const Fit& fit, bool log_is_rate,
               std::vector<double> time_s, std::vector<double> measured) {
  std::vector<double> residuals(samples.size());
  std::vector<double> fitted(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    residuals[i] = samples.residual(fit.at, i);
    fitted[i] = samples.value_at(fit.at, i);
  }
  const auto n = static_cast<double>(samples.size());
  const double worth = std::min(known_mean(residuals).independent_samples, n);
  const double variance = fit.cost / std::max(n - static_cast<double>(parameters), 1.0) * (n / worth);
  const Normal covariance = variance * linear::Factors{samples.equations(fit.at).normal}.inverse();
  const Eigen::Matrix2d both = covariance.bottomRightCorner<2, 2>();
  const double s = fit.at[3];
  const double w = fit.at[4];
  const double stiffness = s * s + w * w;
  const double root = std::sqrt(stiffness);
  return {.begin_s = stretch.begin_s,
          .end_s = stretch.end_s,
          .frequency_rad_s = {w, deviation(both, 0.0, 1.0)},
          .decay_per_s = {s, deviation(both, 1.0, 0.0)},
          .stiffness_per_s2 = {stiffness, deviation(both, 2.0 * s, 2.0 * w)},
          .damping_ratio = {s / root, deviation(both, w * w / (stiffness * root), -s * w / (stiffness * root))},
          .largest_rad = std::hypot(fit.at[1], fit.at[2]) / (log_is_rate ? root : 1.0),
          .logarithmic_decrement = 2.0 * std::numbers::pi * s / w,
          .time_s = std::move(time_s),
          .measured = std::move(measured),
          .fitted = std::move(fitted)};
}

}  // namespace

SwingResult fit_swing(const SwingLog& log, const SwingStretch& stretch) {
  constexpr std::size_t fewest_samples = 20;
  constexpr double largest_rad = 20.0 * std::numbers::pi / 180.0;
  SwingResult result{.stretch = stretch};
  std::vector<double> time_s;
  std::vector<double> measured;
  double farthest_rad = 0.0;
  std::optional<std::size_t> first_too_large;
  for (std::size_t i = 0; i < log.time_s.size(); ++i) {
    if (log.time_s[i] >= stretch.begin_s && log.time_s[i] <= stretch.end_s) {
      farthest_rad = std::max(farthest_rad, std::abs(log.angle_rad[i]));
      if (farthest_rad > largest_rad) {
        first_too_large = first_too_large.value_or(i);
      }
      time_s.push_back(log.time_s[i]);
      measured.push_back(log.value[i]);
    }
  }
  if (time_s.size() < fewest_samples) {
    result.reason =
        fmt::format("it has only {}; allowed: {} or more", text::counted(time_s.size(), "sample"), fewest_samples);
    return result;
  }
  if (first_too_large && departs(log, *first_too_large, largest_rad)) {
    result.grows = true;
    result.reason = "the rocket turns away from its rest position faster and faster, which a push alone cannot cause";
    return result;
  }
  if (first_too_large) {
    result.is_too_large = true;
    result.reason = fmt::format("the rocket was {:.0f} degrees from its rest position; allowed: up to 20",
                                farthest_rad * 180.0 / std::numbers::pi);
    return result;
  }
  constexpr double out_of_noise = 6.0;  // of noise alone the largest of thousands is four deviations away
  const double largest = std::max({size_in_third(measured, 0), size_in_third(measured, 1), size_in_third(measured, 2)});
  if (largest < out_of_noise * noise_of(log.value)) {
    result.reason = "it is lost in the noise";
    return result;
  }
  if (size_in_third(measured, 2) > 1.5 * size_in_third(measured, 0)) {
    result.grows = true;
    result.reason = "the swing grows instead of dying out";
    return result;
  }
  std::vector<double> from_zero = time_s;
  std::ranges::for_each(from_zero, [&](double& t) { t -= stretch.begin_s; });
  const Samples samples{std::move(from_zero), measured};
  const Fit fit = least_squares(samples);
  Swing swing = swing_of(stretch, samples, fit, log.is_rate, std::move(time_s), std::move(measured));
  const double period_s = 2.0 * std::numbers::pi / swing.frequency_rad_s.value;
  if (swing.decay_per_s.value + 2.0 * swing.decay_per_s.deviation < 0.0) {
    result.grows = true;
    result.reason = "the swing grows instead of dying out";
  } else if (samples.seconds() < period_s) {
    result.reason = fmt::format("it lasts {:.1f} s, less than one period of {:.1f} s", samples.seconds(), period_s);
  } else if (!(swing.stiffness_per_s2.deviation < 0.2 * swing.stiffness_per_s2.value)) {
    result.reason = "it dies out, or is lost in the noise, before its frequency can be determined";
  } else {
    result.swing = std::move(swing);
  }
  return result;
}

}  // namespace fantail::tunnel
