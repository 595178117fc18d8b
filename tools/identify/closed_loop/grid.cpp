// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "identify/closed_loop/closed_loop.hpp"

namespace fantail::identify::closed_loop {
namespace {

using namespace model;

// Nodes (and initial states) for one alpha and beta: where to begin, then where least squares are.
struct Attempt {
  double beta_m;
  Eigen::VectorXd place;
  double squares_rad2 = 0.0;
  double mean_abs_error_rad = 0.0;
};

// Solves many attempts of one alpha, some of them side by side.
class Column {
 public:
  Column(const Course& course, Start start)
      : rules_{.first_damping = 1e-9,  // attempts begin near their end
               .relative_gain = 1e-9,
               .absolute_gain = static_cast<double>(course.record->size()) * single_precision_rad2,
               .most_trials = 40},
        trials_{course, {.initial = start == Start::fitted, .model = false}} {}

  void solve(double alpha_m2, std::vector<Attempt>& attempts) {
    plant_.set_alpha(trials_.course(), alpha_m2, Slopes::none);
    while (searches_.size() < attempts.size()) {
      searches_.emplace_back(attempts.front().place, rules_);
    }
    improve(attempts);
    judge(attempts);
  }

 private:
  static constexpr std::size_t lanes = 4;

  // A step that promises less than this share of the sum of squares is the last: it changes the mean error by so little
  // that derivatives at its end, which cost as much as the flight, tell nothing of interest.
  static constexpr double last_step = 1e-3;

  void improve(std::vector<Attempt>& attempts) {
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      searches_[i].restart(attempts[i].place);
    }
    wait_for_all(attempts.size());
    while (!waiting_.empty()) {
      fly_waiting(
          attempts, [this] { trials_.fly_with_derivatives(plant_); },
          [this](std::size_t i) -> const Eigen::VectorXd& { return searches_[i].trial(); },
          [this](std::size_t i, std::size_t lane) {
            searches_[i].tell(trials_.equations(lane));
            return !searches_[i].finished() && searches_[i].promised_gain() > last_step * searches_[i].squares();
          });
    }
  }

  // Where the last step was one too far, the place before it counts.
  void judge(std::vector<Attempt>& attempts) {
    for (std::size_t i = 0; i < attempts.size(); ++i) {
      attempts[i].place = searches_[i].trial();
    }
    wait_for_all(attempts.size());
    while (!waiting_.empty()) {
      fly_waiting(
          attempts, [this] { trials_.fly(plant_); },
          [&](std::size_t i) -> const Eigen::VectorXd& { return attempts[i].place; },
          [&](std::size_t i, std::size_t lane) {
            Attempt& attempt = attempts[i];
            attempt.squares_rad2 = trials_.errors().squares(lane);
            attempt.mean_abs_error_rad = trials_.errors().mean_absolute(lane);
            const Eigen::VectorXd& before = searches_[i].best();
            const bool too_far = !(attempt.squares_rad2 <= searches_[i].squares()) && attempt.place != before;
            if (too_far) {
              attempt.place = before;
            }
            return too_far;
          });
    }
  }

  void wait_for_all(std::size_t count) {
    waiting_.resize(count);
    std::iota(waiting_.begin(), waiting_.end(), std::size_t{0});
  }

  // One flight for each that waits; those of which `told` says so wait for another.
  template <class Fly, class Where, class Told>
  void fly_waiting(const std::vector<Attempt>& attempts, const Fly& fly, const Where& where, const Told& told) {
    still_waiting_.clear();
    for (std::size_t first = 0; first < waiting_.size(); first += lanes) {
      const std::size_t count = std::min(lanes, waiting_.size() - first);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        // Lanes that are left over fly the last one again.
        const std::size_t i = waiting_[first + std::min(lane, count - 1)];
        trials_.set(lane, attempts[i].beta_m, where(i));
      }
      fly();
      for (std::size_t lane = 0; lane < count; ++lane) {
        if (told(waiting_[first + lane], lane)) {
          still_waiting_.push_back(waiting_[first + lane]);
        }
      }
    }
    std::swap(waiting_, still_waiting_);
  }

  LevenbergMarquardt::Rules rules_;
  LaneTrials<lanes> trials_;
  Plant plant_{};
  std::vector<LevenbergMarquardt> searches_{};  // one for each attempt; kept for their memory
  std::vector<std::size_t> waiting_{};
  std::vector<std::size_t> still_waiting_{};
};

// So many of the best cells get a second look.
constexpr std::size_t second_looks = 8;

class Search {
 public:
  Search(const Record& record, const Airframe& airframe, const Control& control, const NodeTimes& node_time_s,
         Start start, const Grid& grid)
      : alpha_m2_{grid.alpha_m2.values()},
        beta_m_{grid.beta_m.values()},
        course_{make_course(record, airframe, control, node_time_s)},
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
    std::iota(order.begin(), order.end(), std::size_t{0});
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
  Column column_;
  std::vector<Attempt> cells_{};  ///< [j * alpha_m2_.size() + i]
};

}  // namespace

GridResult search_grid(const Record& record, const Airframe& airframe, const Control& control,
                       const NodeTimes& node_time_s, Start start, const Grid& grid) {
  Search search{record, airframe, control, node_time_s, start, grid};
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

}  // namespace fantail::identify::closed_loop
