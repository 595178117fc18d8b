// SPDX-License-Identifier: MIT
#include "campaign/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <Eigen/Core>

#include "linear/dense.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

constexpr double normal_975 = 1.959963984540054;
constexpr std::size_t resamples = 200;  // of the bootstrap; its 5th least and largest bound 95 %

std::size_t groups_of(std::size_t runs) {
  constexpr std::size_t most = 50;
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::sqrt(static_cast<double>(runs))) / 2, 2, most);
}

/// Which group each run is in: as many runs in each, by the size of the quantity.
std::vector<std::size_t> groups(const std::vector<double>& quantity) {
  std::vector<std::size_t> order(quantity.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::size_t run) { return quantity[run]; });
  const std::size_t count = groups_of(quantity.size());
  std::vector<std::size_t> group(quantity.size());
  for (std::size_t place = 0; place < order.size(); ++place) {
    group[order[place]] = place * count / order.size();
  }
  // Values that are alike, as of a table's rows, are of one group.
  for (std::size_t place = 1; place < order.size(); ++place) {
    if (quantity[order[place]] == quantity[order[place - 1]]) {
      group[order[place]] = group[order[place - 1]];
    }
  }
  return group;
}

/// The variance between groups over all variance, less what chance alone puts between them.
double variance_share(const std::vector<std::size_t>& group, const std::vector<double>& result,
                      const std::vector<std::size_t>& runs) {
  struct Sum {
    double number = 0.0;
    double sum = 0.0;
  };
  std::vector<Sum> sums(groups_of(result.size()));
  double total = 0.0;
  double squares = 0.0;
  for (const std::size_t run : runs) {
    sums[group[run]].number += 1.0;
    sums[group[run]].sum += result[run];
    total += result[run];
    squares += result[run] * result[run];
  }
  const auto count = static_cast<double>(runs.size());
  const double all = squares - total * total / count;
  double between = -total * total / count;
  double used = 0.0;
  for (const Sum& sum : sums) {
    if (sum.number > 0.0) {
      between += sum.sum * sum.sum / sum.number;
      used += 1.0;
    }
  }
  const double within = (all - between) / (count - used);
  return all > 0.0 ? (between - (used - 1.0) * within) / all : 0.0;
}

Estimate variance_share(const std::vector<double>& quantity, const std::vector<double>& centred_result,
                        std::uint64_t seed, std::size_t number) {
  const std::vector<std::size_t> group = groups(quantity);
  std::vector<std::size_t> runs(quantity.size());
  std::iota(runs.begin(), runs.end(), 0U);
  Estimate share{.value = variance_share(group, centred_result, runs)};
  sim::Random random{seed, number};
  std::vector<double> again(resamples);
  for (double& value : again) {
    for (std::size_t& run : runs) {
      run = static_cast<std::size_t>(random.uniform() * static_cast<double>(runs.size()));
    }
    value = variance_share(group, centred_result, runs);
  }
  // A run that is drawn twice is in its group twice, which looks like variance between groups: what the bootstrap adds
  // in the mean is taken off.
  std::ranges::sort(again);
  const double excess = std::accumulate(again.begin(), again.end(), 0.0) / resamples - share.value;
  constexpr std::size_t tail = resamples / 40;
  share.low = again[tail] - excess;
  share.high = again[resamples - 1 - tail] - excess;
  return share;
}

}  // namespace

Sensitivity sensitivity(const std::vector<std::vector<double>>& quantities, const std::vector<double>& result,
                        std::uint64_t seed) {
  const auto runs = static_cast<Eigen::Index>(result.size());
  const auto count = static_cast<Eigen::Index>(quantities.size());
  const auto standardised = [runs](const std::vector<double>& values) -> Eigen::VectorXd {
    const Eigen::Map<const Eigen::VectorXd> all{values.data(), runs};
    const Eigen::VectorXd centred = all.array() - all.mean();
    return centred / std::sqrt(centred.squaredNorm() / static_cast<double>(runs - 1));
  };
  Eigen::MatrixXd x{runs, count};
  for (Eigen::Index i = 0; i < count; ++i) {
    x.col(i) = standardised(quantities[static_cast<std::size_t>(i)]);
  }
  const Eigen::VectorXd y = standardised(result);
  const linear::Factors normal_equations{linear::gram(x)};
  constexpr double least_condition = 1e-9;
  const bool independent = normal_equations.reciprocal_condition() > least_condition;
  const Eigen::MatrixXd inverse = normal_equations.inverse();
  const Eigen::VectorXd slopes = linear::least_squares(x, y);
  const auto freedom = static_cast<double>(runs - count - 1);
  const double residual = (y - x * slopes).squaredNorm() / freedom;
  Sensitivity all{.of_quantity = {}, .explained = 1.0 - residual};
  const std::vector<double> centred{y.data(), y.data() + runs};
  for (Eigen::Index i = 0; i < count; ++i) {
    const double reach = normal_975 * std::sqrt(residual * inverse(i, i));
    const auto number = static_cast<std::size_t>(i);
    const Estimate slope{.value = slopes[i], .low = slopes[i] - reach, .high = slopes[i] + reach};
    all.of_quantity.push_back({.slope = independent ? std::optional{slope} : std::nullopt,
                               .variance_share = variance_share(quantities[number], centred, seed, number)});
  }
  return all;
}

}  // namespace fantail::campaign
