// SPDX-License-Identifier: MIT
// Bits of what decides about the canards flip in flight: of the flight law, its parameters included, of the plan, and
// of what watches over both. Each in a process of its own, forked from a flight at an instant drawn at random, because
// it may crash; what came of it is the child's exit code. FANTAIL_FLIPS says how many, 2000 otherwise.
#include <bit>
#include <cerrno>
#include <iostream>
#include <system_error>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "control_memory.hpp"
#include "flying_rig.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

// The one way the language has to name a private member: an explicit instantiation.
struct Target {
  std::string name;
  std::span<std::byte> bytes;
};

std::vector<Target> control_state(Avionics& avionics) {
  return {{"law", memory_of(law_in(avionics))},
          {"plan", memory_of(plan_in(avionics))},
          {"watch", memory_of(watch_in(avionics))}};
}

enum class Outcome : std::uint8_t {
  right,    // every pulse as without the flip, within 0.1 degrees
  named,    // control is over, at trim, and the board says why: memory_damaged
  neutral,  // at trim for another reason that the phase gives
  late,     // at trim until control begins, later than without the flip: the launch detector's part in flight
  verdict,  // as right or nearly so, but a canard is reported as faulty
  crash,    // on a board a hard fault: canards to trim, a reset, and the flight is resumed
  wrong,    // within the limits, and nobody knows
  beyond,   // a limit: never
};
constexpr std::array<std::string_view, 8> names{
    "right",   "named fault, at trim", "neutral",       "later control", "named canard",
    "a crash", "wrong and unnamed",    "BEYOND A LIMIT"};

constexpr Microseconds watched{1'000'000};
constexpr double right_deg = 0.1;

using Angles = std::array<double, hal::canards>;

struct Tick {
  Angles commanded_deg;
  core::Phase phase;
};

Angles commanded(const BoardRig& rig) {
  Angles angles{};
  for (std::size_t i = 0; i < hal::canards; ++i) {
    angles[i] = rig.servo.written[i] ? rig.commanded_deg(i) : std::numeric_limits<double>::quiet_NaN();
  }
  return angles;
}

Outcome judge(FlyingRig& rig, std::span<const Tick> right) {
  const double limit_deg = static_cast<double>(core::default_plan().controller.canard_limit.degrees()) + 0.001;
  bool same = true;
  bool canard = false;
  bool late = false;
  const core::TickRecord* record = nullptr;
  for (const auto& [wanted, phase] : right) {
    record = &rig.fly();
    canard = canard || !core::all_healthy(record->verdicts);
    const Angles angles = commanded(rig);
    // Only while nothing has differed before: what comes after a later beginning is control, from where the rocket is.
    late = late || (same && record->phase == core::Phase::launched && phase == core::Phase::controlling &&
                    rig.all_pulses_are(0.0));
    for (std::size_t i = 0; i < hal::canards; ++i) {
      if (std::abs(angles[i]) > limit_deg) {
        return Outcome::beyond;
      }
      same = same && !(std::abs(angles[i] - wanted[i]) > right_deg) && std::isnan(angles[i]) == std::isnan(wanted[i]);
    }
  }
  const bool at_trim = rig.all_pulses_are(0.0);
  if (at_trim && rig.console.text.find("memory_damaged") != std::string::npos) {
    return Outcome::named;
  }
  if (canard) {
    return Outcome::verdict;
  }
  if (same) {
    return Outcome::right;
  }
  if (at_trim && record->phase != core::Phase::controlling) {
    return Outcome::neutral;
  }
  return late ? Outcome::late : Outcome::wrong;
}

/// Memory that a child writes and its parent reads.
std::span<Tick> memory_for_both(std::int64_t count) {
  const auto size = static_cast<std::size_t>(count);
  void* const memory = mmap(nullptr, size * sizeof(Tick), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return {static_cast<Tick*>(memory), size};
}

/// The rest of the flight with this bit flipped, in a process of its own.
template <typename Rest>
Outcome in_a_child(Rest rest) {
  const pid_t child = fork();
  if (child == 0) {
    _exit(static_cast<int>(rest()));
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) {
    throw std::system_error(errno, std::generic_category(), "a flight in a process of its own");
  }
  return WIFEXITED(status) ? static_cast<Outcome>(WEXITSTATUS(status)) : Outcome::crash;
}

struct Campaign {
  std::mt19937 random{test::seed()};
  std::map<std::string, std::array<int, names.size()>> counts{};
  int flips = 0;

  void flip(FlyingRig& rig, std::span<const Tick> right) {
    const std::vector<Target> targets = control_state(rig.avionics());
    std::size_t bits = 0;
    for (const Target& target : targets) {
      bits += 8 * target.bytes.size();
    }
    std::size_t bit = std::uniform_int_distribution<std::size_t>{0, bits - 1}(random);
    for (const Target& target : targets) {
      if (bit < 8 * target.bytes.size()) {
        const Outcome outcome = in_a_child([&] {
          target.bytes[bit / 8] ^= std::byte{1} << (bit % 8);
          return judge(rig, right);
        });
        counts[target.name][static_cast<std::size_t>(outcome)] += 1;
        flips += 1;
        if (outcome == Outcome::wrong || outcome == Outcome::beyond || outcome == Outcome::crash) {
          std::cout << names[static_cast<std::size_t>(outcome)] << ": " << target.name << ", byte " << bit / 8
                    << " bit " << bit % 8 << " at " << rig.true_time.count() << " us\n";
        }
        return;
      }
      bit -= 8 * target.bytes.size();
    }
  }

  [[nodiscard]] int all(Outcome outcome) const {
    int sum = 0;
    for (const auto& [name, of] : counts) {
      sum += of[static_cast<std::size_t>(outcome)];
    }
    return sum;
  }
};

TEST(MemoryCampaign, AFlippedBitGivesTheRightOutputANamedFaultOrTrimAndNeverACommandBeyondALimit) {
  const int most = test::how_many("FANTAIL_FLIPS", 2000);
  constexpr int flips_an_instant = 50;
  Campaign campaign;
  const std::span<Tick> right = memory_for_both(watched / millisecond);
  while (campaign.flips < most) {
    FlyingRig rig;
    rig.disturbance_rad = std::uniform_real_distribution{-0.04, 0.04}(campaign.random);
    rig.launch();
    ASSERT_EQ(rig.fly_to(core::Phase::launched)->phase, core::Phase::launched);
    for (int instant = 0; instant < 20 && campaign.flips < most; ++instant) {
      rig.fly_for(std::uniform_int_distribution{1, 500}(campaign.random) * millisecond);
      // The flight that the others are held against is flown by a child, too.
      static_cast<void>(in_a_child([&] {
        for (Tick& tick : right) {
          const core::TickRecord& record = rig.fly();
          tick = {commanded(rig), record.phase};
        }
        return Outcome::right;
      }));
      for (int i = 0; i < flips_an_instant && campaign.flips < most; ++i) {
        campaign.flip(rig, right);
      }
    }
  }
  for (const auto& [name, of] : campaign.counts) {
    for (std::size_t i = 0; i < names.size(); ++i) {
      std::cout << name << ": " << names[i] << " " << of[i] << "\n";
    }
  }
  EXPECT_EQ(campaign.all(Outcome::beyond), 0);
  EXPECT_EQ(campaign.all(Outcome::wrong), 0);
  EXPECT_EQ(campaign.all(Outcome::crash), 0);
}

}  // namespace
}  // namespace fantail::avionics
