// SPDX-License-Identifier: MIT
// The monitor at the edges of its limits and times, with encoders that stand exactly where they are put.

#include "core/canard_monitor.hpp"
#include "core/flight_plan_fields.hpp"
#include "test.hpp"

namespace fantail::core {
namespace {

using namespace literals;

constexpr Angle tracking_limit = 0.25_rad;
constexpr Angle agreement_limit = 0.125_rad;
constexpr Angle far_off = 0.5_rad;
constexpr Angle never = 100.0_rad;

// Reads where each canard is expected.
struct Expected {
  std::vector<std::optional<Angle>> of;
  template <typename... T>
  void operator()(T&... values) {
    (each(values), ...);
  }
  template <typename T>
  void below(std::size_t /*limit*/, T& /*value*/) const {}

 private:
  template <typename T, std::size_t n>
  void each(std::array<T, n>& values) {
    for (T& value : values) {
      value.visit_state(*this);
    }
  }
  void each(std::optional<Angle>& expected) { of.push_back(expected); }
  template <typename T>
  void each(T& /*other*/) const {}
};

// All canards are commanded to 0 and have been seen there, so a departure is the angle of the encoder.
struct PutBench {
  MonitorPlan plan;
  CanardMonitor monitor;
  CanardCommands commands{};
  EncoderAngles encoders{};
  Microseconds time{};

