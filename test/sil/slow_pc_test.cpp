// SPDX-License-Identifier: MIT
// The whole exercise with a PC that looks at the bus only now and then. It may say that it was too slow; it must never
// say anything untrue of a canard.
#include <cstdio>
#include <ostream>

#include <fmt/core.h>

#include "bench/perform.hpp"
#include "figures.hpp"
#include "random_stream.hpp"
#include "seed.hpp"
#include "sil/bench_at_world.hpp"
#include "test.hpp"

namespace fantail::sil {
namespace {

constexpr std::size_t linux_queue = 1U << 16U;  ///< frames; more than come between two looks
constexpr std::size_t short_queue = 64;         ///< 24 ms of a bench session

/// The kernel's queue in front of the program: what finds no room is lost.
class Queue final : public hal::CanBus {
 public:
  Queue(hal::CanBus& wire, std::size_t longest) : wire_{wire}, longest_{longest} {}

  void fill() {
    while (const auto frame = wire_.receive()) {
      if (frames_.size() < longest_) {
        frames_.push_back(*frame);
      } else {
        overrun_ += 1;
      }
    }
  }
  bool send(const hal::CanFrame& frame) override { return wire_.send(frame); }
  std::optional<hal::CanFrame> receive() override {
    if (frames_.empty()) {
      return std::nullopt;
    }
    const hal::CanFrame frame = frames_.front();
    frames_.pop_front();
    return frame;
  }
  [[nodiscard]] hal::CanState state() const override { return wire_.state(); }
  [[nodiscard]] hal::CanCounters counters() const override {
    hal::CanCounters counters = wire_.counters();
    counters.overrun += overrun_;
    return counters;
  }

 private:
  hal::CanBus& wire_;
  std::size_t longest_;
  std::uint32_t overrun_ = 0;
  std::deque<hal::CanFrame> frames_;
};

/// A PC whose every wait takes at least so long.
class SlowPc final : public link::Place {
 public:
  SlowPc(BenchAtWorld& rocket, hal::Microseconds look, std::size_t queue_length)
      : rocket_{rocket}, look_{look}, queue_{rocket.pc_bus, queue_length} {
    rocket_.after_tick = [this] { queue_.fill(); };
  }

  [[nodiscard]] hal::CanBus& bus() override { return queue_; }
  [[nodiscard]] hal::Microseconds now() const override { return rocket_.now(); }
  void wait(hal::Microseconds at_most) override {
    const bool stalls = slow && stalls_left > 0 && stream.chance(0.001);
    stalls_left -= stalls ? 1 : 0;
    rocket_.wait(stalls ? stream.whole(61, 75) * millisecond : slow ? look_ : at_most);
  }

  bool slow = false;
  int stalls_left = 0;
  core::RandomStream stream{0};

