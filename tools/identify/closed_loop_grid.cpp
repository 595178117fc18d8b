// SPDX-License-Identifier: MIT
#include "identify/closed_loop_grid.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "identify/closed_loop_start.hpp"
#include "identify/closed_loop_trials.hpp"

namespace fantail::identify {
namespace {

constexpr std::size_t lanes = 4;

// A step that promises less than this share of the sum of squares is the last: it changes the mean error by so little
// that derivatives at its end, which cost as much as the flight, tell nothing of interest.
constexpr double last_step = 1e-3;

// One beta on its way through the alphas.
struct Cell {
  double beta_m;
  LevenbergMarquardt search;
  Eigen::VectorXd solution{};  // at this alpha; before it has been found, at the one before
  Eigen::VectorXd before{};    // at the alpha before
  double squares = 0.0;
  double mean_absolute = 0.0;
};

class Search {
 public:
  Search(const Record& record, const Airframe& airframe, const ClosedLoop& loop, const NodeTimes& node_time_s,
         Start start, const std::vector<double>& beta_m)
      : course_{closed_loop_course(record, airframe, loop, node_time_s)},
        first_guess_{record, airframe, node_time_s, start},
        trials_{course_, {.initial = start == Start::fitted, .model = false}} {
    const LevenbergMarquardt::Rules rules{.first_damping = 1e-9,
                                          .relative_gain = 1e-9,
                                          .absolute_gain = static_cast<double>(record.size()) * single_precision_rad2,
                                          .most_trials = 40};
    for (const double beta : beta_m) {
      cells_.push_back({.beta_m = beta, .search = LevenbergMarquardt{Eigen::VectorXd{}, rules}});
    }
  }

  /// All betas at one alpha; alphas must come in order, each near the one before.
  const std::vector<Cell>& solve(double alpha_m2) {
    fill_transitions(course_, alpha_m2, Slopes::none, transitions_);
    guess(alpha_m2);
    improve();
    judge();
    return cells_;
  }

 private:
  // The solutions at two alphas point to the next one.
  void guess(double alpha_m2) {
    for (Cell& cell : cells_) {
      if (cell.solution.size() == 0 || !cell.solution.allFinite()) {
        cell.solution = first_guess_.at(alpha_m2, cell.beta_m);
        cell.before = cell.solution;
      }
      guess_ = 2.0 * cell.solution - cell.before;
      cell.search.restart(guess_);
      std::swap(cell.before, cell.solution);
    }
  }

  void improve() {
    wait_for_all();
    while (!waiting_.empty()) {
      fly_waiting([this] { trials_.fly_with_derivatives(transitions_); },
                  [](const Cell& cell) { return &cell.search.trial(); },
                  [this](Cell& cell, std::size_t lane) {
                    cell.search.tell(trials_.equations(lane));
                    return !cell.search.finished() && cell.search.promised_gain() > last_step * cell.search.squares();
                  });
    }
  }

  // Where the last step was one too far, the place before it counts.
  void judge() {
    for (Cell& cell : cells_) {
      cell.solution = cell.search.trial();
    }
    wait_for_all();
    while (!waiting_.empty()) {
      fly_waiting([this] { trials_.fly(transitions_); }, [](const Cell& cell) { return &cell.solution; },
                  [this](Cell& cell, std::size_t lane) {
                    cell.squares = trials_.errors().squares(lane);
                    cell.mean_absolute = trials_.errors().mean_absolute(lane);
                    const bool too_far =
                        !(cell.squares <= cell.search.squares()) && cell.solution != cell.search.best();
                    if (too_far) {
                      cell.solution = cell.search.best();
                    }
                    return too_far;
                  });
    }
  }

  void wait_for_all() {
    for (std::size_t j = 0; j < cells_.size(); ++j) {
      waiting_.push_back(j);
    }
  }

  // A flight for each waiting cell, some side by side; those of which `told` says so wait for another.
  template <class Fly, class Where, class Told>
  void fly_waiting(const Fly& fly, const Where& where, const Told& told) {
    still_waiting_.clear();
    for (std::size_t first = 0; first < waiting_.size(); first += lanes) {
      const std::size_t count = std::min(lanes, waiting_.size() - first);
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        // Lanes that are left over fly with the last cell.
        const Cell& cell = cells_[waiting_[first + std::min(lane, count - 1)]];
        trials_.set(lane, cell.beta_m, *where(cell));
      }
      fly();
      for (std::size_t lane = 0; lane < count; ++lane) {
        if (told(cells_[waiting_[first + lane]], lane)) {
          still_waiting_.push_back(waiting_[first + lane]);
        }
      }
    }
    std::swap(waiting_, still_waiting_);
  }

  Course course_;
  FirstGuess first_guess_;
  LaneTrials<lanes> trials_;
  Transitions transitions_{};
  std::vector<Cell> cells_{};
  std::vector<std::size_t> waiting_{};
  std::vector<std::size_t> still_waiting_{};
  Eigen::VectorXd guess_{};
};

}  // namespace

ClosedLoopGrid search_closed_loop_grid(const Record& record, const Airframe& airframe, const ClosedLoop& loop,
                                       const NodeTimes& node_time_s, Start start, const Grid& grid) {
  const std::vector<double> alpha_m2 = grid.alpha_m2.values();
  const std::vector<double> beta_m = grid.beta_m.values();
  ClosedLoopGrid result;
  result.errors = {.alpha_m2 = alpha_m2, .beta_m = beta_m, .mean_abs_angle_error_rad = {}};
  result.errors.mean_abs_angle_error_rad.resize(alpha_m2.size() * beta_m.size());
  double least_absolute = std::numeric_limits<double>::infinity();
  double least_squares = std::numeric_limits<double>::infinity();
  Search search{record, airframe, loop, node_time_s, start, beta_m};
  for (std::size_t i = 0; i < alpha_m2.size(); ++i) {
    const std::vector<Cell>& cells = search.solve(alpha_m2[i]);
    for (std::size_t j = 0; j < cells.size(); ++j) {
      const Cell& cell = cells[j];
      const auto model = [&] { return model_of(record, node_time_s, start, alpha_m2[i], cell.beta_m, cell.solution); };
      result.errors.mean_abs_angle_error_rad[j * alpha_m2.size() + i] = cell.mean_absolute;
      if (cell.mean_absolute < least_absolute) {
        least_absolute = cell.mean_absolute;
        result.model = model();
      }
      if (cell.squares < least_squares) {
        least_squares = cell.squares;
        result.least_squares = model();
      }
    }
  }
  return result;
}

}  // namespace fantail::identify
