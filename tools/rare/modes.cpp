// SPDX-License-Identifier: MIT
#include "rare/modes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "distributions/quantiles.hpp"
#include "rare/tails.hpp"
#include "sim/random.hpp"

namespace fantail::rare {
namespace {

constexpr std::size_t flights_for_modes = 200;
constexpr std::size_t fewest_of_mode = 5;  // the mean of fewer says little
constexpr std::uint64_t stream_of_laws = 5'000;

/// Mean and standard deviation of each drawn number, whatever its law.
struct Laws {
  std::vector<double> means{};
  std::vector<double> deviations{};

  explicit Laws(const Task& task) {
    constexpr int draws = 20'000;
    std::vector<double> squares;
    int drawn = 0;
    sim::Random random{task.options.campaign.seed, stream_of_laws};
    std::vector<double> normals(task.drawer.dimensions());
    for (int i = 0; i < draws; ++i) {
      std::ranges::generate(normals, [&] { return random.gaussian(); });
      const auto draw = task.drawer.draw_at(normals);
      if (!draw) {
        continue;
      }
      means.resize(draw->numbers.size());
      squares.resize(draw->numbers.size());
      drawn += 1;
      for (std::size_t k = 0; k < means.size(); ++k) {
        const double from_mean = draw->numbers[k] - means[k];
        means[k] += from_mean / drawn;
        squares[k] += from_mean * (draw->numbers[k] - means[k]);
      }
    }
    for (const double square : squares) {
      deviations.push_back(std::sqrt(square / std::max(drawn - 1, 1)));
    }
  }

  [[nodiscard]] std::vector<double> sigmas(const std::vector<double>& numbers) const {
    std::vector<double> all(numbers.size(), 0.0);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      all[k] = deviations[k] > 0.0 ? (numbers[k] - means[k]) / deviations[k] : 0.0;
    }
    return all;
  }
};

std::vector<Quantity> quantities_of(const Task& task, const std::vector<std::vector<double>>& sigmas) {
  std::vector<Quantity> all;
  for (std::string& name : campaign::quantity_names(task.spreads)) {
    const std::size_t k = all.size();
    const auto count = static_cast<double>(sigmas.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const std::vector<double>& one : sigmas) {
      sum += one[k];
      squares += one[k] * one[k];
    }
    const double mean = sum / count;
    all.push_back({.name = std::move(name),
                   .mean_sigmas = mean,
                   .deviation_sigmas = std::sqrt(std::max(0.0, squares / count - mean * mean))});
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, [](const Quantity& q) {
    return std::max(std::abs(q.mean_sigmas), q.far_sigmas() - 1.0);  // moved to one side, or to either
  });
  return all;
}

}  // namespace

std::vector<Mode> modes_of(const Task& task, const std::vector<Sample>& failing, const std::function<void()>& look) {
  const Laws laws{task};
  const std::size_t step = 1 + (failing.size() - 1) / flights_for_modes;
  std::map<std::string, std::vector<std::vector<double>>> by_criterion;
  double flown = 0.0;
  for (std::size_t i = 0; i < failing.size(); i += step) {
    look();
    const auto again = task.fly(failing[i].point);
    const auto& failed_by = again->run.failed_by;
    const bool is_of_figure = task.options.question.relation != campaign::Relation::is || failed_by.empty();
    by_criterion[is_of_figure ? task.options.question.text() : failed_by.front()].push_back(
        laws.sigmas(again->run.numbers));
    flown += 1.0;
  }
  std::vector<Mode> modes;
  for (const auto& [criterion, sigmas] : by_criterion) {
    modes.push_back(
        {.criterion = criterion,
         .share = static_cast<double>(sigmas.size()) / flown,
         .quantities = sigmas.size() < fewest_of_mode ? std::vector<Quantity>{} : quantities_of(task, sigmas)});
  }
  std::ranges::stable_sort(modes, std::ranges::greater{}, &Mode::share);
  return modes;
}

std::optional<double> heavier_tails(const Task& task, const Estimate& estimate) {
  std::vector<double> mean(task.drawer.dimensions(), 0.0);
  for (const Sample& sample : estimate.failing) {
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] += sample.point.normals[i] / static_cast<double>(estimate.failing.size());
    }
  }
  const double length = std::sqrt(std::inner_product(mean.begin(), mean.end(), mean.begin(), 0.0));
  const double reach = -distributions::normal_quantile(estimate.probability);
  // Where failures lie on all sides, or by chance alone, their mean is near the middle.
  if (length < 0.7 * reach) {
    return std::nullopt;
  }
  constexpr double plays_no_part = 1e-3;
  std::vector<Part> parts;
  bool is_cut = false;  // no tails beyond
  std::size_t dimension = 0;
  for (const campaign::Spread& spread : task.spreads) {
    for (std::size_t i = 0; i < spread.dimensions(); ++i, ++dimension) {
      const double factor = std::abs(mean[dimension]) / length;
      if (factor > plays_no_part) {
        parts.push_back({.factor = factor, .is_student = spread.law == campaign::Law::normal});
        is_cut = is_cut || spread.outside == campaign::Outside::truncate;
      }
    }
  }
  return !is_cut && std::ranges::any_of(parts, &Part::is_student) ? std::optional{tail_of_sum(parts, reach)}
                                                                  : std::nullopt;
}

}  // namespace fantail::rare
