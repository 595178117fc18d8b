// SPDX-License-Identifier: MIT
#include "identify/closed_loop_column.hpp"

#include <algorithm>
#include <utility>

namespace fantail::identify {

// A step that promises less than this share of the sum of squares is the last: it changes the mean error by so little
// that derivatives at its end, which cost as much as the flight, tell nothing of interest.
constexpr double last_step = 1e-3;

ClosedLoopColumn::ClosedLoopColumn(const Course& course, Start start)
    : rules_{.first_damping = 1e-9,  // attempts begin near their end
             .relative_gain = 1e-9,
             .absolute_gain = static_cast<double>(course.record->size()) * single_precision_rad2,
             .most_trials = 40},
      trials_{course, {.initial = start == Start::fitted, .model = false}} {}

void ClosedLoopColumn::solve(double alpha_m2, std::vector<Attempt>& attempts) {
  fill_transitions(trials_.course(), alpha_m2, Slopes::none, transitions_);
  while (searches_.size() < attempts.size()) {
    searches_.emplace_back(attempts.front().place, rules_);
  }
  improve(attempts);
  judge(attempts);
}

void ClosedLoopColumn::improve(std::vector<Attempt>& attempts) {
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    searches_[i].restart(attempts[i].place);
  }
  wait_for_all(attempts.size());
  while (!waiting_.empty()) {
    fly_waiting(
        attempts, [this] { trials_.fly_with_derivatives(transitions_); },
        [this](std::size_t i) -> const Eigen::VectorXd& { return searches_[i].trial(); },
        [this](std::size_t i, std::size_t lane) {
          searches_[i].tell(trials_.equations(lane));
          return !searches_[i].finished() && searches_[i].promised_gain() > last_step * searches_[i].squares();
        });
  }
}

// Where the last step was one too far, the place before it counts.
void ClosedLoopColumn::judge(std::vector<Attempt>& attempts) {
  for (std::size_t i = 0; i < attempts.size(); ++i) {
    attempts[i].place = searches_[i].trial();
  }
  wait_for_all(attempts.size());
  while (!waiting_.empty()) {
    fly_waiting(
        attempts, [this] { trials_.fly(transitions_); },
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

void ClosedLoopColumn::wait_for_all(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    waiting_.push_back(i);
  }
}

// One flight for each that waits; those of which `told` says so wait for another.
template <class Fly, class Where, class Told>
void ClosedLoopColumn::fly_waiting(const std::vector<Attempt>& attempts, const Fly& fly, const Where& where,
                                   const Told& told) {
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

}  // namespace fantail::identify
