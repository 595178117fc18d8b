// SPDX-License-Identifier: MIT
#include "campaign/draw.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "distributions/quantiles.hpp"
#include "runs/runner.hpp"
#include "spread_files.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

constexpr std::uint64_t runs = 20'000;
const double five_deviations = 5.0 / std::sqrt(static_cast<double>(runs));  ///< of a mean, by those of one run

/// Of one number over all runs.
std::vector<double> all_of(const Drawer& drawer, std::size_t number) {
  std::vector<double> values;
  for (std::uint64_t run = 0; run < runs; ++run) {
    values.push_back(drawer.draw(run).numbers[number]);
  }
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

double product_moment(const std::vector<double>& a, const std::vector<double>& b) {
  const double mean_a = mean(a);
  const double mean_b = mean(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - mean_a) * (b[i] - mean_b);
  }
  return sum / static_cast<double>(a.size());
}

std::string one(const std::string& rest) { return "[[spread]]\nfield = \"body.mass_kg\"\n" + rest; }

// Within five standard deviations of both moments, for a fourth moment of at most that of the normal law.
TEST(Draws, HaveTheMomentsOfTheirLaw) {
  struct Case {
    std::string law;
    double mean;
    double variance;
  };
  for (const Case& each : {Case{"law = \"normal\"\nmean = 4\nstandard_deviation = 0.1\n", 4.0, 0.01},
                           Case{"law = \"uniform\"\nlow = 3\nhigh = 5\n", 4.0, 4.0 / 12.0},
                           Case{"law = \"triangular\"\nlow = 3\nmode = 3.5\nhigh = 5\n", (3.0 + 3.5 + 5.0) / 3.0,
                                (9.0 + 12.25 + 25.0 - 10.5 - 15.0 - 17.5) / 18.0}}) {
    const std::vector<double> values = all_of(Drawer{spreads_of(one(each.law)), 1}, 0);
    EXPECT_NEAR(mean(values), each.mean, five_deviations * std::sqrt(each.variance)) << each.law;
    EXPECT_NEAR(product_moment(values, values), each.variance, five_deviations * std::sqrt(2.0) * each.variance)
        << each.law;
  }
}

TEST(Draws, OfQuantitiesThatDependOnEachOtherHaveTheCorrelationsAsked) {
  const Drawer drawer{spreads_of("[[spread]]\nfields = [\"aerodynamics.damping_m2\", \"aerodynamics.torque_m\", "
                                 "\"body.mass_kg\"]\nlaw = \"normal\"\nmeans = [23, 9, 4]\n"
                                 "standard_deviations = [2, 1, 0.1]\ncorrelations = [0.8, -0.3, 0.1]\n"),
                      5};
  const std::vector<double> damping = all_of(drawer, 0);
  const std::vector<double> torque = all_of(drawer, 1);
  const std::vector<double> mass = all_of(drawer, 2);
  EXPECT_NEAR(mean(damping), 23.0, 2.0 * five_deviations);
  EXPECT_NEAR(product_moment(damping, torque) / 2.0, 0.8, five_deviations);
  EXPECT_NEAR(product_moment(damping, mass) / 0.2, -0.3, five_deviations);
  EXPECT_NEAR(product_moment(torque, mass) / 0.1, 0.1, five_deviations);
}

TEST(Draws, OfATableAreItsRowsEachAsOftenAsAnother) {
  const input::ScratchFile table{"alpha,beta\n20,8\n22,9\n25,7\n", "rows.csv"};
  const auto spreads = spreads_of(
      "[[spread]]\nfields = [\"aerodynamics.damping_m2\", \"aerodynamics.torque_m\"]\nlaw = \"rows\"\n"
      "table = \"" +
      table.path().string() + "\"\ncolumns = [\"alpha\", \"beta\"]\n");
  const Drawer drawer{spreads, 1};
  std::vector<double> times(3);
  for (std::uint64_t run = 0; run < runs; ++run) {
    const std::vector<double> row = drawer.draw(run).numbers;
    const auto met = std::ranges::find(spreads[0].rows, row);
    ASSERT_NE(met, spreads[0].rows.end()) << "a row, not a mixture";
    ++times[static_cast<std::size_t>(met - spreads[0].rows.begin())];
  }
  for (const double each : times) {
    EXPECT_NEAR(each / static_cast<double>(runs), 1.0 / 3.0, five_deviations * std::sqrt(2.0) / 3.0);
  }
}

