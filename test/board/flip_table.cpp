// SPDX-License-Identifier: MIT
#include "flip_table.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <map>

#include <fmt/format.h>

namespace fantail::board {
namespace {

using Chosen = std::function<bool(const Trial&)>;

long count(std::span<const Trial> trials, const Chosen& chosen) { return std::ranges::count_if(trials, chosen); }

// What the safety case does not allow, or does not speak of.
bool is_finding(const Trial& trial, core::Phase phase) {
  const bool lost = trial.outcome == Outcome::safe && core::is_flight(phase);
  return is_beyond(trial) || lost || trial.outcome == Outcome::unnamed || trial.outcome == Outcome::stands ||
         trial.outcome == Outcome::no_end || trial.outcome == Outcome::ended_for_flight;
}

std::string by_outcome(std::span<const Trial> trials, const std::vector<std::pair<std::string, Chosen>>& columns) {
  std::string text = fmt::format("{:<30}", "");
  for (const auto& column : columns) {
    text += fmt::format(" {:>16}", column.first);
  }
  text += '\n';
  for (std::size_t i = 0; i < outcomes; ++i) {
    text += fmt::format("{:<30}", name(static_cast<Outcome>(i)));
    for (const auto& column : columns) {
      text += fmt::format(" {:>16}", count(trials, [&](const Trial& trial) {
                            return trial.outcome == static_cast<Outcome>(i) && column.second(trial);
                          }));
    }
    text += '\n';
  }
  text += fmt::format("{:<30}", "all");
  for (const auto& column : columns) {
    text += fmt::format(" {:>16}", count(trials, column.second));
  }
  return text + "\n\n";
}

std::string pins_of(std::span<const Trial> trials) {
  std::string text =
      fmt::format("{:<30} {:>8} {:>8} {:>8} {:>6} {:>6} {:>6} {:>9} {:>9} {:>9} {:>8}\n", "pulses, us; times, ms; deg",
                  "narrow", "wide", "far", "plan", "hard", "cut", "beyond", "silent", "no tick", "roll");
  for (std::size_t i = 0; i < outcomes; ++i) {
    Pins all;
    float roll_deg = 0.0F;
    float silence_ms = 0.0F;
    bool any = false;
    for (const Trial& trial : trials) {
      if (trial.outcome != static_cast<Outcome>(i) || trial.outcome == Outcome::no_end) {
        continue;
      }
      any = true;
      all.narrowest_us = std::min(all.narrowest_us, trial.pins.narrowest_us);
      all.widest_us = std::max(all.widest_us, trial.pins.widest_us);
      all.farthest_us = std::max(all.farthest_us, trial.pins.farthest_us);
      all.beyond_plan += trial.pins.beyond_plan;
      all.beyond_hard += trial.pins.beyond_hard;
      all.cut += trial.pins.cut;
      all.silence_ms = std::max(all.silence_ms, trial.pins.silence_ms);
      all.longest_beyond_ms = std::max(all.longest_beyond_ms, trial.pins.longest_beyond_ms);
      roll_deg = std::max(roll_deg, trial.roll_error_deg);
      silence_ms = std::max(silence_ms, trial.silence_ms);
    }
    if (any) {
      text +=
          fmt::format("{:<30} {:>8.1f} {:>8.1f} {:>8.1f} {:>6} {:>6} {:>6} {:>9.0f} {:>9.0f} {:>9.0f} {:>8.2f}\n",
                      name(static_cast<Outcome>(i)), all.narrowest_us, all.widest_us, all.farthest_us, all.beyond_plan,
                      all.beyond_hard, all.cut, all.longest_beyond_ms, all.silence_ms, silence_ms, roll_deg);
    }
  }
  return text + '\n';
}

std::string names_of(std::span<const Trial> trials) {
  std::map<std::string, int> known;
  for (const Trial& trial : trials) {
    if (trial.named[0] != '\0') {
      known[trial.named.data()] += 1;
    }
  }
  std::string text = "named:";
  for (const auto& [what, times] : known) {
    text += fmt::format(" {} {},", what, times);
  }
  text.back() = '\n';
  return text + '\n';
}

// A particle does not choose: what it finds in all of the RAM.
std::string of_any_bit(std::span<const Trial> trials) {
  constexpr double ram_bytes = 0x2'0000;
  std::array<double, regions> tried{};
  std::array<double, outcomes> shares{};
  for (const Trial& trial : trials) {
    tried[static_cast<std::size_t>(trial.region)] += 1.0;
  }
  for (const Trial& trial : trials) {
    shares[static_cast<std::size_t>(trial.outcome)] +=
        1e3 * trial.region_bytes / ram_bytes / tried[static_cast<std::size_t>(trial.region)];
  }
  std::string text = "of 1000 bits anywhere in the RAM:";
  for (std::size_t i = 1; i < outcomes; ++i) {
    text += shares[i] > 0.0 ? fmt::format(" {:.1f} {};", shares[i], name(static_cast<Outcome>(i))) : "";
  }
  text.back() = '\n';
  return text + '\n';
}

}  // namespace

bool is_beyond(const Trial& trial) { return trial.pins.beyond_plan > 0 || trial.pins.beyond_hard > 0; }

std::string table_of(std::span<const Trial> trials, std::span<const Moment> moments) {
  std::vector<std::pair<std::string, Chosen>> by_region;
  for (std::size_t i = 0; i < regions; ++i) {
    const auto region = static_cast<Region>(i);
    by_region.emplace_back(name(region), [=](const Trial& trial) { return trial.region == region; });
  }
  std::vector<std::pair<std::string, Chosen>> by_phase;
  for (const core::Phase phase :
       {core::Phase::armed, core::Phase::launched, core::Phase::controlling, core::Phase::finished}) {
    by_phase.emplace_back(core::name(phase), [=](const Trial& trial) { return moments[trial.moment].phase == phase; });
  }
  std::string text = by_outcome(trials, by_region) + by_outcome(trials, by_phase) + pins_of(trials) + names_of(trials) +
                     of_any_bit(trials);
  long beyond = 0;
  for (const Trial& trial : trials) {
    beyond += trial.pins.beyond_plan;
  }
  text += fmt::format("{} whole pulses beyond the plan; {} flips changed pulses and named nothing\n", beyond,
                      count(trials, [](const Trial& trial) { return trial.outcome == Outcome::unnamed; }));
  for (const Trial& trial : trials) {
    if (is_finding(trial, moments[trial.moment].phase)) {
      text += fmt::format(
          "flip {}: {}, {} {}, pc near 0x{:08x}: {}; named: {}; last reset: {}; pulses {:.1f} us off centre, beyond "
          "the "
          "plan {}, the hard limit {}; canard beyond for {:.0f} ms; roll {:.1f} deg off; {:.0f} ms without a tick; "
          "{}\n",
          trial.number, moments[trial.moment].name, trial.place.data(), trial.symbol.data(), trial.pc,
          name(trial.outcome), trial.named.data(), trial.restart.data(), trial.pins.farthest_us, trial.pins.beyond_plan,
          trial.pins.beyond_hard, trial.pins.longest_beyond_ms, trial.roll_error_deg, trial.silence_ms,
          trial.complaint.data());
    }
  }
  return text;
}

}  // namespace fantail::board
