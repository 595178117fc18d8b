// SPDX-License-Identifier: MIT

#include "gateway/gateway.hpp"
#include "test.hpp"

namespace fantail::gateway {
namespace {

using hal::Microseconds;

TEST(AvionicsClock, IsNotKnownBeforeTheFirstHeartbeat) {
  AvionicsClock clock;
  EXPECT_EQ(clock.at(Microseconds{5}), std::nullopt);
  EXPECT_FALSE(clock.hear(7'000, Microseconds{1'000'000}));
  EXPECT_EQ(clock.at(Microseconds{1'000'000}), Microseconds{7'000'000});
  EXPECT_EQ(clock.at(Microseconds{1'050'000}), Microseconds{7'050'000});
}

TEST(AvionicsClock, AHeartbeatThatWasHeldUpDoesNotTurnItBack) {
  AvionicsClock clock;
  (void)clock.hear(7'000, Microseconds{0});
  EXPECT_EQ(clock.at(Microseconds{100'000}), Microseconds{7'100'000});
  // 40 ms late: the clock goes back by an eighth of that, and nothing that was told is taken back.
  EXPECT_FALSE(clock.hear(7'100, Microseconds{140'000}));
  EXPECT_EQ(clock.at(Microseconds{140'000}), Microseconds{7'135'000});
  EXPECT_FALSE(clock.hear(7'200, Microseconds{200'000}));
  EXPECT_EQ(clock.at(Microseconds{200'000}), Microseconds{7'200'000});
}

TEST(AvionicsClock, NeverGoesBackWithoutANewStart) {
  AvionicsClock clock;
  (void)clock.hear(1'000, Microseconds{0});
  EXPECT_EQ(clock.at(Microseconds{50'000}), Microseconds{1'050'000});
  (void)clock.hear(1'001, Microseconds{50'001});  // its PC slept
  EXPECT_EQ(clock.at(Microseconds{50'001}), Microseconds{1'050'000});
}

TEST(AvionicsClock, GoesOnOverTheWrapOfItsTwentyFourBits) {
  AvionicsClock clock;
  (void)clock.hear(0xFFFFFF, Microseconds{0});
  EXPECT_FALSE(clock.hear(99, Microseconds{100'000}));
  EXPECT_EQ(clock.at(Microseconds{100'000}), Microseconds{(std::int64_t{0xFFFFFF} + 100) * 1000});
}

TEST(AvionicsClock, AnAvionicsThatWasSwitchedOnAgainBeginsAnew) {
  AvionicsClock clock;
  (void)clock.hear(60'000, Microseconds{0});
  (void)clock.at(Microseconds{10});
  EXPECT_TRUE(clock.hear(44, Microseconds{5'000'000}));
  EXPECT_EQ(clock.at(Microseconds{5'000'000}), Microseconds{44'000});
}

// After 2^23 ms and more, 2 h 20 min, a clock that goes back to 0 looks to 24 bits like one that goes on.
TEST(AvionicsClock, AnAvionicsThatWasOnForHoursAndIsSwitchedOnAgainBeginsAnewToo) {
  for (const std::uint32_t on_for_ms : {8'000'000U, 9'000'000U, 12'000'000U, 16'700'000U}) {
    AvionicsClock clock;
    (void)clock.hear(on_for_ms, Microseconds{0});
    EXPECT_TRUE(clock.hear(44, Microseconds{5'000'000})) << on_for_ms;
    EXPECT_EQ(clock.at(Microseconds{5'000'000}), Microseconds{44'000}) << on_for_ms;
  }
}

TEST(AvionicsClock, AnAvionicsThatNobodyHeardForHoursIsNotSwitchedOnAgain) {
  AvionicsClock clock;
  (void)clock.hear(1'000'000, Microseconds{0});
  EXPECT_FALSE(clock.hear(4'600'000, Microseconds{3'600'000'000})) << "this PC was busy elsewhere";
  EXPECT_FALSE(clock.hear(8'200'000, Microseconds{3'600'100'000})) << "and then suspended, and its clock with it";
}

}  // namespace
}  // namespace fantail::gateway
