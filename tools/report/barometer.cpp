// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include "report/verdict_parts.hpp"
#include "text/number.hpp"

// What a barometer that the plan fuses did for height and vertical speed.
namespace fantail::report {
namespace {

using core::BarometerState;
using flight::BarometerSpell;

std::string_view why_not_used(BarometerState state) {
  switch (state) {
    case BarometerState::silent: return "it gave no usable pressure, in flight or before it";
    case BarometerState::on_pad: return "it had not agreed with the accelerometer for half a second yet";
    case BarometerState::too_fast: return "the rocket was too fast, or had been half a second before";
    case BarometerState::disagrees: return "it disagreed with the accelerometer, or had disagreed half a second before";
    case BarometerState::alone: return "no accelerometer measured the flight";
    case BarometerState::used: break;
  }
  return "unknown";
}

/// "from 3.10 s to 17.30 s"; of more spells than one "for 12.10 s in all, between 3.10 s and 17.30 s".
std::string when(const std::vector<BarometerSpell>& all, BarometerState state) {
  double sum_s = 0.0;
  std::vector<BarometerSpell> own;
  std::ranges::copy_if(all, std::back_inserter(own), [state](const auto& spell) { return spell.state == state; });
  for (const BarometerSpell& spell : own) {
    sum_s += spell.to_s - spell.from_s;
  }
  const std::string from = text::fixed(own.front().from_s, 2);
  const std::string to = text::fixed(own.back().to_s, 2);
  return own.size() == 1 ? fmt::format("from {} s to {} s", from, to)
                         : fmt::format("for {} s in all, between {} s and {} s", text::fixed(sum_s, 2), from, to);
}

}  // namespace

std::string barometer_sentences(const flight::Flight& flight) {
  const std::vector<BarometerSpell>& all = flight.barometer_spells;
  if (all.empty() || flight.tunnel) {
    return {};
  }
  std::vector<BarometerState> states;
  for (const BarometerSpell& spell : all) {
    if (std::ranges::find(states, spell.state) == states.end()) {
      states.push_back(spell.state);
    }
  }
  const bool is_used = std::ranges::find(states, BarometerState::used) != states.end();
  std::string text = is_used ? fmt::format("The barometer was used {}.", when(all, BarometerState::used))
                             : "The barometer that the plan asks for was not used in flight.";
  for (const BarometerState state : states) {
    if (state != BarometerState::used) {
      text += fmt::format(" It was not used {}: {}.", when(all, state), why_not_used(state));
    }
  }
  return text;
}

}  // namespace fantail::report
