// SPDX-License-Identifier: MIT
#include "identify/result/residual.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/core.h>

#include "identify/model/least_squares.hpp"
#include "linear/dense.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using Eigen::Index;

double correlation_after(std::span<const double> time_s, std::size_t i, double correlation_s) {
  return correlation_s > 0.0 ? std::exp(-(time_s[i] - time_s[i - 1]) / correlation_s) : 0.0;
}

struct Shape {
  double white_share;
  double correlation_s;
};

// Likelihood of a shape, by a Kalman filter that turns residual and explaining columns into what they would be without
// correlation.
class Likelihood {
 public:
  Likelihood(std::span<const double> time_s, const Eigen::VectorXd& residual, const Eigen::MatrixXd& explaining)
      : time_s_{time_s}, rows_(residual.size(), explaining.cols() + 1) {
    // Scaled: alpha, beta and angles have sizes that differ by orders of magnitude.
    for (Index j = 0; j < explaining.cols(); ++j) {
      const double length = explaining.col(j).norm();
      rows_.col(j) = explaining.col(j) / (length > 0.0 ? length : 1.0);
    }
    rows_.rightCols(1) = residual;
  }

  /// Minus twice the logarithm, up to a constant; and the variance that goes with it.
  struct Value {
    double cost;
    double variance_rad2;
  };
  [[nodiscard]] Value at(const Shape& shape) const {
    const Index width = rows_.cols();
    const Index unknowns = width - 1;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(width, width);
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(width);
    Eigen::VectorXd surprise(width);
    const double coloured = 1.0 - shape.white_share;
    double spread = coloured;
    double log_determinant = 0.0;
    for (Index i = 0; i < rows_.rows(); ++i) {
      if (i > 0) {
        const double kept = correlation_after(time_s_, static_cast<std::size_t>(i), shape.correlation_s);
        expected *= kept;
        spread = kept * kept * spread + coloured * (1.0 - kept * kept);
      }
      const double total = spread + shape.white_share;
      surprise = rows_.row(i).transpose() - expected;
      gram.selfadjointView<Eigen::Lower>().rankUpdate(surprise, 1.0 / total);
      log_determinant += std::log(total);
      const double gain = spread / total;
      expected += gain * surprise;
      spread *= 1.0 - gain;
    }
    const Eigen::MatrixXd full = gram.selfadjointView<Eigen::Lower>();
    const linear::Factors known{full.topLeftCorner(unknowns, unknowns)};
    const Eigen::VectorXd side = full.topRightCorner(unknowns, 1);
    const double rest = full(unknowns, unknowns) - side.dot(known.solve(side).col(0));
    const double freedom = static_cast<double>(rows_.rows() - unknowns);
    const double variance = std::max(rest / freedom, std::numeric_limits<double>::min());
    const double log_known = known.pivots().cwiseAbs().array().max(1e-300).log().sum();
    return {.cost = freedom * std::log(variance) + log_known + log_determinant, .variance_rad2 = variance};
  }

 private:
  std::span<const double> time_s_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_;
};

double mean_square(const std::vector<double>& list) {
  double sum = 0.0;
  for (const double value : list) {
    sum += value * value;
  }
  return sum / static_cast<double>(list.size());
}

// Of the residual with itself, 10 ms or a sample later. No mean is taken away: it is a lack of the model, too.
double autocorrelation(const Record& record, const std::vector<double>& residual) {
  constexpr double later_s = 0.01;
  constexpr double too_late_s = 0.2;
  double together = 0.0;
  double alone = 0.0;
  std::size_t j = 0;
  for (std::size_t i = 0; i + 1 < record.size(); ++i) {
    while (j + 1 < record.size() && (j <= i || record.time_s[j] - record.time_s[i] < 0.999 * later_s)) {
      ++j;
    }
    if (record.time_s[j] - record.time_s[i] < too_late_s) {
      together += residual[i] * residual[j];
      alone += 0.5 * (residual[i] * residual[i] + residual[j] * residual[j]);
    }
  }
  return alone > 0.0 ? together / alone : 0.0;
}

std::vector<double> rate_residual(const Record& record, const Simulation& simulation) {
  std::vector<double> residual = record.roll_rate_rad_s;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    residual[i] -= simulation.roll_rate_rad_s[i];
  }
  return residual;
}

bool is_motion(const Record& record, const std::vector<double>& residual) {
  constexpr double motion = 0.5;
  return autocorrelation(record, residual) >= motion;
}

}  // namespace

