// SPDX-License-Identifier: MIT
#include "bench/trace.hpp"

#include <algorithm>
#include <cmath>

#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

const double same_command_rad = text::radians(0.015);  // one step of the bus, and a little
constexpr std::size_t time_to_settle = 180;

Window window_of(const CanardTrace& trace, Part part) {
  const auto first = std::ranges::find(trace.part, part);
  const auto end = std::find_if(first, trace.part.end(), [part](Part other) { return other != part; });
  return {static_cast<std::size_t>(first - trace.part.begin()), static_cast<std::size_t>(end - trace.part.begin())};
}

}  // namespace

CanardTrace trace_of(const link::Recording& recording, const Exercise& exercise, const Turn& turn, std::size_t canard) {
  CanardTrace result;
  for (const link::Tick& tick : recording.ticks()) {
    if (tick.stretch < turn.first || tick.stretch > turn.last) {
      continue;
    }
    const std::optional<double>& command = tick.command_rad[canard];
    const std::optional<double>& encoder = tick.encoder_rad[canard];
    if (result.received == 0) {
      result.first_tick = tick.number;
    }
    ++result.received;
    result.dropouts += encoder ? 0 : 1;
    result.undriven += command ? 0 : 1;

    const auto place = static_cast<std::size_t>(tick.number - result.first_tick);
    const double last_command = result.command_rad.empty() ? no_reading : result.command_rad.back();
    const Part last_part = result.part.empty() ? Part::settle : result.part.back();
    const bool last_limited = !result.limited.empty() && result.limited.back();
    result.command_rad.resize(place, last_command);
    result.encoder_rad.resize(place, no_reading);
    result.part.resize(place, last_part);
    result.limited.resize(place, last_limited);

    result.command_rad.push_back(command.value_or(last_command));
    result.encoder_rad.push_back(encoder.value_or(no_reading));
    result.part.push_back(exercise.stretches()[tick.stretch].part);
    result.limited.push_back(tick.limited[canard]);
  }
  const auto known = std::ranges::find_if(result.command_rad, [](double value) { return std::isfinite(value); });
  if (known == result.command_rad.end()) {
    CanardTrace never_driven;
    never_driven.received = result.received;
    never_driven.dropouts = result.dropouts;
    never_driven.undriven = result.undriven;
    return never_driven;
  }
  std::fill(result.command_rad.begin(), known, *known);
  return result;
}

Window at_rest(const CanardTrace& trace, Part part) {
  const Window all = window_of(trace, part);
  const std::size_t first = all.begin > time_to_settle ? all.begin - time_to_settle : 0;
  std::size_t since = first;  // the command has stood
  Window longest{all.end, all.end};
  for (std::size_t i = first; i < all.end; ++i) {
    if (std::abs(trace.command_rad[i] - trace.command_rad[since]) > same_command_rad) {
      since = i;
    }
    const std::size_t rest = std::max(since + time_to_settle, all.begin);
    if (i >= rest && i + 1 - rest > longest.size()) {
      longest = {rest, i + 1};
    }
  }
  return longest;
}

std::size_t step_begin(const CanardTrace& trace, Part part) {
  const Window all = window_of(trace, part);
  const std::size_t first = all.begin > mark_slack ? all.begin - mark_slack : 1;
  std::size_t largest = trace.size();
  double change = same_command_rad;
  for (std::size_t i = std::max<std::size_t>(first, 1); i < all.end; ++i) {
    if (const double here = std::abs(trace.command_rad[i] - trace.command_rad[i - 1]); here > change) {
      change = here;
      largest = i;
    }
  }
  return largest;
}

Window while_command_stands(const CanardTrace& trace, std::size_t begin) {
  std::size_t end = begin;
  while (end < trace.size() && std::abs(trace.command_rad[end] - trace.command_rad[begin]) <= same_command_rad) {
    ++end;
  }
  return {begin, end};
}

}  // namespace fantail::bench
