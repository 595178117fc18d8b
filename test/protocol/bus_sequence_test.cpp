// SPDX-License-Identifier: MIT

#include "protocol/bus_codec.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

TEST(BusSequence, TheFirstFrameFollowsOnWhateverItsCounter) {
  for (std::uint8_t counter = 0; counter < 16; ++counter) {
    EXPECT_EQ(Sequence{}.lost_before(counter), 0);
  }
}

TEST(BusSequence, CountsTheFramesThatWereLostAndRefusesARepetition) {
  for (unsigned last = 0; last < 16; ++last) {
    for (unsigned step = 0; step < 16; ++step) {
      Sequence sequence;
      sequence.lost_before(static_cast<std::uint8_t>(last));
      const auto lost = sequence.lost_before(static_cast<std::uint8_t>((last + step) % 16U));
      if (step == 0) {
        EXPECT_EQ(lost, std::nullopt);
      } else {
        EXPECT_EQ(lost, step - 1);
      }
    }
  }
}

TEST(BusSequence, ASenderCountsFromZeroToFifteenAndAround) {
  FrameCounter counter;
  for (unsigned frame = 0; frame < 40; ++frame) {
    EXPECT_EQ(counter.next(), frame % 16U);
  }
}

TEST(BusSequence, EveryFrameBecomesTheNewLastOne) {
  Sequence sequence;
  sequence.lost_before(3);
  EXPECT_EQ(sequence.lost_before(7), 3);
  EXPECT_EQ(sequence.lost_before(8), 0);
  EXPECT_EQ(sequence.lost_before(8), std::nullopt);
  EXPECT_EQ(sequence.lost_before(8), std::nullopt);
  EXPECT_EQ(sequence.lost_before(9), 0);
}

}  // namespace
}  // namespace fantail::protocol
