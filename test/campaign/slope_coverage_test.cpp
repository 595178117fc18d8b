// SPDX-License-Identifier: MIT
// What is stated must be so: the true slope lies inside the stated interval in 95 % of the campaigns, give or take,
// whatever the figure is of the quantities: straight, curved, a step, heavy tails, without any influence.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "campaign/analysis.hpp"
#include "seed.hpp"
#include "sim/random.hpp"

namespace fantail::campaign {
namespace {

using std::numbers::pi;

/// What a run drew, and what came of it.
struct Drawn {
  std::vector<double> quantities{};
  double result = 0.0;
};

struct Case {
  std::string name;
  std::function<Drawn(sim::Random&)> draw;
  std::vector<double> slopes;  ///< the true ones, from the moments of what is drawn
};

double uniform(sim::Random& random) { return 2.0 * random.uniform() - 1.0; }

Case straight() {
  const double root = std::sqrt(26.0);
  return {"straight",
          [](sim::Random& r) -> Drawn {
            const double a = uniform(r);
            const double b = uniform(r);
            const double c = uniform(r);
            return {{a, b, c}, 3.0 * a - 4.0 * b + c};
          },
          {3.0 / root, -4.0 / root, 1.0 / root}};
}

Case with_useless() {
  return {"one without influence",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double useless = r.gaussian();
            return {{a, useless}, a + 0.5 * r.gaussian()};
          },
          {1.0 / std::sqrt(1.25), 0.0}};
}

// The same shape as Sobol's test of his indices: no line sees b, and what a does depends on c.
Case ishigami() {
  const double variance = 49.0 / 8.0 + 0.1 * std::pow(pi, 4) / 5.0 + 0.01 * std::pow(pi, 8) / 18.0 + 0.5;
  return {"Ishigami's function",
          [](sim::Random& r) -> Drawn {
            const double a = pi * uniform(r);
            const double b = pi * uniform(r);
            const double c = pi * uniform(r);
            return {{a, b, c}, std::sin(a) + 7.0 * std::sin(b) * std::sin(b) + 0.1 * std::pow(c, 4) * std::sin(a)};
          },
          {(1.0 + 0.1 * std::pow(pi, 4) / 5.0) / (pi / std::sqrt(3.0) * std::sqrt(variance)), 0.0, 0.0}};
}

Case product_of_normals() {
  return {"product of two normal numbers",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double b = r.gaussian();
            return {{a, b}, a * b};
          },
          {0.0, 0.0}};
}

Case product() {
  const double slope = 0.8 / std::sqrt(3.0) / std::sqrt(std::pow(1.0 + 0.64 / 3.0, 2) - 1.0);
  return {"product",
          [](sim::Random& r) -> Drawn {
            const double a = uniform(r);
            const double b = uniform(r);
            return {{a, b}, (1.0 + 0.8 * a) * (1.0 + 0.8 * b)};
          },
          {slope, slope}};
}

// Held or not: 1 where a + b / 2 is above 1/2.
Case threshold() {
  const double root = std::sqrt(1.25);
  const double at = 0.5 / root;
  const double share = 0.5 * std::erfc(at / std::numbers::sqrt2);
  const double slope = std::exp(-0.5 * at * at) / std::sqrt(2.0 * pi) / root / std::sqrt(share * (1.0 - share));
  return {"yes or no",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double b = r.gaussian();
            return {{a, b}, a + 0.5 * b > 0.5 ? 1.0 : 0.0};
          },
          {slope, 0.5 * slope}};
}

Case step() {
  const double root = std::sqrt(0.35 * 0.65 + 0.03);
  const double width = 1.0 / std::sqrt(3.0);
  return {"step",
          [](sim::Random& r) -> Drawn {
            const double a = uniform(r);
            const double b = uniform(r);
            return {{a, b}, (a > 0.3 ? 1.0 : 0.0) + 0.3 * b};
          },
          {0.91 / 4.0 / width / root, 0.3 * width / root}};
}

Case exponential() {
  const double root = std::sqrt(std::exp(0.34) - 1.0);
  return {"exponential",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double b = r.gaussian();
            return {{a, b}, std::exp(0.5 * a + 0.3 * b)};
          },
          {0.5 / root, 0.3 / root}};
}

