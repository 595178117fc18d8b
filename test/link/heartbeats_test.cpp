// SPDX-License-Identifier: MIT
// One rocket sends a heartbeat every 100 ms of its own time; what cannot be so is two of them.
#include "link/heartbeats.hpp"

#include "../core/random_stream.hpp"
#include "link/frame_order.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::link {
namespace {

constexpr std::uint32_t wrap_ms = 1U << 24U;

/// `count` heartbeats of a rocket from `first_ms` on.
void hear(Heartbeats& ear, std::uint64_t first_ms, int count) {
  for (int i = 0; i < count; ++i) {
    (void)ear.hear(static_cast<std::uint32_t>((first_ms + 100U * static_cast<unsigned>(i)) % wrap_ms));
  }
}

TEST(WrappingCounter, CountsOnOverEveryWrap) {
  WrappingCounter<256> counter{250};
  for (int value = 251; value < 2'000; ++value) {
    EXPECT_EQ(counter.read(value % 256), 1);
    EXPECT_EQ(counter.total(), value);
  }
  EXPECT_TRUE(counter.is_back((counter.total() - 100) % 256));
  EXPECT_FALSE(counter.is_back((counter.total() + 100) % 256));
}

TEST(WrappingCounter, OfFramesTakesTheSameNumberForAWholeRound) {
  WrappingCounter<16> counter{15};
  EXPECT_EQ(counter.read_next(0), 1);
  EXPECT_EQ(counter.read_next(0), 16);
  EXPECT_EQ(counter.read_next(15), 15);
  EXPECT_EQ(counter.total(), 15 + 1 + 16 + 15);
}

TEST(Heartbeats, OfARocketThatIsOnForDaysAreOfOneClockThatNeverWraps) {
  Heartbeats ear;
  hear(ear, 44, 3 * 24 * 36'000);
  EXPECT_EQ(ear.uptime_ms(), 44 + 100LL * (3 * 24 * 36'000 - 1));
  EXPECT_FALSE(ear.two_rockets());
}

TEST(Heartbeats, OfARocketThatIsSwitchedOffAndOnAreOfOneRocketWhenever) {
  for (std::uint64_t on_ms = 44; on_ms < 3'000; on_ms += 100) {
    Heartbeats ear;
    hear(ear, 1'000'044, 3);
    for (std::uint64_t time_ms = 44; time_ms <= on_ms; time_ms += 100) {
      hear(ear, time_ms, 1);
    }
    hear(ear, 44, 100);
    EXPECT_FALSE(ear.two_rockets()) << "off after " << on_ms << " ms: " << *ear.two_rockets();
    EXPECT_EQ(ear.uptime_ms(), 44 + 9'900);
  }
}

TEST(Heartbeats, OfARocketThatNobodyHeardForAWhileAreOfOneRocket) {
  for (const std::uint64_t gap_ms : {200U, 500U, 1'000U, 60'000U, 3'600'000U}) {
    Heartbeats ear;
    hear(ear, 1'044, 10);
    hear(ear, 1'944 + gap_ms, 10);
    EXPECT_FALSE(ear.two_rockets()) << gap_ms;
    EXPECT_EQ(ear.uptime_ms(), 1'944 + static_cast<std::int64_t>(gap_ms) + 900);
  }
}

TEST(Heartbeats, AFrameThatTheBusGivesTwiceIsNoSecondRocket) {
  Heartbeats ear;
  for (std::uint64_t time_ms = 44; time_ms < 20'000; time_ms += 100) {
    hear(ear, time_ms, time_ms % 5'000 == 44 ? 2 : 1);
  }
  EXPECT_FALSE(ear.two_rockets());
}

// Also when both were switched on by one switch, and count the same milliseconds.
TEST(Heartbeats, OfTwoRocketsAreToldWithinFiveWhateverTheirUptimes) {
  for (const std::int64_t between_ms :
       {0LL, 1LL, 30LL, 99LL, 100LL, 101LL, 200LL, 300LL, 400LL, 500LL, 1'000LL, 20'000LL, 8'388'608LL, 16'777'116LL}) {
    for (const std::uint64_t first_ms : {44ULL, 5'044ULL, 16'777'144ULL}) {
      Heartbeats ear;
      int heard = 0;
      for (std::uint64_t i = 0; !ear.two_rockets() && heard < 50; ++i) {
        hear(ear, first_ms + 100 * i, 1);
        hear(ear, first_ms + 100 * i + static_cast<std::uint64_t>(between_ms), 1);
        heard += 2;
      }
      EXPECT_LE(heard, 6) << between_ms << " ms between them, the first on for " << first_ms << " ms";
    }
  }
}

TEST(Heartbeats, OneOfSomebodyElseIsTold) {
  Heartbeats ear;
  hear(ear, 100'044, 10);
  hear(ear, 7, 1);
  hear(ear, 101'044, 1);
  ASSERT_TRUE(ear.two_rockets());
  EXPECT_EQ(*ear.two_rockets(),
            "two rockets, or a device that imitates one, report on this bus, with uptimes of 100.9 s and 0.0 s; "
            "disconnect all but one");
}

// The queue of the PC had room for the first of them alone, and then both came.
TEST(Heartbeats, OfTwoRocketsAreToldAfterALongGapToo) {
  Heartbeats ear;
  hear(ear, 1'044, 3);
  for (std::uint64_t i = 0; i < 3; ++i) {
    hear(ear, 4'144 + 100 * i, 1);
    hear(ear, 10'044 + 100 * i, 1);
  }
  EXPECT_TRUE(ear.two_rockets());
}

// As it was once heard: both of them came in a burst, of nodes on a busy PC, and then at their own pace. A clock that
// goes back by 100 ms has not been switched on again 15 s ago, whoever stood still meanwhile.
TEST(Heartbeats, OfTwoRocketsAreToldAfterABurstByTheFirstThatGoesBack) {
  for (const std::size_t from : {0U, 4U, 10U, 20U, 21U}) {
    constexpr std::array<std::uint32_t, 27> heard_ms{
        11'144, 10'544, 11'744, 12'444, 13'344, 14'144, 14'544, 14'244, 14'344, 14'444, 14'644, 14'744, 14'544, 14'844,
        14'644, 14'944, 14'744, 15'044, 14'844, 15'144, 14'944, 15'044, 15'244, 15'144, 15'244, 15'344, 15'444};
    Heartbeats ear;
    bool went_back = false;
    for (std::size_t i = from; i < heard_ms.size(); ++i) {
      went_back = went_back || (i > from && heard_ms.at(i) < heard_ms.at(i - 1));
      (void)ear.hear(heard_ms.at(i), i > from ? std::optional{130} : std::nullopt);
      EXPECT_EQ(ear.two_rockets().has_value(), went_back) << from << ": " << i;
    }
  }
}

// Frames of two rockets that alternate, behind any burst of one, heard in any portions.
TEST(Heartbeats, OfTwoRocketsAreToldWithinFiveBehindABurstOfOne) {
  core::RandomStream random{test::seed()};
  for (int trial = 0; trial < 2'000; ++trial) {
    Heartbeats ear;
    auto one_ms = static_cast<std::uint64_t>(random.whole(60'000, 16'000'000));
    auto other_ms = static_cast<std::uint64_t>(random.whole(60'000, 16'000'000));
    for (int i = random.whole(0, 40); i > 0; --i, one_ms += 100) {
      (void)ear.hear(static_cast<std::uint32_t>(one_ms), random.whole(0, 2'000));
    }
    ASSERT_FALSE(ear.two_rockets()) << trial;
    for (int i = 0; i < 3; ++i, one_ms += 100, other_ms += 100) {
      (void)ear.hear(static_cast<std::uint32_t>(other_ms), 60);
      (void)ear.hear(static_cast<std::uint32_t>(one_ms), 60);
    }
    EXPECT_TRUE(ear.two_rockets()) << trial << ": " << one_ms << ", " << other_ms;
  }
}

// Heard late, early, in portions, after a PC that stood still; off for any time, and on again.
TEST(Heartbeats, OfARocketThatIsSwitchedOffAndOnAreOfOneRocketWheneverTheyAreRead) {
  core::RandomStream random{test::seed()};
  for (int trial = 0; trial < 2'000; ++trial) {
    Heartbeats ear;
    std::int64_t sent_ms = 0;
    std::int64_t listened_ms = 0;
    std::int64_t no_older_ms = 0;
    for (int start = 0; start < 3; ++start) {
      sent_ms += random.whole(0, 5'000);
      std::int64_t uptime_ms = 44;
      for (int i = random.whole(2, 60); i > 0; --i, sent_ms += 100, uptime_ms += 100) {
        const std::int64_t stall_ms = random.chance(0.1) ? random.whole(0, 30'000) : 0;
        const std::int64_t read_ms = std::max(listened_ms, sent_ms) + stall_ms;
        (void)ear.hear(static_cast<std::uint32_t>(uptime_ms), read_ms - no_older_ms);
        no_older_ms = std::min(sent_ms, listened_ms);
        listened_ms = read_ms;
      }
    }
    EXPECT_FALSE(ear.two_rockets()) << trial << ": " << ear.two_rockets().value_or("");
  }
}

// Of each rocket some are lost; the order in which two come does not matter.
TEST(Heartbeats, OfTwoRocketsAreToldOnABusThatLosesAQuarterAndOfOneNever) {
  core::RandomStream random{test::seed()};
  for (int trial = 0; trial < 2'000; ++trial) {
    const auto first_ms = static_cast<std::uint64_t>(random.whole(0, 16'777'215));
    const auto between_ms = static_cast<std::uint64_t>(random.whole(0, 16'777'215));
    Heartbeats alone;
    Heartbeats both;
    for (std::uint64_t i = 0; i < 40; ++i) {
      const std::uint64_t one_ms = first_ms + 100 * i;
      if (!random.chance(0.25)) {
        hear(alone, one_ms, 1);
      }
      const bool other_first = random.chance(0.5);
      for (const bool other : {other_first, !other_first}) {
        if (!random.chance(0.25)) {
          hear(both, other ? one_ms + between_ms : one_ms, 1);
        }
      }
    }
    EXPECT_FALSE(alone.two_rockets()) << "trial " << trial;
    EXPECT_TRUE(both.two_rockets()) << "trial " << trial << ", " << between_ms << " ms between them";
  }
}

bool two_senders(core::RandomStream& random, double loss, std::optional<int> second_from, double second_share) {
  FrameOrder order;
  int other = second_from.value_or(0);
  for (int frame = 0; frame < 3'000; ++frame) {
    if (!random.chance(loss)) {
      order.take(static_cast<std::uint8_t>(frame % 16));
    }
    if (second_from && random.chance(second_share)) {
      order.take(static_cast<std::uint8_t>(other++ % 16));
    }
    if (random.chance(loss / 20.0)) {  // and now and then very many at once
      frame += random.whole(1, 500);
    }
  }
  return order.two_senders();
}

TEST(FrameOrder, OfOneSenderIsNeverTakenForThatOfTwoWhateverIsLost) {
  core::RandomStream random{test::seed()};
  for (int trial = 0; trial < 500; ++trial) {
    for (const double loss : {0.0, 0.01, 0.1, 0.3}) {
      EXPECT_FALSE(two_senders(random, loss, {}, 0.0)) << trial << ": " << loss;
    }
  }
}

// Between any two frames that it reads the PC stands still for some time.
TEST(FrameOrder, OfOneSenderReadByAPcThatAlwaysStallsIsNotTakenForThatOfTwo) {
  core::RandomStream random{test::seed()};
  FrameOrder order;
  for (int frame = 0; frame < 60'000; ++frame) {
    order.take(static_cast<std::uint8_t>(random.whole(0, 15)));
  }
  EXPECT_FALSE(order.two_senders());
}

TEST(FrameOrder, OfTwoSendersIsToldAlsoWhenTheSecondIsAFifthAsFast) {
  core::RandomStream random{test::seed()};
  for (int second_from = 0; second_from < 16; ++second_from) {
    for (const double share : {0.2, 0.5}) {
      EXPECT_TRUE(two_senders(random, 0.0, second_from, share)) << second_from << ": " << share;
    }
  }
}

}  // namespace
}  // namespace fantail::link
