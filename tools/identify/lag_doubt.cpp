// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "identify/doubts.hpp"
#include "identify/model/alpha_fit.hpp"
#include "identify/model/open_loop.hpp"
#include "identify/result/uncertainty.hpp"
#include "identify/result/words.hpp"
#include "identify/study.hpp"
#include "sim/compressibility.hpp"
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

Shifted fitted(const DoubtCase& c, const Record& record, const NodeTimes& nodes, double lag_s) {
  RollModel model = fit_open_loop(record, c.airframe, nodes, c.start, published_grid(c.airframe));
  const double error_rad_s = simulate_open_loop(record, c.airframe, model).mean_abs_rate_error_rad_s;
  return {.lag_s = lag_s, .model = std::move(model), .rate_error_rad_s = error_rad_s};
}

Shifted shifted(const DoubtCase& c, double lag_s) {
  Record record = c.record;
  record.canard_rad = canards_later(c.record, lag_s);
  return fitted(c, record, c.found.model.node_time_s, lag_s);
}

struct FittedLag {
  double lag_s;
  double reach_s;  ///< to either end of its 95 % interval
  RollModel model;
};

FittedLag fitted_lag(const Record& record, const DoubtCase& c, const NodeTimes& nodes) {
  Record other = record;
  other.canard_rate_rad_s = canard_rate_rad_s(record);
  RollModel model = fit_open_loop(other, c.airframe, nodes, c.start, published_grid(c.airframe));
  const ResponseBasis basis{other, c.airframe, nodes, c.start};
  const double lag_s = AlphaFit{basis, model.alpha_m2}.further_lag_s(model.beta_m);
  for (std::size_t i = 0; i < other.size(); ++i) {
    other.canard_rad[i] += lag_s * other.canard_rate_rad_s[i];
  }
  const Uncertainty known =
      open_loop_uncertainty(other, c.airframe, model, simulate_open_loop(other, c.airframe, model), c.start);
  return {.lag_s = lag_s, .reach_s = known.lag_s->reach, .model = std::move(model)};
}

std::string milliseconds(double time_s) { return text::brief(1000.0 * time_s, 1); }

std::string milliseconds_around(const FittedLag& lag) {
  const double size_s = std::abs(lag.lag_s);
  return fmt::format("{} to {} ms", milliseconds(size_s - lag.reach_s), milliseconds(size_s + lag.reach_s));
}

// Prandtl and Glauert's rule, as a larger density would do it. So near the ground, whatever the height.
Record with_growth(const Record& record) {
  constexpr double sound_m_s = 340.0;
  Record compressible = record;
  for (std::size_t i = 0; i < record.size(); ++i) {
    compressible.density_kg_m3[i] *=
        sim::compressibility_factor(sim::Compressibility::prandtl_glauert, record.speed_m_s[i] / sound_m_s);
  }
  return compressible;
}

enum class Half : std::uint8_t { first, second };

Record half_of(const Record& record, Half half) {
  const std::size_t middle = record.size() / 2;
  const std::size_t first = half == Half::first ? 0 : middle;
  const std::size_t end = half == Half::first ? middle : record.size();
  Record part;
  const auto take = [&](std::vector<double> Record::* column) {
    const std::vector<double>& all = record.*column;
    if (!all.empty()) {
      (part.*column)
          .assign(all.begin() + static_cast<std::ptrdiff_t>(first), all.begin() + static_cast<std::ptrdiff_t>(end));
    }
  };
  for (const auto column : {&Record::time_s, &Record::roll_angle_rad, &Record::roll_rate_rad_s, &Record::canard_rad,
                            &Record::speed_m_s, &Record::density_kg_m3, &Record::roll_inertia_kg_m2}) {
    take(column);
  }
  for (double& time_s : part.time_s) {
    time_s -= record.time_s[first];
  }
  for (const std::size_t begin : record.segment_begin) {
    if (begin > first && begin < end) {
      part.segment_begin.push_back(begin - first);
    }
  }
  return part;
}