// A U that no straight line shows, with tails that are heavier than a line's beside it.
Case square() {
  return {"square",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double b = r.gaussian();
            return {{a, b}, a * a + b};
          },
          {0.0, 1.0 / std::sqrt(3.0)}};
}

Case correlated() {
  return {"correlated, the second without influence of its own",
          [](sim::Random& r) -> Drawn {
            const double a = r.gaussian();
            const double b = 0.9 * a + std::sqrt(0.19) * r.gaussian();
            return {{a, b}, a + r.gaussian()};
          },
          {1.0 / std::numbers::sqrt2, 0.0}};
}

// One of eight rows, as from a tunnel.
Case rows() {
  const double variance = (25.0 + 9.0 + 1.0 + 0.0 + 0.0 + 1.0 + 9.0 + 25.0) / 8.0;
  const double root = std::sqrt(variance + 9.0);
  return {"rows of a table",
          [](sim::Random& r) -> Drawn {
            constexpr std::array<double, 8> table{15.0, 17.0, 19.0, 20.0, 20.0, 21.0, 23.0, 25.0};
            const double a = table[static_cast<std::size_t>(8.0 * r.uniform())];
            const double b = r.gaussian();
            return {{a, b}, a + 3.0 * b};
          },
          {std::sqrt(variance) / root, 3.0 / root}};
}

Case twenty() {
  return {"twenty quantities",
          [](sim::Random& r) -> Drawn {
            Drawn drawn;
            for (int i = 0; i < 20; ++i) {
              drawn.quantities.push_back(r.gaussian());
              drawn.result += (i == 0 ? 3.0 : 0.1) * drawn.quantities.back();
            }
            drawn.result += r.gaussian();
            return drawn;
          },
          {3.0 / std::sqrt(10.19), 0.1 / std::sqrt(10.19)}};
}

constexpr int campaigns = 1000;

/// How many of so many campaigns have an interval that holds the true slope, by quantity.
std::vector<int> inside(const Case& of, int run_count, std::uint32_t seed) {
  std::vector<int> count(of.slopes.size(), 0);
  for (int campaign = 0; campaign < campaigns; ++campaign) {
    sim::Random random{seed, static_cast<std::uint64_t>(campaign)};
    std::vector<std::vector<double>> quantities;
    std::vector<double> result;
    for (int run = 0; run < run_count; ++run) {
      const Drawn drawn = of.draw(random);
      quantities.resize(drawn.quantities.size());
      for (std::size_t i = 0; i < drawn.quantities.size(); ++i) {
        quantities[i].push_back(drawn.quantities[i]);
      }
      result.push_back(drawn.result);
    }
    const Sensitivity found = sensitivity(quantities, result);
    for (std::size_t i = 0; i < count.size(); ++i) {
      const Estimate slope = found.slopes[i].value();
      count[i] += slope.low <= of.slopes[i] && of.slopes[i] <= slope.high ? 1 : 0;
    }
  }
  return count;
}

class SlopeCoverage : public testing::TestWithParam<int> {};

// A count of 1000 varies by 7. The heavy tails of the square beside a line are the hardest: 92 % of 100 runs.
TEST_P(SlopeCoverage, NineteenOfTwentyIntervalsHoldTheTrueSlope) {
  const std::uint32_t seed = test::seed(1);
  for (const Case& of : {straight(), with_useless(), ishigami(), product_of_normals(), product(), threshold(), step(),
                         exponential(), square(), correlated(), rows(), twenty()}) {
    const int run_count = of.name == "twenty quantities" ? std::max(200, GetParam()) : GetParam();  // ten for each
    const std::vector<int> held = inside(of, run_count, seed);
    std::string row;
    for (std::size_t i = 0; i < held.size(); ++i) {
      row += fmt::format(" {:.1f} %", 100.0 * held[i] / campaigns);
      EXPECT_GE(held[i], of.name == "square" && GetParam() < 1000 ? 905 : 930) << of.name << ", quantity " << i + 1;
      EXPECT_LE(held[i], 985) << of.name << ", quantity " << i + 1;
    }
    fmt::print("{} runs, {}:{}\n", run_count, of.name, row);
  }
}

INSTANTIATE_TEST_SUITE_P(Runs, SlopeCoverage, testing::Values(100, 150, 1000),
                         [](const testing::TestParamInfo<int>& each) { return std::to_string(each.param); });

}  // namespace
}  // namespace fantail::campaign