// Three rows with the mean 50 and the standard deviation 2: the next one has Student's t distribution with two degrees
// of freedom, 2 sqrt(1 + 1/3) wide, whose probability to be within t of its middle is t / sqrt(2 + t^2).
TEST(Draws, OfTheNextRowOfATableKnowHowFewItsRowsAre) {
  const input::ScratchFile table{"alpha,beta\n48,8\n50,10\n52,9\n", "next_row.csv"};
  const Drawer drawer{spreads_of("[[spread]]\nfields = [\"aerodynamics.damping_m2\", \"aerodynamics.torque_m\"]\n"
                                 "law = \"next_row\"\noutside = \"truncate\"\ntable = \"" +
                                 table.path().string() + "\"\ncolumns = [\"alpha\", \"beta\"]\n"),
                      1};
  const std::vector<double> damping = all_of(drawer, 0);
  for (const double t : {0.3, 1.0, 3.0}) {
    const double within = 2.0 * t * std::sqrt(4.0 / 3.0);
    const auto count = std::ranges::count_if(damping, [&](double value) { return std::abs(value - 50.0) < within; });
    EXPECT_NEAR(static_cast<double>(count) / static_cast<double>(runs), t / std::sqrt(2.0 + t * t), 0.02) << t;
  }
  // Both numbers have half a correlation in the rows: whatever one row's factor is, it is one for both.
  const std::vector<double> torque = all_of(drawer, 1);
  double together = 0.0;
  for (std::size_t i = 0; i < damping.size(); ++i) {
    together += (damping[i] > 50.0) == (torque[i] > 9.0) ? 1.0 : 0.0;
  }
  // Of two numbers with a normal law and this correlation, or its multiple by one factor: 1/2 + asin(1/2) / pi.
  EXPECT_NEAR(together / static_cast<double>(runs), 2.0 / 3.0, 0.02);
}

TEST(Draws, ChangeTheFilesByTheirEffect) {
  const Drawer drawer{spreads_of("[[spread]]\nfield = \"disturbance.angles_deg\"\nlaw = \"uniform\"\n"
                                 "effect = \"offset\"\nlow = 0.999999\nhigh = 1.000001\n"),
                      1};
  const Draw draw = drawer.draw(0);
  EXPECT_EQ(draw.changes[0].section, "disturbance");
  double first = 0.0;
  double second = 0.0;
  ASSERT_EQ(std::sscanf(draw.changes[0].value.c_str(), "[%lf, %lf]", &first, &second), 2) << draw.changes[0].value;
  EXPECT_NEAR(first, -3.9, 2e-6);
  EXPECT_NEAR(second, -4.1, 2e-6);
}

TEST(Draws, ThatAFieldDoesNotAllowAreRefusedOrDrawnAgainAsAsked) {
  const std::string tilt = "[[spread]]\nfield = \"launch_guide.tilt_deg\"\nlaw = \"normal\"\nstandard_deviation = 4\n";
  const Drawer refusing{spreads_of(tilt), 1};
  std::string said;
  for (std::uint64_t run = 0; run < 100 && said.empty(); ++run) {
    try {
      (void)refusing.draw(run);
    } catch (const text::Error& error) {
      said = error.what();
    }
  }
  EXPECT_NE(said.find("allowed: 0 to 15; outside = \"truncate\" draws again instead"), std::string::npos) << said;

  // Half of a normal law about 0 is below it; the mean of the other half is sqrt(2 / pi) of its standard deviation.
  const Drawer drawer{spreads_of(tilt + "outside = \"truncate\"\n"), 1};
  double sum = 0.0;
  std::size_t again = 0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    const Draw draw = drawer.draw(run);
    EXPECT_GE(draw.numbers[0], 0.0);
    sum += draw.numbers[0];
    again += draw.drawn_again;
  }
  EXPECT_NEAR(sum / static_cast<double>(runs), 4.0 * std::sqrt(2.0 / 3.14159265358979), 0.1);
  EXPECT_NEAR(static_cast<double>(again) / static_cast<double>(runs), 1.0, 0.06) << "as often outside as inside";
}

