// SPDX-License-Identifier: MIT
#include "campaign/confidence_sequence.hpp"

#include <cmath>

namespace fantail::campaign {
namespace {

constexpr double miss = 0.05;

/// Between a share that is in and one that is out.
template <typename IsIn>
double edge(double in, double out, IsIn is_in) {
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (in + out);
    (is_in(middle) ? in : out) = middle;
  }
  return in;
}

}  // namespace

Bounds confidence_sequence(std::uint64_t count, std::uint64_t of) {
  const auto yes = static_cast<double>(count);
  const auto no = static_cast<double>(of - count);
  // Logarithm of the mean likelihood over all shares.
  const double mixture = std::lgamma(yes + 1.0) + std::lgamma(no + 1.0) - std::lgamma(yes + no + 2.0);
  const auto is_in = [&](double share) {
    const double likelihood = (yes > 0.0 ? yes * std::log(share) : 0.0) + (no > 0.0 ? no * std::log1p(-share) : 0.0);
    return mixture - likelihood < -std::log(miss);
  };
  const double seen = of == 0 ? 0.5 : yes / (yes + no);
  return {.low = is_in(0.0) ? 0.0 : edge(seen, 0.0, is_in), .high = is_in(1.0) ? 1.0 : edge(seen, 1.0, is_in)};
}

}  // namespace fantail::campaign