  explicit PutBench(Microseconds hold, Angle tracking = tracking_limit, Angle agreement = never)
      : plan{.servo_lag = Microseconds{25'000},
             .tracking_limit = tracking,
             .disagreement_limit = agreement,
             .hold = hold,
             .encoder_timeout = Microseconds{20'000}},
        monitor{plan, default_plan().canards} {
    encoders.fill(Angle{});
    for (CanardCommand& command : commands) {
      command.driven = true;
    }
    after(1000);
  }
  const CanardVerdicts& after(std::int64_t elapsed_us) {
    time += Microseconds{elapsed_us};
    return monitor.update(time, commands, encoders);
  }
  void wait_ms(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      after(1000);
    }
  }
  std::optional<Angle> expected(std::size_t canard) {
    Expected visit;
    monitor.visit_state(visit);
    return visit.of[canard];
  }
};

CanardVerdicts all_are(CanardVerdict verdict) {
  CanardVerdicts verdicts;
  verdicts.fill(verdict);
  return verdicts;
}

CanardVerdicts only(std::size_t canard, CanardVerdict verdict) {
  CanardVerdicts verdicts{};
  verdicts[canard] = verdict;
  return verdicts;
}

TEST(CanardMonitor, FourCanardsThatFailAlikeAreAllReported) {
  PutBench stuck{Microseconds{10'000}};
  stuck.encoders.fill(far_off);
  stuck.wait_ms(9);
  EXPECT_EQ(stuck.monitor.verdicts(), CanardVerdicts{});
  EXPECT_EQ(stuck.after(1000), all_are(CanardVerdict::stalled));
  PutBench silent{Microseconds{10'000}};
  silent.encoders.fill(std::nullopt);
  silent.wait_ms(20);
  EXPECT_EQ(silent.monitor.verdicts(), CanardVerdicts{});
  EXPECT_EQ(silent.after(1000), all_are(CanardVerdict::dead));
}

// Although, by the limit of this plan, it does not stand apart from the others.
TEST(CanardMonitor, EachCanardIsJudgedByItsOwnCommandToo) {
  for (std::size_t canard = 0; canard < canard_count; ++canard) {
    PutBench bench{Microseconds{10'000}};
    bench.encoders[canard] = far_off;
    bench.wait_ms(10);
    EXPECT_EQ(bench.monitor.verdicts(), only(canard, CanardVerdict::stalled));
  }
}

TEST(CanardMonitor, ACanardThatMovedByLessThanThreeTenthsOfADegreeDidNotMove) {
  for (const bool moves : {false, true}) {
    PutBench bench{Microseconds{10'000}};
    for (CanardCommand& command : bench.commands) {
      command.angle = far_off;
    }
    bench.encoders.fill(far_off);
    bench.monitor.bridge();
    bench.after(1000);
    bench.encoders[1] = Angle{};
    bench.wait_ms(5);
    bench.encoders[1] = moves ? 0.3_deg : Angle::from_radians(std::nextafter((0.3_deg).radians(), 0.0F));
    bench.wait_ms(5);
    EXPECT_EQ(bench.monitor.verdicts(), only(1, moves ? CanardVerdict::slipping : CanardVerdict::stalled));
  }
}

TEST(CanardMonitor, ADifferenceOfTheTrackingLimitIsAllowed) {
  PutBench bench{Microseconds{10'000}};
  bench.encoders[2] = far_off;
  bench.wait_ms(5);
  bench.encoders[2] = tracking_limit;
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(bench.after(1000), CanardVerdicts{}) << i;
  }
  bench.encoders[2] = Angle::from_radians(std::nextafter(tracking_limit.radians(), 1.0F));
  bench.wait_ms(10);
  EXPECT_EQ(bench.monitor.verdicts(), only(2, CanardVerdict::stalled));
}

// A clock that jumps must not condemn a canard: a tick counts 5 ms at most.
TEST(CanardMonitor, ALongTickCountsFiveMilliseconds) {
  for (const std::int64_t hold_us : {10'000, 10'001}) {
    PutBench bench{Microseconds{hold_us}};
    bench.encoders[0] = far_off;
    bench.after(100'000);
    EXPECT_EQ(bench.monitor.verdicts(), CanardVerdicts{});
    bench.after(100'000);
    EXPECT_EQ(bench.monitor.verdicts(), hold_us == 10'000 ? only(0, CanardVerdict::stalled) : CanardVerdicts{});
  }
}

// Half of 9999 us is more than 4999 us: one microsecond of the charge is left, then none.
TEST(CanardMonitor, HalfTheHoldIsMeasuredToTheMicrosecondAndNothingIsLeftOfIt) {
  for (const CanardVerdict verdict : {CanardVerdict::slipping, CanardVerdict::disagreeing}) {
    const bool slips = verdict == CanardVerdict::slipping;
    PutBench bench{Microseconds{9'999}, slips ? tracking_limit : never, slips ? never : agreement_limit};
    bench.encoders[1] = far_off;
    bench.after(3333);
    bench.after(3333);
    EXPECT_EQ(bench.monitor.verdicts(), CanardVerdicts{});
    bench.encoders[1] = far_off + 1_deg;
    EXPECT_EQ(bench.after(3333), only(1, verdict));
    bench.encoders[1] = Angle{};
    EXPECT_EQ(bench.after(4999), only(1, verdict));
    EXPECT_EQ(bench.after(1), CanardVerdicts{});
    bench.encoders[1] = far_off;
    EXPECT_EQ(bench.after(1000), CanardVerdicts{}) << "it has the whole hold before it again";
  }
}

TEST(CanardMonitor, AVerdictOutlivesAGapAndIsThenTakenBackLikeAnother) {
  PutBench bench{Microseconds{10'000}};
  bench.encoders[3] = far_off;
  bench.wait_ms(10);
  bench.monitor.bridge();
  EXPECT_EQ(bench.after(60'000), only(3, CanardVerdict::stalled)) << "nobody looked in the gap";
  for (int i = 1; i < 5; ++i) {
    ASSERT_EQ(bench.after(1000), only(3, CanardVerdict::stalled)) << i;
  }
  EXPECT_EQ(bench.after(1000), CanardVerdicts{}) << "it is expected where it was seen after the gap";
}

TEST(CanardMonitor, ACanardThatWasNotDrivenStartsFromWhereItIsSeenAndWithoutItsPast) {
  for (const CanardVerdict verdict : {CanardVerdict::stalled, CanardVerdict::disagreeing}) {
    for (const std::int64_t hold_us : {1'000, 10'000}) {
      const bool stalls = verdict == CanardVerdict::stalled;
      PutBench bench{Microseconds{hold_us}, stalls ? tracking_limit : never, stalls ? never : agreement_limit};
      bench.encoders[1] = far_off;
      bench.wait_ms(10);
      EXPECT_EQ(bench.monitor.verdicts(), only(1, verdict));
      bench.commands[1].driven = false;
      bench.encoders[1] = Angle{};
      bench.wait_ms(1);
      EXPECT_EQ(bench.monitor.verdicts(), CanardVerdicts{});
      bench.commands[1] = {.angle = far_off, .driven = true};
      bench.encoders[1] = far_off;
      for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(bench.after(1000), CanardVerdicts{}) << i;
      }
    }
  }
}

// A lag never arrives by itself: what is left would shrink into numbers that a PC is slow with.
TEST(CanardMonitor, ACanardIsExpectedAtItsCommandOnceATenThousandthOfADegreeIsLeft) {
  PutBench bench{Microseconds{10'000}, never};
  const auto put_off_by = [&bench](Angle off) {
    bench.monitor.bridge();
    bench.encoders.fill(off);
    bench.after(1000);
    ASSERT_EQ(bench.expected(0), off);
  };
  put_off_by(0.0001_deg);
  bench.after(1000);
  EXPECT_GT(bench.expected(0), Angle{}) << "exactly so much is not yet near enough";
  put_off_by(far_off);
  int ticks = 0;
  for (Angle before = far_off; before != Angle{} && ticks < 1000; before = *bench.expected(0), ++ticks) {
    bench.after(1000);
    ASSERT_EQ(bench.expected(0) == Angle{}, before < 0.0001_deg) << before.degrees();
  }
  // Of 28.6 degrees, a time constant of 25 ms each by the factor e.
  EXPECT_NEAR(ticks, 25.0 * std::log(static_cast<double>(far_off.degrees()) / 0.0001), 2.0);
}

// Neither behind the first time nor behind another.
TEST(CanardMonitor, ATimeThatRepeatsMovesNothing) {
  PutBench bench{Microseconds{10'000}, never};
  bench.commands[0].angle = far_off;
  bench.after(0);
  EXPECT_EQ(bench.expected(0), Angle{});
  bench.after(1000);
  const std::optional<Angle> before = bench.expected(0);
  EXPECT_GT(before, Angle{});
  bench.after(0);
  EXPECT_EQ(bench.expected(0), before);
}

// By the rule in words: apart is who is further than the limit from the middle of the others, where the middle of two
// is all that lies between them, and one alone has none.
bool is_apart(std::optional<float> own, std::vector<float> others) {
  std::ranges::sort(others);
  if (!own || others.size() < 2) {
    return false;
  }
  const float low = others.size() == 3 ? others[1] : others[0];
  return *own < low - agreement_limit.radians() || *own > others[1] + agreement_limit.radians();
}

TEST(CanardMonitor, WhoStandsApartFollowsFromTheMiddleOfTheOthersInAnyOrder) {
  constexpr std::array<std::optional<float>, 6> places{-0.25F, -0.125F, 0.0F, 0.0625F, 0.1875F, std::nullopt};
  const std::size_t count = places.size();
  for (std::size_t code = 0; code < count * count * count * count; ++code) {
    const std::array<std::optional<float>, canard_count> seen{places[code % count], places[code / count % count],
                                                              places[code / count / count % count],
                                                              places[code / count / count / count]};
    PutBench bench{Microseconds{1'000}, never, agreement_limit};
    CanardVerdicts expected{};
    for (std::size_t i = 0; i < canard_count; ++i) {
      std::vector<float> others;
      for (std::size_t j = 0; j < canard_count; ++j) {
        if (j != i && seen[j]) {
          others.push_back(*seen[j]);
        }
      }
      bench.encoders[i] = seen[i] ? std::optional{Angle::from_radians(*seen[i])} : std::nullopt;
      expected[i] = is_apart(seen[i], others) ? CanardVerdict::disagreeing : CanardVerdict::healthy;
    }
    ASSERT_EQ(bench.after(1000), expected) << code;
  }
}

}  // namespace
}  // namespace fantail::core
