// SPDX-License-Identifier: MIT
#include "rare/margin.hpp"

#include <vector>

#include "test.hpp"

namespace fantail::rare {
namespace {

constexpr campaign::Question held{.outcome = "held"};
constexpr std::size_t hold_error = 0, offset = 2, mach = 5;

Left with(double hold_error_left, double offset_left, double mach_left) {
  Left left;
  left.of[hold_error] = hold_error_left;
  left.of[offset] = offset_left;
  left.of[mach] = mach_left;
  return left;
}

// The fin offset of these spreads widely, their Mach number hardly, and their hold error is far from its limit until
// canards do not suffice.
std::vector<Left> plain_flights() {
  std::vector<Left> all;
  for (int i = -20; i <= 20; ++i) {
    all.push_back(with(0.17 + 1e-4 * i, 0.1 + 0.002 * i, 0.4 + 1e-3 * i));
  }
  return all;
}

TEST(Margin, FollowsTheLimitThatIsFewestStandardDeviationsAwayNotTheSmallestNumber) {
  const auto plain = plain_flights();
  const Yardstick yardstick{held, plain};
  EXPECT_EQ(yardstick.nearest(with(0.17, 0.1, 0.4)), offset);
  EXPECT_NEAR(yardstick.margin(with(0.17, 0.1, 0.4), false), 0.1 / 0.0239583, 1e-4);  // deviation of -20 ... 20: 11.98
  EXPECT_EQ(yardstick.nearest(with(0.17, 0.1, 0.01)), mach);
}

TEST(Margin, IsBelowZeroExactlyWhereAFlightFails) {
  const auto plain = plain_flights();
  const Yardstick yardstick{held, plain};
  EXPECT_LT(yardstick.margin(with(-1.0, 0.1, 0.4), true), just_failed);
  EXPECT_EQ(yardstick.margin(with(0.17, 0.1, 0.4), true), failed_by_an_event);
  EXPECT_EQ(yardstick.margin({}, true), failed_by_an_event);
  EXPECT_GT(yardstick.margin({}, false), 0.0);
  const double beyond = yardstick.margin(with(0.17, -0.01, 0.4), false);
  EXPECT_GT(beyond, 0.0) << "held with canards that did not suffice for a moment";
  EXPECT_LT(beyond, yardstick.margin(with(0.17, 0.01, 0.4), false));
  EXPECT_LT(yardstick.margin(with(0.01, -0.01, 0.4), false), beyond) << "and goes on by the others";
}

TEST(Margin, OfAFigureIsItsDistanceInItsUnit) {
  const campaign::Question apogee{.relation = campaign::Relation::at_least, .bound = 400.0};
  const Yardstick yardstick{apogee, {}};
  Left left;
  left.of.front() = -12.5;
  EXPECT_EQ(yardstick.margin(left, true), -12.5);
}

}  // namespace
}  // namespace fantail::rare
