// SPDX-License-Identifier: MIT
#include "rare/tails.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "distributions/quantiles.hpp"

namespace fantail::rare {
namespace {

/// Student's t with five degrees of freedom: how probable it is that such a number, with variance 1, is smaller.
double student_5(double number) {
  const double t = number * std::sqrt(5.0 / 3.0);
  const double share = 1.0 / (1.0 + t * t / 5.0);
  return 0.5 +
         (std::atan(t / std::sqrt(5.0)) + t / std::sqrt(5.0) * share * (1.0 + 2.0 / 3.0 * share)) / std::numbers::pi;
}

double normal(double number) { return distributions::normal_tail(-number); }

/// The density of a sum, in cells.
class Sum {
 public:
  void add(const Part& part) {
    const auto probability = part.is_student ? student_5 : normal;
    std::vector<double> one(cells);
    double below = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
      const double next = i + 1 == cells ? 1.0 : probability((place(i) + 0.5 * cell) / part.factor);
      one[i] = next - below;
      below = next;
    }
    std::vector<double> folded(cells);
    for (std::size_t i = 0; i < cells; ++i) {
      for (std::size_t k = 0; k < cells && one[i] > 0.0; ++k) {
        folded[std::clamp(i + k, middle, middle + cells - 1) - middle] += one[i] * all_[k];
      }
    }
    all_ = std::move(folded);
  }
  [[nodiscard]] double beyond(double reach) const {
    double sum = 0.0;
    for (std::size_t i = cells; i > 0 && place(i - 1) > reach; --i) {
      sum += all_[i - 1];
    }
    return sum;
  }

 private:
  static constexpr double cell = 0.02;
  static constexpr std::size_t middle = 1'000;
  static constexpr std::size_t cells = 2 * middle + 1;
  [[nodiscard]] static double place(std::size_t i) {
    return cell * (static_cast<double>(i) - static_cast<double>(middle));
  }

  std::vector<double> all_ = [] {
    std::vector<double> none(cells);
    none[middle] = 1.0;
    return none;
  }();
};

}  // namespace

double tail_of_sum(const std::vector<Part>& parts, double reach) {
  Sum sum;
  for (const Part& part : parts) {
    sum.add(part);
  }
  return sum.beyond(reach);
}

}  // namespace fantail::rare
