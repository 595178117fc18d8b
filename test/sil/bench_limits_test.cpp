// SPDX-License-Identifier: MIT

#include "avionics/can_frame.hpp"
#include "figures.hpp"
#include "replies/sentence.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

std::string all(const bench::Sheet& sheet) {
  std::string text;
  for (const std::string& sentence : bench::conclusions(sheet)) {
    text += sentence + "\n";
  }
  return text;
}

struct Fault {
  const char* scenario;
  std::size_t canard;
  bench::Cause cause;
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.scenario; }

class BenchFault : public testing::TestWithParam<Fault> {};

// Several rockets of the same make, each with its own noise and servos.
TEST_P(BenchFault, IsNamedByCanardAndCauseAndTheOthersAreHealthy) {
  const auto& [scenario, canard, cause] = GetParam();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    BenchAtWorld place{scenario, seed};
    const bench::Sheet sheet = place.limits();
    EXPECT_FALSE(sheet.passed());
    ASSERT_EQ(sheet.canards.size(), 4U);
    for (const bench::CanardResult& result : sheet.canards) {
      EXPECT_EQ(bench::name(result.diagnosis.cause),
                bench::name(result.canard == canard ? cause : bench::Cause::healthy))
          << "canard " << result.canard + 1 << ", seed " << seed << "\n"
          << all(sheet);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, BenchFault,
                         testing::Values(Fault{"bench_canard1_stuck", 0, bench::Cause::stuck},
                                         Fault{"bench_canard1_dead", 0, bench::Cause::dead},
                                         Fault{"bench_canard2_slipping", 1, bench::Cause::slipping},
                                         Fault{"bench_canard2_encoder_unplugged", 1, bench::Cause::encoder_unplugged},
                                         Fault{"bench_canard3_reversed", 2, bench::Cause::reversed},
                                         Fault{"bench_canard3_wrong_trim", 2, bench::Cause::wrong_trim},
                                         Fault{"bench_canard4_slow", 3, bench::Cause::slow},
                                         Fault{"bench_canard4_encoder_noisy", 3, bench::Cause::encoder_noisy}),
                         [](const auto& one) { return std::string{one.param.scenario}; });

// Two hundred with the spread of servos and sensors are judged in test/bench/lockstep_test.cpp; here by the whole
// avionics.
TEST(BenchLimits, FortyHealthyRocketsRaiseNoFalseAlarm) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    BenchAtWorld place{"bench_healthy", seed};
    const bench::Sheet sheet = place.limits();
    ASSERT_TRUE(sheet.passed()) << "seed " << seed << "\n" << all(sheet);
    ASSERT_EQ(sheet.lost_ticks, 0U);
  }
}

TEST(BenchLimits, NoCanardIsEverToldMoreThanItsLimitAndAllAreCentredAtTheEnd) {
  BenchAtWorld place{"bench_healthy"};
  float most_deg = 0.0F;
  place.after_tick = [&] {
    for (const core::CanardCommand& command : place.record.canards) {
      most_deg = std::max(most_deg, abs(command.angle).degrees());
    }
  };
  EXPECT_TRUE(place.limits().passed());
  EXPECT_FLOAT_EQ(most_deg, place.scenario.plan.controller.canard_limit.degrees());
  for (const core::CanardCommand& command : place.record.canards) {
    EXPECT_NEAR(command.angle.degrees(), 0.0F, 0.001F);
  }
}

struct CtrlC {};

TEST(BenchLimits, AnInterruptAtFiveMomentsOfAnExerciseCentresTheCanards) {
  for (const double at_s : {0.1, 1.0, 2.5, 7.7, 20.0}) {
    BenchAtWorld place{"bench_healthy"};
    link::AvionicsLink link{place.bus()};
    link::Session session = place.open_session(link);
    const bench::Exercise exercise =
        bench::Exercise::limits(bench::bounds(link.newest<protocol::LimitReport>()->message, session.trims()));
    EXPECT_THROW((void)bench::perform(exercise, session, link,
                                      [&](double done_s) {
                                        if (done_s >= at_s) {
                                          throw CtrlC{};
                                        }
                                      }),
                 CtrlC);
    EXPECT_TRUE(session.close());
    for (const core::CanardCommand& command : place.record.canards) {
      EXPECT_NEAR(command.angle.degrees(), 0.0F, 0.001F) << at_s;
    }
  }
}

TEST(BenchLimits, ABusThatGoesAwayEndsTheSessionOnBothSides) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::Session session = place.open_session(link);
  session.request({core::Angle::from_degrees(5), {}, {}, {}});
  session.wait(second);
  ASSERT_NEAR(place.record.canards[0].angle.degrees(), 5.0F, 0.01F);
  place.wire.set_state(hal::CanState::down);
  EXPECT_THROW(session.wait(5 * second), link::LinkError);
  place.wait(110 * millisecond);  // the avionics' patience
  EXPECT_NEAR(place.record.canards[0].angle.degrees(), 0.0F, 0.001F);
  EXPECT_FALSE(session.close()) << "nobody can say so";
}

// The other one may be at work while this one's process was stopped.
TEST(BenchLimits, ABenchThatFindsAnothersSessionDoesNotSpeakIntoIt) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::Session session = place.open_session(link);
  session.request({core::Angle::from_degrees(5), {}, {}, {}});
  session.wait(second);
  hal::sim::CanBus other_bus{place.wire};
  for (std::uint8_t i = 0; i < 12; ++i) {
    place.wait(20 * millisecond);
    (void)other_bus.send(
        avionics::can_frame(encode(protocol::BenchSession{.action = protocol::SessionAction::open, .session = 6}, i)));
  }
  EXPECT_THROW(session.wait(second), link::LinkError);
  EXPECT_NEAR(place.record.canards[0].angle.degrees(), 0.0F, 0.001F);
}

TEST(BenchLimits, FramesThatAreLostOnTheWayAreCountedAndSpoilNothing) {
  BenchAtWorld place{"bench_healthy"};
  // Another node that eats what the bench should have had: one frame in fifty.
  int arrived = 0;
  place.after_tick = [&] {
    if (++arrived % 50 == 0) {
      (void)place.pc_bus.receive();
    }
  };
  const bench::Sheet sheet = place.limits();
  EXPECT_TRUE(sheet.passed()) << all(sheet);
  EXPECT_GT(sheet.lost_ticks, 100U);
}

TEST(BenchLimits, ASilentBusIsSaidSo) {
  BenchAtWorld place{"bench_healthy"};
  place.wire.set_state(hal::CanState::down);
  link::AvionicsLink link{place.bus()};
  try {
    link::await_avionics(place, link);
    FAIL();
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "silent")) << error.what();
  }
}

TEST(BenchLimits, ARocketThatMovesIsRefused) {
  BenchAtWorld place{"bench_healthy"};
  link::AvionicsLink link{place.bus()};
  link::await_avionics(place, link);  // within two seconds of power-up: it has not yet been seen at rest
  try {
    const link::Session session{place, link, 5};
    FAIL();
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), replies::sentence(protocol::SessionReason::not_at_rest))) << error.what();
  }
}

}  // namespace
}  // namespace fantail::sil
