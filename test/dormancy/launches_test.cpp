// SPDX-License-Identifier: MIT
// Drawn rockets, launched through the flight law: when each gate opens, held against the truth; and whether a canard
// has left its trim before. Each rocket flies ten times. FANTAIL_LAUNCHES says how many launches; ./dev soak asks for 1
// 000 000 of each test.
#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "distributions/shares.hpp"
#include "dormancy/launch.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::dormancy {
namespace {

constexpr std::array<const char*, gates.size()> gate_names{"burn-out", "max-Q", "height"};
constexpr int launches_of_a_pad = 10;

/// Of one gate, in one kind of launches.
struct Row {
  int launches = 0;
  int never = 0;  ///< it left the guide, and its due time came
  int early = 0;
  double earliest_s = 0.0;
  std::vector<float> late_s{};

  void add(const Flown& flown, const Opening& opening) {
    ++launches;
    if (opening.is_early) {
      ++early;
      earliest_s = std::max(earliest_s, std::min(99.0, opening.due_s - *opening.opened_s));
    } else if (opening.opened_s) {
      late_s.push_back(static_cast<float>(*opening.opened_s - opening.due_s));
    } else if (flown.left_guide && opening.due_s < 1e6) {
      ++never;
    }
  }
  double quantile(double share) {
    if (late_s.empty()) {
      return 0.0;
    }
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(late_s.size() - 1));
    std::nth_element(late_s.begin(), late_s.begin() + at, late_s.end());
    return static_cast<double>(late_s[static_cast<std::size_t>(at)]);
  }
  [[nodiscard]] double most_early() const {
    return distributions::upper_bound_95(static_cast<std::uint64_t>(early), static_cast<std::uint64_t>(launches));
  }
};

struct Tally {
  std::map<std::string, std::array<Row, gates.size()>> rows{};
  int launches = 0;
  int undetected = 0;
  int off_trim = 0;
  int control_without = 0;
  int second_burns = 0;
  int reopened_early = 0;
  double longest_open_s = 0.0;

  void add(const std::string& kind, const Flown& flown) {
    for (std::size_t i = 0; i < gates.size(); ++i) {
      rows[kind][i].add(flown, flown.openings[i]);
    }
    ++launches;
    undetected += flown.left_guide ? 0 : 1;
    off_trim += flown.off_trim;
    control_without += flown.control_without;
    reopened_early += flown.reopened_early ? 1 : 0;
    longest_open_s = std::max(longest_open_s, flown.closed_after_s.value_or(0.0));
  }
  void print() {
    std::printf("%-26s %-9s %8s %6s %11s %7s %7s %7s %7s %6s\n", "kind", "gate", "launches", "early", "at most", "by s",
                "p50 s", "p95 s", "p99 s", "never");
    for (auto& [kind, of_kind] : rows) {
      for (std::size_t i = 0; i < gates.size(); ++i) {
        Row& row = of_kind[i];
        std::printf("%-26s %-9s %8d %6d %11.2e %7.3f %7.3f %7.3f %7.3f %6d\n", kind.c_str(), gate_names[i],
                    row.launches, row.early, row.most_early(), row.earliest_s, row.quantile(0.5), row.quantile(0.95),
                    row.quantile(0.99), row.never);
      }
    }
    std::printf("launches %d, not seen to leave the guide %d, ticks off trim before the gate %d, under control %d\n",
                launches, undetected, off_trim, control_without);
    std::printf("second burns: reopened early %d, longest open %.3f s\n", reopened_early, longest_open_s);
  }
};

Story draw_story(const Rocket& rocket, core::RandomStream& random) {
  if (rocket.second > 0.0) {
    return Story::second_burn;
  }
  return rocket.motor.family() == Family::unlisted_tail || random.chance(0.6)
             ? Story::plain
             : static_cast<Story>(random.whole(1, stories - 2));
}

/// Whether the thrust pauses for so long that the burn clock has run out in the pause.
bool outlasts_clock(const Pad& pad, const Burn& burn) {
  const core::DormancyPlan& plan = pad.plan.dormancy;
  return Ascent{pad.planned.rocket, burn}.pause_end_s() >
         static_cast<double>(plan.burn_clock_factor * core::seconds(plan.burn_time));
}

std::string kind(const Pad& pad, const Burn& burn) {
  if (pad.planned.rocket.motor.family() == Family::unlisted_tail) {
    return "tail not in the curve";
  }
  if (burn.story == Story::plain) {
    return "plain, " + std::string{name(pad.planned.rocket.motor.family())};
  }
  const bool pauses = burn.story == Story::relight || burn.story == Story::second_burn;
  return std::string{name(burn.story)} + (pauses && outlasts_clock(pad, burn) ? ", long pause" : "");
}

template <typename Name>
Tally launch(bool with_fault, Name name_of) {
  const std::uint32_t first = test::seed();
  const int launches = test::how_many("FANTAIL_LAUNCHES", 1000);
  Tally tally;
  for (int pads = 0; tally.launches < launches; ++pads) {
    core::RandomStream random{first + static_cast<std::uint32_t>(pads)};
    const Pad pad{random};
    for (int i = 0; i < launches_of_a_pad && tally.launches < launches; ++i) {
      const Story story = draw_story(pad.planned.rocket, random);
      const Burn burn = draw_burn(pad.planned.rocket, story, random);
      const Fault fault = with_fault ? draw_fault(burn.burn_s, random) : Fault{};
      const Flown flown = fly(pad, burn, fault, random);
      const std::string kind = name_of(pad, burn, fault);
      tally.add(kind, flown);
    }
  }
  tally.print();
  return tally;
}

/// Openings before their time in flights of a motor that burns as its published curve, and of one that never burns.
int early(const Tally& tally, std::size_t gate) {
  int count = 0;
  for (const auto& [kind, rows] : tally.rows) {
    if (kind.starts_with("plain") || kind == name(Story::misfire)) {
      count += rows[gate].early;
    }
  }
  return count;
}

TEST(DormancyLaunches, OfASoundMotorNoGateOpensBeforeItsTime) {
  const Tally tally = launch(false, [](const Pad& pad, const Burn& burn, const Fault&) { return kind(pad, burn); });
  EXPECT_EQ(tally.off_trim, 0);
  EXPECT_EQ(tally.control_without, 0);
  std::printf("sound motors: %d early by burn-out, %d by max-Q, %d by height\n", early(tally, 0), early(tally, 1),
              early(tally, 2));
  EXPECT_EQ(early(tally, 0), 0);
  EXPECT_EQ(early(tally, 2), 0);
  // Combustion of 5 Hz can take more than 2 % off the true pressure for a tenth of a second.
  EXPECT_LE(early(tally, 1), 3 + tally.launches / 2'000);
}

TEST(DormancyLaunches, WhateverFailsTheCanardsStandAtTrimBeforeTheGate) {
  const Tally tally = launch(true, [](const Pad& pad, const Burn& burn, const Fault& fault) {
    return kind(pad, burn).starts_with("plain") ? std::string{name(fault.part)} + ", " + std::string{name(fault.how)}
                                                : "other motors";
  });
  EXPECT_EQ(tally.off_trim, 0);
  EXPECT_EQ(tally.control_without, 0);
}

}  // namespace
}  // namespace fantail::dormancy
