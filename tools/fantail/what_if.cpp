// SPDX-License-Identifier: MIT
#include "fantail/what_if.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/tick_record.hpp"
#include "flight_log/to_report.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

using text::degrees;

double command_rad(const core::TickRecord& record) { return static_cast<double>(record.command.radians()); }

// Of the ticks under control.
struct Saturation {
  std::size_t control = 0;
  std::size_t saturated = 0;
  void note(const core::TickRecord& record) {
    control += record.phase == core::Phase::controlling ? 1 : 0;
    saturated += record.saturated ? 1 : 0;
  }
  [[nodiscard]] double share() const {
    return control == 0 ? 0.0 : static_cast<double>(saturated) / static_cast<double>(control);
  }
};

void note_difference(WhatIf& result, double time_s, const core::TickRecord& flown, const core::TickRecord& other) {
  const double difference_rad = std::abs(command_rad(other) - command_rad(flown));
  if (difference_rad == 0.0 && flown.phase == other.phase) {
    return;
  }
  result.differing += 1;
  result.first_difference_s = result.first_difference_s.value_or(time_s);
  if (difference_rad > result.largest_difference_rad) {
    result.largest_difference_rad = difference_rad;
    result.largest_difference_s = time_s;
  }
}

}  // namespace

WhatIf what_if(const flight_log::Flight& flight, const flight_log::Regeneration& flown,
               const flight_log::Regeneration& changed) {
  WhatIf result;
  const core::Microseconds zero = flight_log::time_zero(flight, flown);
  result.clock = flight_log::time_zero_text(flight, flown);
  Saturation before;
  Saturation after;
  for (std::size_t i = 0; i < flight.ticks.size(); ++i) {
    const auto& was = flown.records[i];
    const auto& would = changed.records[i];
    if (!was || !would) {
      result.unreachable += 1;
      continue;
    }
    const double time_s = static_cast<double>((flight.ticks[i].tick.time - zero).count()) / 1e6;
    result.time_s.push_back(time_s);
    result.flown_rad.push_back(command_rad(*was));
    result.what_if_rad.push_back(command_rad(*would));
    result.offset_estimate_rad.push_back(static_cast<double>(would->offset_estimate.radians()));
    result.roll_angle_rad.push_back(static_cast<double>(would->motion.roll_angle.radians()));
    result.flown_phase.push_back(was->phase);
    result.what_if_phase.push_back(would->phase);
    before.note(*was);
    after.note(*would);
    note_difference(result, time_s, *was, *would);
  }
  result.flown_saturated = before.share();
  result.what_if_saturated = after.share();
  return result;
}

std::string what_if_text(const WhatIf& result) {
  std::string text = fmt::format("WHAT IF, open loop: {}\n", fmt::join(result.changes, ", "));
  if (!result.first_difference_s) {
    text += "  every roll command would have been the same\n";
  } else {
    text +=
        fmt::format("  ticks with another roll command or phase  {} of {}\n", result.differing, result.time_s.size());
    text += fmt::format("  first                                     {:.3f} s from {}\n", *result.first_difference_s,
                        result.clock);
    text += fmt::format("  largest difference                        {:.3f} deg at {:.3f} s\n",
                        degrees(result.largest_difference_rad), result.largest_difference_s);
    text += fmt::format("  saturated while controlling               {:.1f} % flown, {:.1f} % what if\n",
                        100.0 * result.flown_saturated, 100.0 * result.what_if_saturated);
  }
  text += fmt::format("\n{}\n", open_loop_sentence);
  return result.rejects_offset ? text + winding_sentence + "\n" : text;
}

std::string what_if_csv(const WhatIf& result) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text),
                 "time_s,flown_phase,flown_command_deg,what_if_phase,what_if_command_deg,what_if_roll_angle_deg,"
                 "what_if_offset_estimate_deg\n");
  for (std::size_t i = 0; i < result.time_s.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", text::fixed(result.time_s[i], 6),
                   name(result.flown_phase[i]), text::fixed(degrees(result.flown_rad[i]), 6),
                   name(result.what_if_phase[i]), text::fixed(degrees(result.what_if_rad[i]), 6),
                   text::fixed(degrees(result.roll_angle_rad[i]), 6),
                   text::fixed(degrees(result.offset_estimate_rad[i]), 6));
  }
  return fmt::to_string(text);
}

}  // namespace fantail::tool
