// SPDX-License-Identifier: MIT
#include "identify/closed_loop_grid.hpp"

#include <algorithm>
#include <limits>

#include "identify/closed_loop_column.hpp"
#include "identify/closed_loop_start.hpp"

namespace fantail::identify {
namespace {

// So many of the best cells get a second look.
constexpr std::size_t second_looks = 8;

class Search {
 public:
  Search(const Record& record, const Airframe& airframe, const ClosedLoop& loop, const NodeTimes& node_time_s,
         Start start, const Grid& grid)
      : alpha_m2_{grid.alpha_m2.values()},
        beta_m_{grid.beta_m.values()},
        course_{closed_loop_course(record, airframe, loop, node_time_s)},
        guess_{record, airframe, node_time_s, start},
        column_{course_, start} {
    for (std::size_t j = 0; j < beta_m_.size(); ++j) {
      for (std::size_t i = 0; i < alpha_m2_.size(); ++i) {
        cells_.push_back({.beta_m = beta_m_[j], .place = {}});
      }
    }
  }

  /// From alpha to alpha; two solutions point to where the next one begins.
  void sweep() {
    std::vector<Attempt> attempts(beta_m_.size());
    for (std::size_t i = 0; i < alpha_m2_.size(); ++i) {
      for (std::size_t j = 0; j < beta_m_.size(); ++j) {
        attempts[j].beta_m = beta_m_[j];
        if (i == 0 || !cell(i - 1, j).place.allFinite()) {
          attempts[j].place = guess_.at(alpha_m2_[i], beta_m_[j]);
        } else if (i == 1) {
          attempts[j].place = cell(i - 1, j).place;
        } else {
          attempts[j].place = 2.0 * cell(i - 1, j).place - cell(i - 2, j).place;
        }
      }
      column_.solve(alpha_m2_[i], attempts);
      for (std::size_t j = 0; j < beta_m_.size(); ++j) {
        cell(i, j) = attempts[j];
      }
    }
  }

  /// A cell can have several hollows, and the way through the alphas may have led into the wrong one. Where it matters
  /// for who wins, the others are tried too: from the open loop's nodes, and from those of the cells around.
  void look_again() {
    std::vector<bool> seen(cells_.size(), false);
    std::vector<std::size_t> order(cells_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    const std::size_t count = std::min(second_looks, order.size());
    const auto best = order.begin() + static_cast<std::ptrdiff_t>(count);
    for (std::size_t looks = 0; looks < 2 * count; ++looks) {
      std::ranges::partial_sort(order, best, {}, [this](std::size_t i) { return cells_[i].mean_abs_error_rad; });
      const auto next = std::find_if(order.begin(), best, [&seen](std::size_t i) { return !seen[i]; });
      if (next == best) {
        return;
      }
      seen[*next] = true;
      look_at(*next % alpha_m2_.size(), *next / alpha_m2_.size());
    }
  }

  [[nodiscard]] const std::vector<Attempt>& cells() const { return cells_; }
  [[nodiscard]] double alpha_m2(std::size_t cell) const { return alpha_m2_[cell % alpha_m2_.size()]; }
  [[nodiscard]] ErrorMap errors() const {
    ErrorMap map{.alpha_m2 = alpha_m2_, .beta_m = beta_m_, .mean_abs_angle_error_rad = {}};
    for (const Attempt& attempt : cells_) {
      map.mean_abs_angle_error_rad.push_back(attempt.mean_abs_error_rad);
    }
    return map;
  }

 private:
  Attempt& cell(std::size_t i, std::size_t j) { return cells_[j * alpha_m2_.size() + i]; }

  void look_at(std::size_t i, std::size_t j) {
    Attempt& here = cell(i, j);
    std::vector<Attempt> attempts;
    const auto try_from = [&](const Eigen::VectorXd& place) {
      attempts.push_back({.beta_m = here.beta_m, .place = place});
    };
    if (i > 0) {
      try_from(cell(i - 1, j).place);
    }
    if (i + 1 < alpha_m2_.size()) {
      try_from(cell(i + 1, j).place);
    }
    if (j > 0) {
      try_from(cell(i, j - 1).place);
    }
    if (j + 1 < beta_m_.size()) {
      try_from(cell(i, j + 1).place);
    }
    column_.solve(alpha_m2_[i], attempts);
    for (const Attempt& attempt : attempts) {
      if (attempt.squares_rad2 < here.squares_rad2) {
        here = attempt;
      }
    }
  }

  std::vector<double> alpha_m2_;
  std::vector<double> beta_m_;
  Course course_;
  FirstGuess guess_;
  ClosedLoopColumn column_;
  std::vector<Attempt> cells_{};  ///< [j * alpha_m2_.size() + i]
};

}  // namespace

ClosedLoopGrid search_closed_loop_grid(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                                       const NodeTimes& node_time_s, Start start, const Grid& grid) {
  Search search{record, airframe, loop, node_time_s, start, grid};
  search.sweep();
  search.look_again();
  const auto least = [&](double Attempt::* value) {
    const auto found = std::ranges::min_element(search.cells(), {}, value);
    const auto at = static_cast<std::size_t>(found - search.cells().begin());
    return model_of(record, node_time_s, start, search.alpha_m2(at), found->beta_m, found->place);
  };
  return {.model = least(&Attempt::mean_abs_error_rad),
          .least_squares = least(&Attempt::squares_rad2),
          .errors = search.errors()};
}

}  // namespace fantail::identify
