// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace fantail::sim {

// The C library picks another exp and log on a CPU with fused multiply-add, and promises no last bit. These are made
// of additions, multiplications and divisions only, so they give the same bytes on every machine, and in a constant
// expression. Both are right to within two units in the last place.

inline constexpr double ln2_high = 0x1.62e42fee00000p-1;  ///< ends in zeros: a product with a small integer is exact
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;

inline constexpr std::array<double, 14> inverse_factorials = [] {
  std::array<double, 14> result{1.0};
  double factorial = 1.0;
  for (std::size_t n = 1; n < result.size(); ++n) {
    factorial *= static_cast<double>(n);
    result[n] = 1.0 / factorial;
  }
  return result;
}();

/// e^x; 0 below -700, infinity above 700.
[[nodiscard]] constexpr double exponential(double x) {
  if (x < -700.0) {
    return 0.0;
  }
  if (x > 700.0) {
    return std::numeric_limits<double>::infinity();
  }
  const auto power = static_cast<std::int64_t>(x * (1.0 / (ln2_high + ln2_low)) + (x < 0.0 ? -0.5 : 0.5));
  const double r = (x - static_cast<double>(power) * ln2_high) - static_cast<double>(power) * ln2_low;
  // Taylor; below ln 2 / 2 the first term left out is under 1e-18. The even and the odd powers run beside each other.
  const double square = r * r;
  double even = 0.0;
  double odd = 0.0;
  for (std::size_t n = inverse_factorials.size() / 2; n-- > 0;) {
    even = even * square + inverse_factorials[2 * n];
    odd = odd * square + inverse_factorials[2 * n + 1];
  }
  const double sum = even + r * odd;
  return sum * std::bit_cast<double>(static_cast<std::uint64_t>(1023 + power) << 52U);
}

/// ln x for a normal x > 0.
[[nodiscard]] constexpr double natural_log(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto power = static_cast<std::int64_t>(bits >> 52U) - 1023;
  double mantissa = std::bit_cast<double>((bits & 0xfffffffffffffU) | 0x3ff0000000000000U);
  if (mantissa > 1.4142135623730951) {
    mantissa *= 0.5;
    ++power;
  }
  // ln m = 2 artanh((m - 1) / (m + 1)), and the argument is below 0.172.
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double square = s * s;
  double sum = 0.0;
  for (int n = 23; n > 1; n -= 2) {
    sum = (sum + 1.0 / static_cast<double>(n)) * square;
  }
  const auto p = static_cast<double>(power);
  return p * ln2_high + (p * ln2_low + 2.0 * s * (1.0 + sum));
}

/// What a first-order lag does in one interval of x = duration / lag > 0.
struct Settling {
  double gain;    ///< 1 - e^-x: the share of the distance to the goal that is covered
  double weight;  ///< (mean over the interval - start) / (end - start); 1/2 for a straight line
};

[[nodiscard]] constexpr Settling settling(double x) {
  if (x > 0.1) {
    const double gain = 1.0 - exponential(-x);
    return {.gain = gain, .weight = 1.0 / gain - 1.0 / x};
  }
  // The (4,4) Pade approximant: no cancellation, and one division, which matters because every servo pays for it at
  // every pulse frame.
  const double square = x * x;
  const double even = 1680.0 + square * (180.0 + square);
  const double odd = x * (840.0 + square * 20.0);
  return {.gain = 2.0 * odd / (even + odd),
          .weight = 0.5 + x * (1.0 / 12.0 - square * (1.0 / 720.0 - square * (1.0 / 30240.0)))};
}

}  // namespace fantail::sim
