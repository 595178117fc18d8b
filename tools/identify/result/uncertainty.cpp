// SPDX-License-Identifier: MIT
#include "identify/result/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/core.h>

#include "distributions/quantiles.hpp"
#include "identify/closed_loop/closed_loop.hpp"
#include "identify/model/alpha_fit.hpp"
#include "identify/model/least_squares.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/result/residual.hpp"
#include "identify/result/words.hpp"
#include "linear/dense.hpp"
#include "text/number.hpp"

namespace fantail::identify::result {
namespace {

using namespace model;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The inverse of J'J, computed on columns of unit length: alpha, beta and angles differ by orders of magnitude.
MatrixXd inverse_information(const MatrixXd& columns) {
  const VectorXd length = columns.colwise().norm().cwiseMax(1e-300);
  const MatrixXd unit = columns * length.cwiseInverse().asDiagonal();
  // Numbers that the data do not tell apart must come out as unknown, not as a failed inversion.
  MatrixXd gram = linear::gram(unit);
  gram.diagonal().array() += 1e-14;
  const MatrixXd inverse = linear::Factors{gram}.inverse();
  return length.cwiseInverse().asDiagonal() * inverse * length.cwiseInverse().asDiagonal();
}

// What the data do not tell apart at all, as variance of the numbers: along these directions they may be a thousand
// times what they are. The inverse knows nothing of it, because what has no effect has no weight.
MatrixXd undetermined(const MatrixXd& columns, const VectorXd& size) {
  constexpr double nothing = 1e-12;  // of an eigenvalue: two columns differ by a millionth of their length
  constexpr double times = 1e3;
  const VectorXd length = columns.colwise().norm().cwiseMax(1e-300);
  const MatrixXd unit = columns * length.cwiseInverse().asDiagonal();
  const linear::Eigensystem gram = linear::eigensystem(linear::gram(unit));
  MatrixXd covariance = MatrixXd::Zero(columns.cols(), columns.cols());
  for (Index k = 0; k < columns.cols() && gram.values(k) < nothing; ++k) {
    const VectorXd direction = gram.vectors.col(k).cwiseQuotient(length);
    const VectorXd scaled = times / direction.cwiseQuotient(size).cwiseAbs().maxCoeff() * direction;
    covariance += scaled * scaled.transpose();
  }
  return covariance;
}

VectorXd residual_of(const std::vector<double>& measured, const std::vector<double>& modelled) {
  const auto n = static_cast<Index>(measured.size());
  return Eigen::Map<const VectorXd>(measured.data(), n) - Eigen::Map<const VectorXd>(modelled.data(), n);
}

MatrixXd joined_columns(const MatrixXd& left, const MatrixXd& right) {
  if (right.cols() == 0) {
    return left;
  }
  MatrixXd both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

// The sum of squared angle errors when everything but alpha is fitted.
using AlphaProfile = std::function<double(double alpha_m2)>;

// Every number of the model is a weighted sum of the measured angles; a row of weights for each.
struct Weights {
  MatrixXd of_angles;
  MatrixXd of_start_rates;
};

Weights weights(const Record& record, const Sensitivities& s, Start start, const MatrixXd& fitted,
                const MatrixXd& inverse) {
  const Index numbers = s.numbers.cols() + s.lag.cols();
  Weights result;
  result.of_angles = linear::product(inverse, fitted.transpose()).topRows(numbers);
  if (start == Start::measured) {
    // An error of the first angle shifts the modelled angle of the whole segment.
    const MatrixXd shift = linear::product(result.of_angles, s.start_angle);
    result.of_start_rates = linear::product(result.of_angles, s.start_rate);
    for (std::size_t k = 0; k < record.segment_begin.size(); ++k) {
      result.of_angles.col(static_cast<Index>(record.segment_begin[k])) -= shift.col(static_cast<Index>(k));
    }
  }
  return result;
}

// Walks away from the estimate until the profile has risen to `level`, then halves.
std::optional<double> crossing(const AlphaProfile& profile, const AlphaRange& range, double from_m2, double factor,
                               double level) {
  double inside = from_m2;
  double outside = from_m2 * factor;
  while (!(profile(outside) > level)) {
    inside = outside;
    outside *= factor;
    if (!range.contains(outside)) {
      return std::nullopt;
    }
  }
  constexpr int halvings = 30;
  for (int i = 0; i < halvings && std::abs(outside - inside) > 1e-6 * from_m2; ++i) {
    const double middle = 0.5 * (inside + outside);
    (profile(middle) > level ? outside : inside) = middle;
  }
  return 0.5 * (inside + outside);
}

std::string verdict(const Uncertainty& u, const RollModel& model, bool excited) {
  if (u.alpha_identifiable && u.beta_identifiable) {
    return "alpha and beta are identifiable from this window";
  }
  if (*u.interval[1].high < 0.0) {
    return fmt::format(
        "beta is negative, {} m, with a 95 % interval of {} to {} m: positive canard angles turn this rocket in the "
        "negative direction. The canard column most likely has the opposite sign; change it, and check that of the "
        "roll rate",
        constant_text(model.beta_m), constant_text(*u.interval[1].low), constant_text(*u.interval[1].high));
  }
  const std::string cause = excited
                                ? "too little excitation for the noise and length of this window"
                                : "no excitation, the effect of the canards cannot be told apart from the disturbance";
  const std::string who = u.alpha_identifiable ? "beta is" : u.beta_identifiable ? "alpha is" : "alpha and beta are";
  return who + " not identifiable from this window: " + cause;
}

// How many independent samples would have told alpha and beta to the same deviation: of the two, what is known worse.
double worth(double samples, double variance_rad2, const MatrixXd& inverse, const MatrixXd& covariance) {
  const auto share = [&](Index k) { return variance_rad2 * inverse(k, k) / std::max(covariance(k, k), 1e-300); };
  return samples * std::min({1.0, share(0), share(1)});
}

Uncertainty uncertainty_of(const Record& record, const RollModel& model, const Simulation& simulation,
                           const Sensitivities& sensitivities, Start start, const AlphaRange& range,
                           const AlphaProfile& profile) {
  const VectorXd residual = residual_of(record.roll_angle_rad, simulation.roll_angle_rad);
  const MatrixXd starts = joined_columns(sensitivities.start_angle, sensitivities.start_rate);
  const MatrixXd numbers = joined_columns(sensitivities.numbers, sensitivities.lag);
  const MatrixXd everything = joined_columns(numbers, starts);
  const MatrixXd& fitted = start == Start::fitted ? everything : numbers;
  const MatrixXd inverse = inverse_information(fitted);
  const ResidualNoise noise = estimate_noise(record.time_s, residual, everything);
  const Weights weight = weights(record, sensitivities, start, fitted, inverse);

  MatrixXd covariance =
      linear::product(weight.of_angles, noise.covariance_times(record.time_s, weight.of_angles.transpose()));
  if (start == Start::measured) {
    const double rate_variance = residual_of(record.roll_rate_rad_s, simulation.roll_rate_rad_s).squaredNorm() /
                                 static_cast<double>(record.size());
    covariance += rate_variance * linear::product(weight.of_start_rates, weight.of_start_rates.transpose());
  }
  VectorXd size = VectorXd::Ones(fitted.cols());
  const std::vector<double> found = model.numbers();
  for (std::size_t k = 0; k < found.size(); ++k) {
    size(static_cast<Index>(k)) = std::max(std::abs(found[k]), 1e-6);
  }
  covariance += undetermined(fitted, size).topLeftCorner(covariance.rows(), covariance.cols());

  Uncertainty result;
  result.effective_samples = worth(static_cast<double>(record.size()), noise.variance_rad2, inverse, covariance);
  result.residual_rms_rad = std::sqrt(residual.squaredNorm() / static_cast<double>(record.size()));
  result.residual_correlation_s = (1.0 - noise.white_share) * noise.correlation_s;
  // Half of the samples go into finding out what the noise is like.
  result.degrees_of_freedom =
      std::max(0.5 * (noise.effective_samples(record.time_s) - static_cast<double>(fitted.cols())), 2.0);
  const double quantile = distributions::student_975(result.degrees_of_freedom);
  const Index own = sensitivities.numbers.cols();
  const VectorXd all_deviations = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  const VectorXd deviation = all_deviations.head(own);
  const VectorXd per_deviation = deviation.cwiseMax(1e-300).cwiseInverse();
  result.correlation = per_deviation.asDiagonal() * covariance.topLeftCorner(own, own) * per_deviation.asDiagonal();
  if (sensitivities.lag.cols() > 0) {
    result.lag_s = {.standard_deviation = all_deviations(own), .reach = quantile * all_deviations(own)};
  }
  if (sensitivities.lag.cols() > 1) {  // the second is by half of the play
    const double deviation_rad = 2.0 * all_deviations(own + 1);
    result.play_rad = {.standard_deviation = deviation_rad, .reach = quantile * deviation_rad};
  }
  result.standard_deviation.assign(deviation.begin(), deviation.end());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const double reach = quantile * result.standard_deviation[k];
    result.interval.push_back({.low = found[k] - reach, .high = found[k] + reach});
  }

  // Where the profile has risen by as much as it would at that distance if it were a parabola.
  const double rise = quantile * quantile * covariance(0, 0) / inverse(0, 0);
  const double level = profile(model.alpha_m2) + rise;
  constexpr double stride = 1.3;
  result.alpha_profile_m2 = {.low = crossing(profile, range, model.alpha_m2, 1.0 / stride, level),
                             .high = crossing(profile, range, model.alpha_m2, stride, level)};
  result.alpha_identifiable = is_identifiable(result.alpha_profile_m2);
  result.beta_identifiable = is_identifiable(result.interval[1]);
  constexpr double none_rad = 1e-9;
  result.verdict = verdict(result, model, excitation_rad(record, model.node_time_s) > none_rad);
  return result;
}

}  // namespace

bool is_identifiable(const Interval& interval) {
  constexpr double widest_factor = 4.0;
  return interval.low && interval.high && *interval.low > 0.0 && *interval.high <= widest_factor * *interval.low;
}

VectorXd cramer_rao_standard_deviations(const Sensitivities& sensitivities, double angle_noise_rad) {
  return angle_noise_rad * inverse_information(sensitivities.numbers).diagonal().cwiseSqrt();
}

double excitation_rad(const Record& record, const NodeTimes& nodes) {
  const auto samples = static_cast<Index>(record.size());
  MatrixXd columns = MatrixXd::Zero(samples, static_cast<Index>(nodes.size()) + 1);
  for (Index i = 0; i < samples; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const NodeShare share = node_share(nodes, record.time_s[at]);
    columns(i, static_cast<Index>(share.left)) += 1.0 - share.right_share;
    columns(i, static_cast<Index>(share.right)) += share.right_share;
    columns(i, columns.cols() - 1) = record.canard_rad[at];
  }
  const OrthogonalFit fit{columns, columns.cols() - 1};
  return columns.rightCols(1).norm() / std::sqrt(static_cast<double>(samples));
}

Uncertainty open_loop_uncertainty(const Record& record, const Airframe& airframe, const RollModel& model,
                                  const Simulation& simulation, Start start) {
  const ResponseBasis basis{record, airframe, model.node_time_s, start};
  return uncertainty_of(record, model, simulation, open_loop_sensitivities(record, airframe, model), start,
                        alpha_range(airframe),
                        [&basis](double alpha_m2) { return AlphaFit{basis, alpha_m2}.least_squares_rad2(); });
}

Uncertainty closed_loop_uncertainty(const Record& record, const Airframe& airframe, const closed_loop::Control& control,
                                    const RollModel& model, const Simulation& simulation, Start start) {
  closed_loop::Descent descent{record, airframe, control, model.node_time_s, start};
  const auto profile = [&](double alpha_m2) {
    RollModel begin = model;
    begin.alpha_m2 = alpha_m2;
    return descent.from(begin, closed_loop::Alpha::held).squares_rad2;
  };
  Record commanded = record;
  commanded.canard_rad = simulation.canard_rad;
  return uncertainty_of(commanded, model, simulation, closed_loop::sensitivities(record, airframe, control, model),
                        start, alpha_range(airframe), profile);
}

}  // namespace fantail::identify::result
