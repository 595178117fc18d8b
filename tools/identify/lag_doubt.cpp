// SPDX-License-Identifier: MIT
#include "identify/lag_doubt.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "identify/model/alpha_fit.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/result/uncertainty.hpp"
#include "identify/study.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::identify {

using namespace model;
using namespace result;

namespace {

std::vector<double> canard_rate_rad_s(const Record& record) {
  std::vector<double> rate(record.size(), 0.0);
  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const std::size_t first = record.segment_begin[s];
    const std::size_t last = (s + 1 < record.segment_begin.size() ? record.segment_begin[s + 1] : record.size()) - 1;
    for (std::size_t i = first; i <= last; ++i) {
      const std::size_t before = std::max(i, first + 1) - 1;
      const std::size_t after = std::min(i + 1, last);
      rate[i] = (record.canard_rad[after] - record.canard_rad[before]) / (record.time_s[after] - record.time_s[before]);
    }
  }
  return rate;
}

// What the canards did so much later; beyond either end of a segment, what they did there.
std::vector<double> canards_later(const Record& record, double lag_s) {
  std::vector<double> later(record.size());
  for (std::size_t s = 0; s < record.segment_begin.size(); ++s) {
    const auto first = static_cast<std::ptrdiff_t>(record.segment_begin[s]);
    const auto end =
        static_cast<std::ptrdiff_t>(s + 1 < record.segment_begin.size() ? record.segment_begin[s + 1] : record.size());
    for (std::ptrdiff_t i = first; i < end; ++i) {
      const double time_s = record.time_s[static_cast<std::size_t>(i)] + lag_s;
      const auto after = std::lower_bound(record.time_s.begin() + first, record.time_s.begin() + end, time_s);
      const auto right = static_cast<std::size_t>(std::clamp(after - record.time_s.begin(), first + 1, end - 1));
      const double share =
          std::clamp((time_s - record.time_s[right - 1]) / (record.time_s[right] - record.time_s[right - 1]), 0.0, 1.0);
      later[static_cast<std::size_t>(i)] =
          record.canard_rad[right - 1] + share * (record.canard_rad[right] - record.canard_rad[right - 1]);
    }
  }
  return later;
}

struct Shifted {
  double lag_s;
  RollModel model;
  double rate_error_rad_s;
};

Shifted shifted(const DoubtCase& c, double lag_s) {
  Record record = c.record;
  record.canard_rad = canards_later(c.record, lag_s);
  RollModel model = fit_open_loop(record, c.airframe, c.found.model.node_time_s, c.start, published_grid(c.airframe));
  const double error_rad_s = simulate_open_loop(record, c.airframe, model).mean_abs_rate_error_rad_s;
  return {.lag_s = lag_s, .model = std::move(model), .rate_error_rad_s = error_rad_s};
}

}  // namespace

bool matters(const DoubtCase& c, const RollModel& other) {
  constexpr double needless = 1e-3;
  const Uncertainty& u = *c.found.uncertainty;
  const auto differs = [&](double now, double before, double deviation) {
    return std::abs(now - before) > std::max(deviation, needless * std::abs(before));
  };
  return differs(other.alpha_m2, c.found.model.alpha_m2, u.standard_deviation[0]) ||
         differs(other.beta_m, c.found.model.beta_m, u.standard_deviation[1]);
}

std::string change(const RollModel& from, const RollModel& to) {
  return fmt::format("alpha {} m2 instead of {}, beta {} m instead of {}", text::brief(to.alpha_m2, 2),
                     text::brief(from.alpha_m2, 2), text::brief(to.beta_m, 2), text::brief(from.beta_m, 2));
}

std::optional<std::string> long_lag_doubt(const DoubtCase& c) {
  constexpr double step_s = 0.01;
  constexpr int farthest = 20;
  constexpr double clearly_better = 0.5;
  std::optional<Shifted> best;
  for (int i = -farthest; i <= farthest; ++i) {
    Shifted tried = shifted(c, step_s * i);
    best = !best || tried.rate_error_rad_s < best->rate_error_rad_s ? std::move(tried) : std::move(best);
  }
  const double before_rad_s = c.found.simulation.mean_abs_rate_error_rad_s;
  if (std::abs(best->lag_s) <= largest_fitted_lag_s || best->rate_error_rad_s > clearly_better * before_rad_s) {
    return {};
  }
  const double lag_s = best->lag_s;
  const double error_rad_s = best->rate_error_rad_s;
  const RollModel& model = best->model;
  return fmt::format(
      "The canard column seems to be about {} ms {}, more than --fit-lag looks for: moved by that, the mean error of "
      "the "
      "roll rate falls from {} to {} deg/s, and the fit gives {}. Check the clock of that column, or use --lag {}.",
      text::brief(1000.0 * std::abs(lag_s), 0), lag_s > 0.0 ? "late" : "early",
      text::brief(text::degrees(before_rad_s), 2), text::brief(text::degrees(error_rad_s), 2),
      change(c.found.model, model), text::brief(lag_s, 3));
}

std::optional<std::string> lag_doubt(const DoubtCase& c) {
  Record other = c.record;
  other.canard_rate_rad_s = canard_rate_rad_s(c.record);
  const RollModel& found = c.found.model;
  const RollModel model = fit_open_loop(other, c.airframe, found.node_time_s, c.start, published_grid(c.airframe));
  const ResponseBasis basis{other, c.airframe, found.node_time_s, c.start};
  const double lag_s = AlphaFit{basis, model.alpha_m2}.further_lag_s(model.beta_m);
  if (std::abs(lag_s) > largest_fitted_lag_s) {
    return long_lag_doubt(c);
  }
  for (std::size_t i = 0; i < other.size(); ++i) {
    other.canard_rad[i] += lag_s * other.canard_rate_rad_s[i];
  }
  const Uncertainty known =
      open_loop_uncertainty(other, c.airframe, model, simulate_open_loop(other, c.airframe, model), c.start);
  if (!matters(c, model) || std::abs(lag_s) < one_of_hundred * known.lag_s->reach) {
    return {};
  }
  return fmt::format(
      "The canard column seems to be about {} ms {} (95 %: {} to {} ms). With that lag the fit gives {}. Use "
      "--fit-lag, or --lag if it is known.",
      text::brief(1000.0 * std::abs(lag_s), 1), lag_s > 0.0 ? "late" : "early",
      text::brief(1000.0 * (std::abs(lag_s) - known.lag_s->reach), 1),
      text::brief(1000.0 * (std::abs(lag_s) + known.lag_s->reach), 1), change(found, model));
}

}  // namespace fantail::identify
