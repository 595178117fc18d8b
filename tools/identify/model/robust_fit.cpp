// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "identify/model/least_squares.hpp"
#include "identify/model/open_loop.hpp"

namespace fantail::identify::model {
namespace {

// Of Gauss' noise: the median of the magnitudes is one standard deviation divided by this.
constexpr double deviations_per_median = 1.4826;
// 95 % of the efficiency of least squares where the noise is Gauss' after all.
constexpr double threshold_deviations = 1.345;
// A log without noise has errors of rounding only.
constexpr double least_threshold_rad = 1e-12;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// Where the search begins. From a first sample that is far off, least squares would make a motion that is gone within a
// sample; its error is then nil, and no weight could bring the model back.
Record without_single_outliers(const Record& record) {
  constexpr std::size_t neighbours = 2;  // on either side
  Record calm = record;
  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const std::size_t first = record.segment_begin[s];
    const std::size_t end = s + 1 < record.segment_begin.size() ? record.segment_begin[s + 1] : record.size();
    const std::size_t width = std::min(2 * neighbours + 1, end - first);
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t from = std::min(std::max(i, first + neighbours) - neighbours, end - width);
      calm.roll_angle_rad[i] = median({record.roll_angle_rad.begin() + static_cast<std::ptrdiff_t>(from),
                                       record.roll_angle_rad.begin() + static_cast<std::ptrdiff_t>(from + width)});
    }
  }
  return calm;
}

RobustFit judged(const Record& record, const Airframe& airframe, RollModel model) {
  const std::vector<double> modelled = simulate_open_loop(record, airframe, model).roll_angle_rad;
  std::vector<double> magnitude;
  magnitude.reserve(record.size());
  for (std::size_t i = 0; i < record.size(); ++i) {
    magnitude.push_back(std::abs(record.roll_angle_rad[i] - modelled[i]));
  }
  const double threshold =
      std::max(threshold_deviations * deviations_per_median * median(magnitude), least_threshold_rad);
  const auto beyond =
      static_cast<std::size_t>(std::ranges::count_if(magnitude, [&](double m) { return m > threshold; }));
  // At least a half: the threshold is twice the median.
  const double share_within = 1.0 - static_cast<double>(beyond) / static_cast<double>(record.size());
  Record pseudo = record;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double error = record.roll_angle_rad[i] - modelled[i];
    pseudo.roll_angle_rad[i] = modelled[i] + std::clamp(error, -threshold, threshold) / share_within;
  }
  return {.model = std::move(model),
          .threshold_rad = threshold,
          .beyond = beyond,
          .settled = false,
          .pseudo_record = std::move(pseudo)};
}

bool close(double a, double b) {
  constexpr double relative = 1e-5;
  return std::abs(a - b) <= relative * std::abs(a);
}

}  // namespace

RobustFit fit_open_loop_robustly(const Record& record, const Airframe& airframe, const NodeTimes& nodes,
                                 const Grid& grid) {
  constexpr int most_rounds = 50;
  const auto squares = [&](const Record& of) { return fit_open_loop(of, airframe, nodes, Start::fitted, grid); };
  RobustFit fit = judged(record, airframe, squares(without_single_outliers(record)));
  for (int i = 0; i < most_rounds && !fit.settled; ++i) {
    RollModel next = squares(fit.pseudo_record);
    const bool settled = close(fit.model.alpha_m2, next.alpha_m2) && close(fit.model.beta_m, next.beta_m);
    fit = judged(record, airframe, std::move(next));
    fit.settled = settled;
  }
  return fit;
}

}  // namespace fantail::identify::model