Eigen::MatrixXd ResidualNoise::covariance_times(std::span<const double> time_s, const Eigen::MatrixXd& columns) const {
  const auto samples = static_cast<Index>(time_s.size());
  Eigen::MatrixXd coloured = columns;
  Eigen::RowVectorXd past = Eigen::RowVectorXd::Zero(columns.cols());
  Eigen::RowVectorXd future = past;
  for (Index i = 1; i < samples; ++i) {
    past = correlation_after(time_s, static_cast<std::size_t>(i), correlation_s) * (past + columns.row(i - 1));
    coloured.row(i) += past;
    const Index back = samples - 1 - i;
    future =
        correlation_after(time_s, static_cast<std::size_t>(back + 1), correlation_s) * (future + columns.row(back + 1));
    coloured.row(back) += future;
  }
  return variance_rad2 * (white_share * columns + (1.0 - white_share) * coloured);
}

double ResidualNoise::effective_samples(std::span<const double> time_s) const {
  const auto samples = static_cast<double>(time_s.size());
  const double mean_step_s = (time_s.back() - time_s.front()) / (samples - 1.0);
  const double kept = correlation_s > 0.0 ? std::exp(-mean_step_s / correlation_s) : 0.0;
  return samples / (white_share + (1.0 - white_share) * (1.0 + kept) / (1.0 - kept));
}

ResidualNoise estimate_noise(std::span<const double> time_s, const Eigen::VectorXd& residual,
                             const Eigen::MatrixXd& explaining) {
  const Likelihood likelihood{time_s, residual, explaining};
  const double length_s = time_s.back() - time_s.front();
  const double step_s = length_s / static_cast<double>(time_s.size() - 1);
  const Shape white{.white_share = 1.0, .correlation_s = 0.0};
  Shape best = white;
  double least = likelihood.at(white).cost;
  const auto try_shape = [&](const Shape& shape) {
    const double cost = likelihood.at(shape).cost;
    if (cost < least) {
      least = cost;
      best = shape;
    }
    return cost;
  };
  constexpr std::array white_shares{0.0, 0.2, 0.5, 0.8};
  constexpr int times = 7;
  const double shortest = std::log(0.5 * step_s);
  const double longest = std::log(0.5 * length_s);
  const double spacing = (longest - shortest) / (times - 1);
  for (const double white_share : white_shares) {
    for (int i = 0; i < times; ++i) {
      try_shape({.white_share = white_share, .correlation_s = std::exp(shortest + i * spacing)});
    }
  }
  if (best.correlation_s > 0.0) {
    constexpr int rounds = 2;
    constexpr int places = 3;
    for (int round = 0; round < rounds; ++round) {
      const Shape at = best;
      const double log_s = std::log(at.correlation_s);
      (void)least_over([&](double x) { return try_shape({at.white_share, std::exp(x)}); },
                       {.low = log_s - spacing, .high = std::min(longest, log_s + spacing)}, places, 1e-3);
      const double correlation_s = best.correlation_s;
      (void)least_over([&](double share) { return try_shape({share, correlation_s}); },
                       {.low = std::max(0.0, at.white_share - 0.3), .high = std::min(1.0, at.white_share + 0.3)},
                       places, 1e-3);
    }
  }
  return {.variance_rad2 = likelihood.at(best).variance_rad2,
          .white_share = best.white_share,
          .correlation_s = best.correlation_s};
}

double share_left(const Record& record, const Simulation& simulation) {
  const double motion = mean_square(record.roll_rate_rad_s);
  return motion > 0.0 ? std::sqrt(mean_square(rate_residual(record, simulation)) / motion) : 0.0;
}

bool is_refuted(const Record& record, const Identification& result) {
  constexpr double contradiction = 0.5;
  return share_left(record, result.simulation) >= contradiction &&
         is_motion(record, rate_residual(record, result.simulation));
}

std::optional<std::string> misfit(const Record& record, const Identification& result) {
  constexpr double negligible = 0.01;
  const std::vector<double> residual = rate_residual(record, result.simulation);
  if (share_left(record, result.simulation) < negligible || !is_motion(record, residual)) {
    return {};
  }
  const double strength = std::sqrt(mean_square(residual));
  return fmt::format(
      "The model does not fit this log well. The residual of the roll rate, {} deg/s RMS, is motion, not noise. The "
      "intervals do not include this error. {}Possible causes: too few nodes, an input that changes within the window, "
      "or {}.",
      text::brief(text::degrees(strength), 2),
      is_refuted(record, result) ? "Check units and signs of the columns first. " : "",
      result.loop == Loop::open ? "a lag of the canard column" : "servos that differ from the model");
}

}  // namespace fantail::identify::result