 private:
  BenchAtWorld& rocket_;
  hal::Microseconds look_;
  Queue queue_;
};

enum class Outcome : std::uint8_t { passed, found, void_sheet, wrong };
const char* name(Outcome outcome) {
  constexpr std::array<const char*, 4> names{"pass", "found", "void", "WRONG"};
  return names[static_cast<std::size_t>(outcome)];
}
void PrintTo(Outcome outcome, std::ostream* out) { *out << name(outcome); }

/// A canard, from 0, and what the sheet is to say of it; all others are healthy.
struct Fault {
  std::size_t canard;
  bench::Cause cause;
};
constexpr Fault reversed{2, bench::Cause::reversed};
constexpr Fault slow{3, bench::Cause::slow};
constexpr Fault slow_in_a_sine{3, bench::Cause::out_of_tolerance};  // a sine does not show why

Outcome verdict(const bench::Sheet& sheet, const Fault& fault) {
  if (sheet.passed()) {
    return Outcome::passed;
  }
  if (sheet.judgement() == bench::Judgement::none) {
    return Outcome::void_sheet;  // a stall may leave a figure unmeasured; seed 639401611 does
  }
  for (const bench::CanardResult& result : sheet.canards) {
    const bench::Cause expected = result.canard == fault.canard ? fault.cause : bench::Cause::healthy;
    if (result.diagnosis.cause != expected) {
      return Outcome::wrong;
    }
  }
  return Outcome::found;
}

using MakeExercise = std::function<bench::Exercise(const bench::Bounds&)>;

Outcome outcome_of(const MakeExercise& make, const Fault& fault, const char* scenario, hal::Microseconds look,
                   std::size_t queue_length, std::uint32_t stall_seed = 0) {
  BenchAtWorld rocket{scenario};
  SlowPc pc{rocket, look, queue_length};
  pc.stream = core::RandomStream{stall_seed};
  pc.stalls_left = stall_seed == 0 ? 0 : 10;
  link::AvionicsLink link{pc.bus()};
  try {
    link::await_avionics(pc, link);
    pc.wait(3 * second);
    while (link.listen(pc.now())) {
    }
    pc.slow = true;
    link::Session session{pc, link, 5};
    const bench::Bounds bounds = bench::bounds(link.newest<protocol::LimitReport>()->message, session.trims());
    const bench::Exercise exercise = make(bounds);
    const link::Recording recording = bench::perform(exercise, session, link, [](double) {});
    const bench::Sheet sheet = bench::examine(recording, exercise, rocket.scenario.vehicle.canard_tolerances, {});
    const Outcome outcome = verdict(sheet, fault);
    if (outcome == Outcome::wrong) {
      for (const std::string& sentence : bench::conclusions(sheet)) {
        ADD_FAILURE() << sentence;
      }
    }
    return outcome;
  } catch (const bench::Unmeasured& error) {
    EXPECT_TRUE(says(error.what(), "canards")) << error.what();
  } catch (const link::LinkError& error) {
    EXPECT_TRUE(says(error.what(), "heartbeat")) << error.what();
  }
  return Outcome::void_sheet;
}

Outcome limits(const char* scenario, hal::Microseconds look, std::size_t queue_length, std::uint32_t stall_seed = 0) {
  return outcome_of(bench::Exercise::limits, reversed, scenario, look, queue_length, stall_seed);
}

MakeExercise sine_of_canard_4(double frequency_hz) {
  return [frequency_hz](const bench::Bounds& bounds) {
    return bench::Exercise::sine(
        bounds, 3, {.amplitude_rad = 3.0 * sim::radians_per_degree, .frequency_hz = frequency_hz, .cycles = 20});
  };
}

/// Of canard 4 alone, with a queue that loses nothing.
void expect_no_wrong_verdict(const char* what, const MakeExercise& make, const Fault& fault, int fast_enough_ms) {
  for (const int look_ms : {1, 10, 20, 30, 50, 70, 200}) {
    const Outcome healthy = outcome_of(make, fault, "bench_healthy", look_ms * millisecond, linux_queue);
    const Outcome bad = outcome_of(make, fault, "bench_canard4_slow", look_ms * millisecond, linux_queue);
    std::printf("%s, looks %3d ms apart: healthy canard: %s; slow canard: %s\n", what, look_ms, name(healthy),
                name(bad));
    EXPECT_TRUE(healthy == Outcome::passed || healthy == Outcome::void_sheet) << what << ", " << look_ms << " ms";
    EXPECT_TRUE(bad == Outcome::found || bad == Outcome::void_sheet) << what << ", " << look_ms << " ms";
    if (look_ms <= fast_enough_ms) {
      EXPECT_EQ(healthy, Outcome::passed) << what << ", " << look_ms << " ms: fast enough is to be of use";
      EXPECT_EQ(bad, Outcome::found) << what << ", " << look_ms << " ms";
    }
  }
}

TEST(SlowPc, NeverJudgesACanardByASineThatDidNotReachTheRocketAsAskedFor) {
  for (const auto& [frequency_hz, fast_enough_ms] : {std::pair{4.0, 30}, {8.0, 20}}) {
    expect_no_wrong_verdict(fmt::format("sine of {} Hz", frequency_hz).c_str(), sine_of_canard_4(frequency_hz),
                            slow_in_a_sine, fast_enough_ms);
  }
}

// A step is one change, and held for longer than a PC may be late: a staircase it is never.
TEST(SlowPc, SeesByAStepOrByTheLimitsThatACanardIsSlow) {
  expect_no_wrong_verdict(
      "step",
      [](const bench::Bounds& bounds) { return bench::Exercise::step(bounds, 3, 5.0 * sim::radians_per_degree); }, slow,
      50);
  expect_no_wrong_verdict(
      "limits", [](const bench::Bounds& bounds) { return bench::Exercise::limits_of(bounds, 3); }, slow, 50);
}

TEST(SlowPc, NeverAccusesACanardAndNeverClearsABadOne) {
  for (const int look_ms : {1, 5, 10, 15, 20, 30, 50, 70, 90, 200}) {
    for (const std::size_t queue : {linux_queue, short_queue}) {
      const Outcome healthy = limits("bench_healthy", look_ms * millisecond, queue);
      const Outcome bad = limits("bench_canard3_reversed", look_ms * millisecond, queue);
      std::printf("looks %3d ms apart, queue of %5zu frames: healthy rocket: %s; canard 3 reversed: %s\n", look_ms,
                  queue, name(healthy), name(bad));
      EXPECT_TRUE(healthy == Outcome::passed || healthy == Outcome::void_sheet) << look_ms << " ms, " << queue;
      EXPECT_TRUE(bad == Outcome::found || bad == Outcome::void_sheet) << look_ms << " ms, " << queue;
      if (look_ms <= 15) {
        EXPECT_EQ(healthy, Outcome::passed) << "a PC that is fast enough is to be of use";
        EXPECT_EQ(bad, Outcome::found);
      }
    }
  }
}

// Ten stalls of 61 to 75 ms at random instants, as on a PC with other work: what was read is as good as ever.
TEST(SlowPc, AFewStallsChangeNoVerdict) {
  constexpr std::uint32_t leaves_twenty_readings_of_a_rest = 143'828'599;
  const std::uint32_t first = test::seed();
  for (std::uint32_t i = 0; i < 9; ++i) {
    const std::uint32_t drawn = first + i == 0 ? 1 : first + i;
    const std::uint32_t seed = i == 8 ? leaves_twenty_readings_of_a_rest : drawn;
    const Outcome healthy = limits("bench_healthy", 2 * millisecond, linux_queue, seed);
    const Outcome bad = limits("bench_canard3_reversed", 2 * millisecond, linux_queue, seed);
    EXPECT_TRUE(healthy == Outcome::passed || healthy == Outcome::void_sheet) << seed;
    EXPECT_TRUE(bad == Outcome::found || bad == Outcome::void_sheet) << seed;
    std::printf("ten stalls, seed %u: healthy rocket: %s; canard 3 reversed: %s\n", seed, name(healthy), name(bad));
  }
}

TEST(SlowPc, StallsWithinASineChangeNoVerdict) {
  const std::uint32_t first = test::seed();
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t seed = first + i == 0 ? 1 : first + i;
    const auto outcome = [&](const char* scenario) {
      return outcome_of(sine_of_canard_4(8.0), slow_in_a_sine, scenario, 2 * millisecond, linux_queue, seed);
    };
    const Outcome healthy = outcome("bench_healthy");
    const Outcome bad = outcome("bench_canard4_slow");
    EXPECT_TRUE(healthy == Outcome::passed || healthy == Outcome::void_sheet) << seed;
    EXPECT_TRUE(bad == Outcome::found || bad == Outcome::void_sheet) << seed;
    std::printf("stalls in a sine, seed %u: healthy canard: %s; slow canard: %s\n", seed, name(healthy), name(bad));
  }
}

}  // namespace
}  // namespace fantail::sil
