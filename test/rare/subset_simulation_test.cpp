// SPDX-License-Identifier: MIT
#include "rare/subset_simulation.hpp"

#include <cstdio>

#include "sim/random.hpp"
#include "test.hpp"

namespace fantail::rare {
namespace {

const MakeAll one_after_the_other = [](std::size_t /*batch*/, std::size_t count,
                                       const std::function<Chain(std::size_t)>& make) {
  std::vector<Chain> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(make(i));
  }
  return all;
};

double upper_tail(double normal) { return 0.5 * std::erfc(normal / std::numbers::sqrt2); }

/// Fails beyond a plane at this distance, in a direction that no axis has.
std::optional<double> behind_plane(const Point& point, double distance) {
  double sum = 0.0;
  for (const double normal : point.normals) {
    sum += normal;
  }
  return distance - sum / std::sqrt(static_cast<double>(point.normals.size()));
}

struct Repeats {
  double mean = 0.0;
  double variation = 0.0;  ///< of the estimates, over their mean
  double said = 0.0;       ///< the coefficient of variation that they say, root of the mean square
  double covered = 0.0;    ///< share of the intervals that hold the truth
  double points = 0.0;     ///< mean
};

Repeats repeat(int times, const Settings& settings, double truth, const Margin& margin) {
  Repeats all;
  double squares = 0.0;
  for (int i = 0; i < times; ++i) {
    Settings own = settings;
    own.master_seed += static_cast<std::uint64_t>(i);
    const Estimate one = estimate(own, margin, one_after_the_other);
    EXPECT_EQ(one.end, End::found);
    all.mean += one.probability / times;
    squares += one.probability * one.probability / times;
    all.said += one.coefficient_of_variation * one.coefficient_of_variation / times;
    all.covered += (one.low <= truth && truth <= one.high ? 1.0 : 0.0) / times;
    all.points += static_cast<double>(one.points) / times;
  }
  all.variation = std::sqrt(squares - all.mean * all.mean) / all.mean;
  all.said = std::sqrt(all.said);
  std::printf("%d times, truth %.3g: mean %.3g, variation %.2f (said %.2f), covered %.0f %%, %.0f points\n", times,
              truth, all.mean, all.variation, all.said, 100.0 * all.covered, all.points);
  return all;
}

TEST(SubsetSimulation, FindsOneInAMillionBehindAPlane) {
  const double distance = 4.753424308823;  // normal quantile of 1 - 1e-6
  const Repeats all = repeat(100, {.master_seed = 1, .dimensions = 10}, upper_tail(distance),
                             [=](const Point& point) { return behind_plane(point, distance); });
  EXPECT_NEAR(all.mean, 1e-6, 0.1e-6);
  EXPECT_LT(all.variation, 0.3);
  EXPECT_LT(all.points, 20'000);
  EXPECT_GE(all.covered, 0.85);
}

TEST(SubsetSimulation, FindsWhatOneNumberAloneDecides) {
  const double distance = 4.75;
  for (const std::size_t samples : {300, 1000, 3000}) {
    const Repeats all =
        repeat(100, {.master_seed = 1, .dimensions = 1, .samples_a_level = samples}, upper_tail(distance),
               [=](const Point& point) { return std::optional{distance - point.normals[0]}; });
    EXPECT_GE(all.covered, 0.8) << samples;
    if (samples == 3000) {
      EXPECT_NEAR(all.mean, upper_tail(distance), 0.1 * upper_tail(distance));
    }
  }
}

TEST(SubsetSimulation, FindsOneInAThousandOnTwoSidesWhereTheSeedDecidesToo) {
  const double distance = 3.0;
  const auto noise = [](std::uint64_t seed) {
    return static_cast<double>((seed * 0x9E3779B97F4A7C15ULL) >> 11U) * 0x1p-53;  // even over [0, 1)
  };
  // Fails where |z| + noise > 3: the mean of the tail over the noise.
  double truth = 0.0;
  for (int i = 0; i < 1000; ++i) {
    truth += 2.0 * upper_tail(distance - (i + 0.5) / 1000.0) / 1000.0;
  }
  const Repeats all =
      repeat(100, {.master_seed = 1, .dimensions = 4, .samples_a_level = 1000}, truth,
             [=](const Point& point) { return distance - std::abs(point.normals[2]) - noise(point.seed); });
  EXPECT_NEAR(all.mean, truth, 0.1 * truth);
  EXPECT_GE(all.covered, 0.85);
}

TEST(SubsetSimulation, AgreesWithPlainSamplesOfOneInAThousand) {
  // A bent surface in three dimensions, of which nobody has a closed form: a million plain samples have one.
  const auto bent = [](const Point& point) -> std::optional<double> {
    const auto& z = point.normals;
    return 4.2 - z[0] - 0.3 * z[1] * z[1] - 0.2 * std::abs(z[2]);
  };
  std::uint64_t fails = 0;
  constexpr std::uint64_t plain = 1'000'000;
  sim::Random random{7, 1};
  for (std::uint64_t i = 0; i < plain; ++i) {
    const Point point{.normals = {random.gaussian(), random.gaussian(), random.gaussian()}};
    fails += *bent(point) < 0.0 ? 1 : 0;
  }
  const double truth = static_cast<double>(fails) / static_cast<double>(plain);
  const Repeats all = repeat(100, {.master_seed = 3, .dimensions = 3, .samples_a_level = 1000}, truth, bent);
  EXPECT_NEAR(all.mean, truth, 0.1 * truth);
  EXPECT_GE(all.covered, 0.85);
}

// As a roll that is held until the canards do not suffice.
TEST(SubsetSimulation, FindsFailuresThatBeginBeforeTheMarginThatLedThereIsUsedUp) {
  const double begins = 3.6;
  const Repeats all = repeat(100, {.master_seed = 1, .dimensions = 5, .samples_a_level = 1000}, upper_tail(begins),
                             [=](const Point& point) {
                               const double z = point.normals[1];
                               return std::optional{z > begins ? -100.0 * z : 4.0 - z};
                             });
  EXPECT_NEAR(all.mean, upper_tail(begins), 0.1 * upper_tail(begins));
  EXPECT_GE(all.covered, 0.85);
}

TEST(SubsetSimulation, LeavesOutWhatALawExcludes) {
  // Of the half that is allowed one in 740 lies beyond three.
  const Margin half = [](const Point& point) {
    return point.normals[0] < 0.0 ? std::nullopt : std::optional{3.0 - point.normals[0]};
  };
  const double truth = 2.0 * upper_tail(3.0);
  const Repeats all = repeat(50, {.master_seed = 1, .dimensions = 2, .samples_a_level = 1000}, truth, half);
  EXPECT_NEAR(all.mean, truth, 0.15 * truth);
}

TEST(SubsetSimulation, IsTheSameInWhateverOrderItsChainsAreMade) {
  const Settings settings{.master_seed = 5, .dimensions = 3, .samples_a_level = 500};
  const Margin margin = [](const Point& point) { return behind_plane(point, 4.0); };
  const MakeAll last_first = [](std::size_t /*batch*/, std::size_t count,
                                const std::function<Chain(std::size_t)>& make) {
    std::vector<Chain> all(count);
    for (std::size_t i = count; i > 0; --i) {
      all[i - 1] = make(i - 1);
    }
    return all;
  };
  const Estimate one = estimate(settings, margin, one_after_the_other);
  const Estimate other = estimate(settings, margin, last_first);
  EXPECT_EQ(one.probability, other.probability);
  EXPECT_EQ(one.curve, other.curve);
}

TEST(SubsetSimulation, SaysThatNothingOrEverythingFails) {
  const Settings settings{.master_seed = 1, .dimensions = 2, .samples_a_level = 200};
  const Estimate never =
      estimate(settings, [](const Point& point) { return behind_plane(point, 40.0); }, one_after_the_other);
  EXPECT_EQ(never.end, End::never_fails);
  EXPECT_NEAR(std::log10(never.probability), -12.0, 0.5);
  EXPECT_TRUE(never.failing.empty());
  const Estimate always =
      estimate(settings, [](const Point& point) { return behind_plane(point, -40.0); }, one_after_the_other);
  EXPECT_EQ(always.end, End::always_fails);
  EXPECT_EQ(always.probability, 1.0);
}

TEST(SubsetSimulation, SaysThatItDoesNotAdvanceWhereTheMarginIsASwitch) {
  const Settings settings{.master_seed = 1, .dimensions = 2, .samples_a_level = 1000};
  const auto steps = [](const Point& point) -> std::optional<double> { return point.normals[0] > 3.0 ? -1.0 : 1.0; };
  const Estimate found = estimate(settings, steps, one_after_the_other);
  EXPECT_EQ(found.end, End::does_not_advance);
  EXPECT_EQ(found.stuck_at, 1.0);
}

TEST(SubsetSimulation, OfWhatIsNotRareIsAPlainShareWithWilsonsInterval) {
  const Settings settings{.master_seed = 1, .dimensions = 1, .samples_a_level = 1000};
  const Estimate found =
      estimate(settings, [](const Point& point) { return behind_plane(point, 0.0); }, one_after_the_other);
  ASSERT_EQ(found.levels.size(), 1U);
  EXPECT_NEAR(found.probability, 0.5, 0.08);
  EXPECT_NEAR(found.high - found.low, 2.0 * 1.96 * std::sqrt(0.25 / 1000.0), 1e-3);
}

}  // namespace
}  // namespace fantail::rare