// A lag of a column is the same whatever else the model has, and in every part of the window.
std::optional<std::string> lag_with_another_cause(const DoubtCase& c, const FittedLag& lag) {
  const auto left = [&lag](const FittedLag& other, const std::string& with) -> std::optional<std::string> {
    // Of one lag, estimates differ by the difference of their variances (Hausman 1978).
    const double beyond_s = std::sqrt(std::max(0.0, other.reach_s * other.reach_s - lag.reach_s * lag.reach_s));
    if (std::abs(other.lag_s - lag.lag_s) <= std::max(lag.reach_s, beyond_s)) {
      return {};
    }
    return fmt::format("{} that lag would be {} ms", with, milliseconds(std::copysign(1.0, lag.lag_s) * other.lag_s));
  };
  const NodeTimes& nodes = c.found.model.node_time_s;
  const NodeTimes more = twice_as_many(c.record, nodes);
  if (has_room_for(c.record, more)) {
    if (auto says = left(fitted_lag(c.record, c, more),
                         fmt::format("with {} nodes of the disturbance instead of {}", more.size(), nodes.size()))) {
      return says;
    }
    for (const auto& [half, name] : {std::pair{Half::first, "in the first half of the window"},
                                     std::pair{Half::second, "in the second half of the window"}}) {
      const Record part = half_of(c.record, half);
      if (auto says = left(fitted_lag(part, c, even_nodes(part, nodes.size() - 1)), name)) {
        return says;
      }
    }
  }
  if (c.record.grows_with_mach) {
    return {};
  }
  const Record compressible = with_growth(c.record);
  return left(fitted_lag(compressible, c, nodes), "with an alpha and beta that grow with the Mach number");
}

}  // namespace

NodeTimes twice_as_many(const Record& record, const NodeTimes& nodes) {
  if (nodes.size() == 1) {
    return even_nodes(record, 2);
  }
  NodeTimes all{nodes.front()};
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    all.push_back(0.5 * (nodes[k - 1] + nodes[k]));
    all.push_back(nodes[k]);
  }
  return all;
}

bool has_room_for(const Record& record, const NodeTimes& nodes) { return record.size() >= 20 * nodes.size(); }

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
  return fmt::format("alpha {}, beta {}", change_text(to.alpha_m2, from.alpha_m2, "m2"),
                     change_text(to.beta_m, from.beta_m, "m"));
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
  const NodeTimes more = twice_as_many(c.record, c.found.model.node_time_s);
  if (has_room_for(c.record, more) && fitted(c, c.record, more, 0.0).rate_error_rad_s < best->rate_error_rad_s) {
    return {};
  }
  const double lag_s = best->lag_s;
  const double error_rad_s = best->rate_error_rad_s;
  const RollModel& model = best->model;
  return fmt::format(
      "The canard column seems to be about {} ms {}, beyond the range of --fit-lag. With that shift the mean error "
      "of the roll rate falls from {} to {} deg/s, and the fit gives {}. Check the clock of that column, or use "
      "--lag {}.",
      text::brief(1000.0 * std::abs(lag_s), 0), lag_s > 0.0 ? "late" : "early",
      text::brief(text::degrees(before_rad_s), 2), text::brief(text::degrees(error_rad_s), 2),
      change(c.found.model, model), text::brief(lag_s, 3));
}

std::optional<std::string> lag_doubt(const DoubtCase& c) {
  const RollModel& found = c.found.model;
  const FittedLag lag = fitted_lag(c.record, c, found.node_time_s);
  if (std::abs(lag.lag_s) > largest_fitted_lag_s) {
    return long_lag_doubt(c);
  }
  if (!matters(c, lag.model) || std::abs(lag.lag_s) < one_of_hundred * lag.reach_s) {
    return {};
  }
  const std::string claim = fmt::format("about {} ms {} (95 %: {})", milliseconds(std::abs(lag.lag_s)),
                                        lag.lag_s > 0.0 ? "late" : "early", milliseconds_around(lag));
  if (const auto otherwise = lag_with_another_cause(c, lag)) {
    return fmt::format(
        "The canard column may be {}, or something else changes within the window: {}. The lag alone gives {}. Use "
        "--fit-lag only if more nodes (--nodes even:{}) and shorter windows show the same lag.",
        claim, *otherwise, change(found, lag.model), 2 * std::max<std::size_t>(1, found.node_time_s.size() - 1));
  }
  return fmt::format(
      "The canard column seems to be {}. With that lag the fit gives {}. If the clock or a filter of that column "
      "explains "
      "it, use --fit-lag, or --lag if it is known.",
      claim, change(found, lag.model));
}

}  // namespace fantail::identify
