// SPDX-License-Identifier: MIT
#include <cstdio>

#include "telemetry/receiver.hpp"
#include "test.hpp"

namespace fantail::telemetry {
namespace {

std::vector<Arrival> take_all(const std::vector<std::int64_t>& numbers, ChannelFigures& figures) {
  SequenceWatch watch;
  std::vector<Arrival> arrivals;
  for (const std::int64_t number : numbers) {
    arrivals.push_back(watch.take(number, figures));
  }
  return arrivals;
}

TEST(SequenceWatch, WhatComesInOrderIsReceivedAndNothingElse) {
  ChannelFigures figures;
  EXPECT_EQ(take_all({7, 8, 9, 10}, figures), std::vector(4, Arrival::newest));
  EXPECT_EQ(figures, (ChannelFigures{.received = 4}));
}

TEST(SequenceWatch, AGapIsLostUntilItComesLate) {
  ChannelFigures figures;
  EXPECT_EQ(take_all({0, 1, 5, 3, 3}, figures),
            (std::vector{Arrival::newest, Arrival::newest, Arrival::newest, Arrival::late, Arrival::duplicate}));
  // Of 0 to 5 there came 0, 1, 5 and 3: 2 and 4 are lost.
  EXPECT_EQ(figures, (ChannelFigures{.received = 4, .lost = 2, .late = 1, .duplicate = 1}));
}

TEST(SequenceWatch, WhatIsOlderThanTheFirstOneHeardWasNeverLost) {
  ChannelFigures figures;
  EXPECT_EQ(take_all({100, 98, 101, 98}, figures),
            (std::vector{Arrival::newest, Arrival::late, Arrival::newest, Arrival::duplicate}));
  EXPECT_EQ(figures, (ChannelFigures{.received = 2, .late = 1, .duplicate = 1}));
}

TEST(SequenceWatch, TheEndsOfTheWindowAndOfTheLongestGap) {
  constexpr std::int64_t top = 50'000;
  for (const auto& [number, arrival] :
       std::vector<std::pair<std::int64_t, Arrival>>{{top - SequenceWatch::window, Arrival::far_off},
                                                     {top - SequenceWatch::window + 1, Arrival::late},
                                                     {top + SequenceWatch::longest_gap, Arrival::newest},
                                                     {top + SequenceWatch::longest_gap + 1, Arrival::far_off},
                                                     {std::numeric_limits<std::int64_t>::max(), Arrival::far_off},
                                                     {0, Arrival::far_off}}) {
    ChannelFigures figures;
    EXPECT_EQ(take_all({top, number}, figures).back(), arrival) << number;
  }
}

// A link that loses, repeats and reorders, drawn by a seed; what must come out is counted while it is drawn.
TEST(SequenceWatch, CountsWhatASeededBadLinkHasDone) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> chance{0.0, 1.0};
    constexpr std::int64_t sent = 5'000;
    struct Flying {
      double comes_at;
      std::int64_t number;
    };
    std::vector<Flying> flying;
    ChannelFigures wanted;
    for (std::int64_t number = 0; number < sent; ++number) {
      // The first and the last one come in order, so that the span of what is counted is known.
      const bool safe = number == 0 || number == sent - 1;
      if (!safe && chance(random) < 0.1) {
        wanted.lost += 1;
        continue;
      }
      wanted.received += 1;
      const double held_up = safe || chance(random) < 0.7 ? 0.0 : 40.0 * chance(random);
      const double comes_at = static_cast<double>(number) + held_up;
      flying.push_back({comes_at, number});
      if (!safe && chance(random) < 0.05) {
        wanted.duplicate += 1;
        flying.push_back({comes_at + 30.0 * chance(random), number});
      }
    }
    std::ranges::stable_sort(flying, {}, &Flying::comes_at);
    std::vector<std::int64_t> numbers;
    std::set<std::int64_t> before;
    for (const Flying& one : flying) {
      wanted.late += !before.contains(one.number) && !before.empty() && one.number < *before.rbegin() ? 1 : 0;
      before.insert(one.number);
      numbers.push_back(one.number);
    }
    ChannelFigures figures;
    (void)take_all(numbers, figures);
    EXPECT_EQ(figures.received, wanted.received);
    EXPECT_EQ(figures.lost, wanted.lost);
    EXPECT_EQ(figures.late, wanted.late);
    EXPECT_EQ(figures.duplicate, wanted.duplicate);
    EXPECT_EQ(figures.received + figures.lost, sent);
  }
}

}  // namespace
}  // namespace fantail::telemetry