TEST(Draws, OfALawThatAFieldNeverAllowsEnd) {
  const Drawer drawer{spreads_of(one("law = \"uniform\"\nlow = -2\nhigh = -1\noutside = \"truncate\"\n")), 1};
  EXPECT_THROW((void)drawer.draw(0), text::Error);
}

TEST(Draws, OfARunAreTheSameInEveryOrder) {
  const Drawer drawer{spreads_of(one("law = \"normal\"\nstandard_deviation = 0.1\n")), 9};
  const double seventh = drawer.draw(7).numbers[0];
  for (std::uint64_t run = 49; run > 0; --run) {
    (void)drawer.draw(run);
  }
  EXPECT_EQ(drawer.draw(7).numbers[0], seventh);
}

TEST(Seeds, EveryRunHasOneOfItsOwn) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t master = 0; master < 20; ++master) {
    for (std::size_t index = 0; index < 500; ++index) {
      seeds.insert(runs::seed_of_run(master, index));
    }
  }
  EXPECT_EQ(seeds.size(), 10000U);
  EXPECT_EQ(runs::seed_of_run(7, 3), runs::seed_of_run(7, 3));
}

// jq, JavaScript and spreadsheets have no other numbers than doubles.
TEST(Seeds, OfRunsComeBackFromADouble) {
  for (const std::uint64_t master : {std::uint64_t{1}, std::uint64_t{7}, std::numeric_limits<std::uint64_t>::max()}) {
    for (std::uint64_t run = 0; run < 1000; ++run) {
      const std::uint64_t seed = runs::seed_of_run(master, run);
      EXPECT_EQ(static_cast<std::uint64_t>(static_cast<double>(seed)), seed);
      EXPECT_LT(seed, std::uint64_t{1} << 53U);
    }
  }
}

// The correlation of n pairs of independent even numbers has a standard deviation of n^-1/2.
TEST(UnitCoordinates, OfTwoDimensionsDoNotDependOnEachOtherAndAreNeitherZeroNorOne) {
  double sum = 0.0;
  for (std::uint64_t run = 0; run < runs; ++run) {
    const double first = unit_coordinate(11, run, 0);
    EXPECT_GT(first, 0.0);
    EXPECT_LT(first, 1.0);
    sum += (first - 0.5) * (unit_coordinate(11, run, 1) - 0.5);
  }
  EXPECT_NEAR(12.0 * sum / static_cast<double>(runs), 0.0, five_deviations);
}

// What a search for rare failures draws at a point is what a run draws there.
TEST(Draws, AtStandardNormalNumbersAreThoseOfARunWithTheSameNumbers) {
  const std::vector<Spread> spreads =
      spreads_of(one("law = \"normal\"\neffect = \"factor\"\nstandard_deviation = 0.02\n") +
                 "[[spread]]\nfield = \"servo.lag_s\"\nlaw = \"uniform\"\nlow = 0.01\nhigh = 0.03\n"
                 "[[spread]]\nfield = \"motor.thrust_factor\"\nlaw = \"triangular\"\nlow = 0.9\nmode = 1.0\n"
                 "high = 1.05\n");
  const Drawer drawer{spreads, 3};
  ASSERT_EQ(drawer.dimensions(), 3U);
  for (std::uint64_t run = 0; run < 200; ++run) {
    std::vector<double> normals;
    for (std::size_t i = 0; i < drawer.dimensions(); ++i) {
      normals.push_back(distributions::normal_quantile(unit_coordinate(3, run, i)));
    }
    const auto there = drawer.draw_at(normals);
    ASSERT_TRUE(there.has_value());
    const Draw drawn = drawer.draw(run);
    for (std::size_t i = 0; i < drawn.numbers.size(); ++i) {
      EXPECT_NEAR(there->numbers[i], drawn.numbers[i], 1e-9 * std::abs(drawn.numbers[i]));
    }
  }
}

}  // namespace
}  // namespace fantail::campaign
