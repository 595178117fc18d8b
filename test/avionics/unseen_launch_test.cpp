// SPDX-License-Identifier: MIT
// Flights that the flight law does not see, or does not control, and what else pushes a rocket.

#include "recorder_rig.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;
using protocol::LogBegin;
using protocol::LogEnd;
using protocol::LogEventKind;
using protocol::LogRecord;

constexpr float g = core::standard_gravity_m_s2;

struct UnseenLaunch : testing::Test {
  hal::sim::Flash flash{{.size = 16U << 20U, .sector_size = 4096, .page_size = 256}};
  RecorderRig rig{flash};
  UnseenLaunch() {
    rig.rests = false;
    rig.run(Phase::safe, 4096);  // until every sector has been looked at
  }

  std::span<std::byte> log() { return region_of(flash); }
  [[nodiscard]] bool records() { return rig.service.recorder().busy(); }
  /// With so much of specific force, along this axis and no other; not at rest.
  void push(float axial_g, float lateral_g, int ticks, Phase phase) {
    rig.rests = false;
    rig.specific_force_m_s2 = {.x = axial_g * g, .z = lateral_g * g};
    rig.run(phase, ticks);
    rig.specific_force_m_s2 = {.x = g};
  }
  void rest(Phase phase) {
    rig.rests = true;
    rig.run(phase, 1000);
  }
  std::vector<LogBegin> begun() {
    std::vector<LogBegin> all;
    for (const protocol::LogEvent& event : events_in(log())) {
      if (event.kind == LogEventKind::recording_began) {
        all.push_back(static_cast<LogBegin>(event.value));
      }
    }
    return all;
  }
};

TEST_F(UnseenLaunch, BeyondTheThresholdForFiftyMillisecondsTheRingGoesToTheFlash) {
  rest(Phase::armed);
  push(2.01F, 0.0F, 49, Phase::armed);
  rig.tick(Phase::armed);
  EXPECT_FALSE(records());
  push(2.01F, 0.0F, 50, Phase::armed);
  EXPECT_TRUE(records());
  push(0.0F, 0.0F, 8000, Phase::armed);
  EXPECT_TRUE(records()) << "a flight, as far as anybody knows";
  rest(Phase::armed);
  EXPECT_FALSE(records());
  EXPECT_EQ(begun(), std::vector{LogBegin::acceleration});
  EXPECT_EQ(count(records_in(log()), LogRecord::tick), 500U + 1U + 8000U + 1U)
      << "half a second, the push's end, and what came";
  ASSERT_FALSE(events_in(log()).empty());
  EXPECT_EQ(events_in(log()).back().value, static_cast<std::uint8_t>(LogEnd::returned_to_pad));
}

TEST_F(UnseenLaunch, AnyDirectionCountsAndSoDoesASensorAtTheEndOfItsRange) {
  rest(Phase::armed);
  push(1.0F, -1.8F, 50, Phase::armed);  // 2.06 g in all
  EXPECT_TRUE(records());
}

TEST_F(UnseenLaunch, BelowTheThresholdNothingIsWritten) {
  rest(Phase::armed);
  push(1.99F, 0.0F, 5000, Phase::armed);
  EXPECT_FALSE(records());
}

TEST_F(UnseenLaunch, ThatIsDetectedAfterAllStaysOneRecord) {
  rest(Phase::armed);
  push(2.2F, 0.0F, 200, Phase::armed);
  push(2.2F, 0.0F, 500, Phase::launched);
  push(2.2F, 0.0F, 500, Phase::controlling);
  rest(Phase::finished);
  EXPECT_TRUE(records());
  EXPECT_EQ(begun(), std::vector{LogBegin::acceleration});
}

TEST_F(UnseenLaunch, AFlightThatIsNeverControlledIsRecordedUntilItLiesStillOrAMinuteIsOver) {
  rest(Phase::armed);
  push(6.0F, 0.0F, 40, Phase::armed);
  push(6.0F, 0.0F, 300, Phase::launched);
  push(0.0F, 0.0F, 59'990, Phase::armed);  // the gate of the guide refused it
  EXPECT_TRUE(records());
  push(0.0F, 0.0F, 1000, Phase::armed);
  EXPECT_FALSE(records());
  EXPECT_EQ(begun(), std::vector{LogBegin::flight});
}

TEST_F(UnseenLaunch, ARocketThatNobodyArmedIsRecordedIfItStoodStillBefore) {
  push(3.0F, 0.0F, 500, Phase::safe);
  EXPECT_FALSE(records()) << "somebody carries it";
  rest(Phase::safe);
  push(6.0F, 0.0F, 3000, Phase::safe);
  EXPECT_TRUE(records());
  rest(Phase::safe);
  EXPECT_FALSE(records());
  EXPECT_EQ(begun(), std::vector{LogBegin::acceleration});
}

TEST_F(UnseenLaunch, InSafeThreeRecordsAreAllThatHandlingCanMake) {
  for (int i = 0; i < 6; ++i) {
    rest(Phase::safe);
    push(4.0F, 0.0F, 200, Phase::safe);
  }
  rest(Phase::safe);
  EXPECT_EQ(begun().size(), 3U);
  rest(Phase::armed);
  push(4.0F, 0.0F, 200, Phase::armed);
  EXPECT_TRUE(records()) << "an armed rocket is always recorded";
}

TEST_F(UnseenLaunch, WhileABenchOrASelfTestMovesTheCanardsNothingIsRecordedInSafe) {
  rig.request.emplace();
  rest(Phase::safe);
  push(4.0F, 0.0F, 200, Phase::safe);
  EXPECT_FALSE(records());
  rig.request.reset();
  rest(Phase::safe);
  push(4.0F, 0.0F, 200, Phase::safe);
  EXPECT_TRUE(records());
  rig.request.emplace();
  rig.run(Phase::safe, 1000);
  EXPECT_FALSE(records()) << "no replay knows a request";
}

}  // namespace
}  // namespace fantail::avionics
