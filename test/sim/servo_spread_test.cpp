// SPDX-License-Identifier: MIT

#include "servo_test_rig.hpp"
#include "sim/servo.hpp"
#include "test.hpp"

namespace fantail::sim {
namespace {

constexpr std::uint64_t spread_seed = 5;

std::vector<ServoParameters> draw(int count, const ServoParameters& typical, const ServoSpread& spread) {
  Random random{spread_seed, 0};
  std::vector<ServoParameters> servos;
  for (int i = 0; i < count; ++i) {
    servos.push_back(one_of_the_spread(typical, spread, random));
  }
  return servos;
}

TEST(ServoSpread, OfZeroGivesTheTypicalServoToTheLastBit) {
  const ServoParameters typical{};
  for (const ServoParameters& one : draw(100, typical, {})) {
    EXPECT_EQ(one.lag_s, typical.lag_s);
    EXPECT_EQ(one.delay_s, typical.delay_s);
    EXPECT_EQ(one.rate_limit_rad_s, typical.rate_limit_rad_s);
    EXPECT_EQ(one.backlash_rad, typical.backlash_rad);
    EXPECT_EQ(one.centre_rad, typical.centre_rad);
  }
}

// An even distribution over 1 +- s has the standard deviation s / sqrt(3), and 10000 draws come near both ends.
TEST(ServoSpread, IsEvenAndMovesEachNumberByItself) {
  constexpr int count = 10'000;
  const ServoParameters typical{};
  const ServoSpread spread{.share = 0.1, .centre_rad = 0.5 * degree};
  const std::vector<ServoParameters> servos = draw(count, typical, spread);
  const std::vector<double (*)(const ServoParameters&)> deviations{
      [](const ServoParameters& p) { return (p.lag_s / ServoParameters{}.lag_s - 1.0) / 0.1; },
      [](const ServoParameters& p) { return (p.delay_s / ServoParameters{}.delay_s - 1.0) / 0.1; },
      [](const ServoParameters& p) { return (p.rate_limit_rad_s / ServoParameters{}.rate_limit_rad_s - 1.0) / 0.1; },
      [](const ServoParameters& p) { return (p.backlash_rad / ServoParameters{}.backlash_rad - 1.0) / 0.1; },
      [](const ServoParameters& p) { return p.centre_rad / (0.5 * degree); }};
  for (std::size_t a = 0; a < deviations.size(); ++a) {
    double lowest = 0.0;
    double highest = 0.0;
    std::vector<double> products(deviations.size());
    double sum = 0.0;
    for (const ServoParameters& one : servos) {
      const double deviation = deviations[a](one);
      lowest = std::min(lowest, deviation);
      highest = std::max(highest, deviation);
      sum += deviation;
      for (std::size_t b = 0; b < deviations.size(); ++b) {
        products[b] += deviation * deviations[b](one);
      }
    }
    EXPECT_GE(lowest, -1.0 - 1e-12);
    EXPECT_LT(lowest, -0.99);
    EXPECT_LE(highest, 1.0 + 1e-12);
    EXPECT_GT(highest, 0.99);
    EXPECT_NEAR(sum / count, 0.0, 4.0 * std::sqrt(1.0 / 3.0 / count));
    for (std::size_t b = 0; b < deviations.size(); ++b) {
      EXPECT_NEAR(products[b] / count, a == b ? 1.0 / 3.0 : 0.0, 4.0 / 3.0 / std::sqrt(count)) << a << " and " << b;
    }
  }
}

TEST(ServoSpread, OfTheCentreLeavesTheOtherNumbersAsTheyWere) {
  const std::vector<ServoParameters> with = draw(100, {}, {.share = 0.2, .centre_rad = 1.0 * degree});
  const std::vector<ServoParameters> without = draw(100, {}, {.share = 0.2});
  const std::vector<ServoParameters> centres_only = draw(100, {}, {.centre_rad = 1.0 * degree});
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].lag_s, without[i].lag_s);
    EXPECT_EQ(with[i].backlash_rad, without[i].backlash_rad);
    EXPECT_EQ(with[i].centre_rad, centres_only[i].centre_rad);
    EXPECT_NE(with[i].centre_rad, 0.0);
  }
}

TEST(ServoSpread, MakesOnlyServosThatServoAccepts) {
  for (const double lag_s : {0.0005, 1.0}) {
    const ServoParameters typical{
        .lag_s = lag_s, .delay_s = 0.05, .rate_limit_rad_s = 1.0 * degree, .stop_rad = 1.0 * degree};
    for (const ServoParameters& one : draw(1000, typical, {.share = 0.3, .centre_rad = 1.0 * degree})) {
      EXPECT_NO_THROW((void)Servo{one});
    }
  }
}

}  // namespace
}  // namespace fantail::sim
