// SPDX-License-Identifier: MIT
#include "identify/model/least_squares.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "identify/model/lanes.hpp"

namespace fantail::identify::model {
namespace {

// Rows that are zero from the top on, or a few less.
Eigen::Index leading_zeros(const Eigen::Ref<const Eigen::VectorXd>& column) {
  constexpr Eigen::Index together = 8;
  Eigen::Index zeros = 0;
  while (zeros + together <= column.size() && (column.segment<together>(zeros).array() == 0.0).all()) {
    zeros += together;
  }
  return zeros;
}

FANTAIL_AS_WIDE_AS_THE_PROCESSOR
double inner_product(const double* a, const double* b, std::size_t rows) {
  // Several sums, since each addition waits for the one before it.
  Four first{};
  Four second{};
  Four third{};
  Four fourth{};
  std::size_t i = 0;
  for (; i + 4 * lanes <= rows; i += 4 * lanes) {
    first += four_at(&a[i]) * four_at(&b[i]);
    second += four_at(&a[i + lanes]) * four_at(&b[i + lanes]);
    third += four_at(&a[i + 2 * lanes]) * four_at(&b[i + 2 * lanes]);
    fourth += four_at(&a[i + 3 * lanes]) * four_at(&b[i + 3 * lanes]);
  }
  double all = sum((first + second) + (third + fourth));
  for (; i < rows; ++i) {
    all += a[i] * b[i];
  }
  return all;
}

// column -= factor * direction
FANTAIL_AS_WIDE_AS_THE_PROCESSOR
void subtract(double* __restrict column, double factor, const double* __restrict direction, std::size_t rows) {
  for (std::size_t i = 0; i < rows; ++i) {
    column[i] -= factor * direction[i];
  }
}

constexpr double most_damping = 1e12;

struct Point {
  double x;
  double value;
};

// Brent's method (Algorithms for Minimization without Derivatives, 1973, chapter 5): the vertex of a parabola through
// the three best points where that makes headway, else a golden section. `best` lies within the span.
Point brent(const std::function<double(double)>& function, Span span, Point best, double relative_tolerance) {
  constexpr double golden = 0.3819660112501051;
  constexpr int most_steps = 60;
  const double tolerance = relative_tolerance * (span.high - span.low);
  Point second = best;
  Point third = best;
  double step = 0.0;
  double step_before_last = 0.0;
  for (int i = 0; i < most_steps; ++i) {
    const double middle = 0.5 * (span.low + span.high);
    if (std::abs(best.x - middle) <= 2.0 * tolerance - 0.5 * (span.high - span.low)) {
      break;
    }
    const double a = (best.x - second.x) * (best.value - third.value);
    const double b = (best.x - third.x) * (best.value - second.value);
    double upper = (best.x - third.x) * b - (best.x - second.x) * a;
    double lower = 2.0 * (b - a);
    upper = lower > 0.0 ? -upper : upper;
    lower = std::abs(lower);
    const bool parabola = std::abs(step_before_last) > tolerance &&
                          std::abs(upper) < std::abs(0.5 * lower * step_before_last) &&
                          upper > lower * (span.low - best.x) && upper < lower * (span.high - best.x);
    if (parabola) {
      step_before_last = std::exchange(step, upper / lower);
      const double x = best.x + step;
      if (x - span.low < 2.0 * tolerance || span.high - x < 2.0 * tolerance) {
        step = best.x < middle ? tolerance : -tolerance;
      }
    } else {
      step_before_last = (best.x < middle ? span.high : span.low) - best.x;
      step = golden * step_before_last;
    }
    const double x = best.x + (std::abs(step) >= tolerance ? step : std::copysign(tolerance, step));
    const Point tried{.x = x, .value = function(x)};
    if (tried.value <= best.value) {
      (tried.x < best.x ? span.high : span.low) = best.x;
      third = second;
      second = best;
      best = tried;
    } else {
      (tried.x < best.x ? span.low : span.high) = tried.x;
      if (tried.value <= second.value || second.x == best.x) {
        third = second;
        second = tried;
      } else if (tried.value <= third.value || third.x == best.x || third.x == second.x) {
        third = tried;
      }
    }
  }
  return best;
}

}  // namespace

OrthogonalFit::OrthogonalFit(Eigen::Ref<Eigen::MatrixXd> columns, Eigen::Index explaining)
    : explaining_{explaining},
      parts_{Eigen::MatrixXd::Zero(explaining, columns.cols())},
      squared_(explaining),
      left_out_(static_cast<std::size_t>(explaining), false) {
  constexpr double explained_already = 1e-10;
  for (Eigen::Index k = explaining - 1; k >= 0; --k) {
    const Eigen::Index zeros = leading_zeros(columns.col(k));
    const auto rows = static_cast<std::size_t>(columns.rows() - zeros);
    const auto lower = [&](Eigen::Index column) { return &columns.coeffRef(zeros, column); };
    squared_(k) = inner_product(lower(k), lower(k), rows);
    double before = squared_(k);
    for (Eigen::Index i = k + 1; i < explaining; ++i) {
      before += parts_(i, k) * parts_(i, k) * squared_(i);
    }
    if (squared_(k) <= explained_already * explained_already * before) {
      left_out_[static_cast<std::size_t>(k)] = true;
      columns.col(k).setZero();
      continue;
    }
    for (Eigen::Index j = 0; j < columns.cols(); ++j) {
      if (j < k || j >= explaining) {
        parts_(k, j) = inner_product(lower(k), lower(j), rows) / squared_(k);
        subtract(lower(j), parts_(k, j), lower(k), rows);
      }
    }
  }
}

double OrthogonalFit::length_before(const Eigen::Ref<const Eigen::VectorXd>& rest, Eigen::Index side) const {
  return std::sqrt(rest.squaredNorm() + parts_.col(explaining_ + side).cwiseAbs2().dot(squared_));
}

Eigen::VectorXd OrthogonalFit::coefficients(Eigen::Index side) const {
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(explaining_);
  for (Eigen::Index k = 0; k < explaining_; ++k) {
    if (!left_out_[static_cast<std::size_t>(k)]) {
      solution(k) = parts_(k, explaining_ + side) - parts_.row(k).head(k).dot(solution.head(k));
    }
  }
  return solution;
}

void LevenbergMarquardt::restart(const Eigen::VectorXd& start) {
  damping_ = rules_.first_damping;
  squares_ = std::numeric_limits<double>::infinity();
  promised_gain_ = std::numeric_limits<double>::infinity();
  trials_ = 0;
  finished_ = false;
  best_ = start;
  trial_ = start;
}

void LevenbergMarquardt::tell(const NormalEquations& at_trial) {
  ++trials_;
  if (at_trial.squares < squares_) {
    const double won = squares_ - at_trial.squares;
    if (won > 0.75 * promised_gain_) {
      damping_ *= 0.1;
    } else if (won < 0.25 * promised_gain_) {
      damping_ = std::max(3.0 * damping_, 1e-4);
    }
    best_ = trial_;
    squares_ = at_trial.squares;
    normal_ = at_trial.normal;
    gradient_ = at_trial.gradient;
  } else {
    damping_ = std::max(8.0 * damping_, 1e-4);
  }
  finished_ = finished_ || trials_ >= rules_.most_trials || !std::isfinite(squares_) || damping_ > most_damping;
  if (!finished_) {
    take_step();
    finished_ = promised_gain_ <= std::max(rules_.relative_gain * squares_, rules_.absolute_gain);
  }
}

void LevenbergMarquardt::take_step() {
  // An unknown that nothing depends on stays where it is.
  const double largest = normal_.diagonal().maxCoeff();
  const double floor = largest > 0.0 ? 1e-14 * largest : 1.0;
  step_ = -gradient_;
  do {
    damped_ = normal_;
    damped_.diagonal() += damping_ * normal_.diagonal();
    damped_.diagonal().array() += floor;
  } while (!solve() && (damping_ = std::max(10.0 * damping_, 1e-9)) < most_damping);
  // (N + D) s = -g: what the sum would lose if the residuals were linear.
  promised_gain_ = -(2.0 * gradient_.dot(step_) + step_.dot(normal_ * step_));
  trial_ = best_ + step_;
}

// Works in the memory of `damped_` and `step_`.
bool LevenbergMarquardt::solve() {
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factors{damped_};
  if (factors.info() != Eigen::Success) {
    return false;
  }
  factors.solveInPlace(step_);
  return true;
}

double least_over(const std::function<double(double)>& function, Span span, int places, double tolerance) {
  std::vector<Point> looked;
  for (int i = 0; i < places; ++i) {
    const double x = span.low + (span.high - span.low) * static_cast<double>(i) / static_cast<double>(places - 1);
    looked.push_back({.x = x, .value = function(x)});
  }
  const auto best = std::ranges::min_element(looked, {}, &Point::value);
  const double low = best == looked.begin() ? best->x : (best - 1)->x;
  const double high = best + 1 == looked.end() ? best->x : (best + 1)->x;
  return brent(function, {.low = low, .high = high}, *best, tolerance).x;
}

}  // namespace fantail::identify::model
