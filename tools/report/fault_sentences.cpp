// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "report/verdict_parts.hpp"
#include "text/number.hpp"

namespace fantail::report {

std::string unmeasured(const flight::Flight& flight) {
  const flight::Unmeasured& u = flight.unmeasured;
  std::string text;
  if (u.silent_from_s) {
    text +=
        fmt::format(" The gyro gave no usable rate for {} s in all, first at {} s; no roll was commanded meanwhile.",
                    text::fixed(u.silent_for_s, 3), text::fixed(*u.silent_from_s, 2));
  }
  if (u.speed_bound_from_s) {
    text += fmt::format(
        " From {} s on, the avionics had only lower bounds of height and speed, because every "
        "accelerometer was at the end of its range.",
        text::fixed(*u.speed_bound_from_s, 2));
  }
  return text;
}

namespace {

std::string until_when(const flight::Outage& outage) {
  return (outage.to_s ? fmt::format("to {} s", text::fixed(*outage.to_s, 3)) : "on") +
         (outage.resumed                         ? ", and then the flight was resumed"
          : outage.to_s && !outage.cause.empty() ? ", and then the flight was not resumed: the avionics were Safe"
                                                 : "");
}

}  // namespace

std::string outages(const flight::Flight& flight) {
  constexpr std::size_t most = 4;  // of which each is told
  const std::vector<flight::Outage>& all = flight.outages;
  const std::size_t told = all.size() > most ? most - 1 : all.size();
  std::string text;
  for (const flight::Outage& outage : std::span{all}.first(told)) {
    text += outage.cause.empty() ? " No" : fmt::format(" The processor was reset ({}): no", outage.cause);
    text += fmt::format(" tick is on record from {} s {}.", text::fixed(outage.from_s, 3), until_when(outage));
  }
  if (told < all.size()) {
    text += fmt::format(" That came {} more times, the last time from {} s {}.", all.size() - told,
                        text::fixed(all.back().from_s, 3), until_when(all.back()));
  }
  return text;
}

std::string canard_faults(const flight::Flight& flight) {
  std::string text;
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    std::vector<flight::CanardVerdictChange> changes;
    std::ranges::copy_if(flight.canard_verdict_changes, std::back_inserter(changes),
                         [canard](const auto& change) { return change.canard == canard; });
    const auto healthy = [](const auto& change) { return change.verdict == core::CanardVerdict::healthy; };
    changes.erase(changes.begin(), std::ranges::find_if_not(changes, healthy));
    if (changes.empty()) {
      continue;
    }
    std::vector<std::string_view> verdicts;
    for (const auto& change : changes) {
      const std::string_view name = core::name(change.verdict);
      if (!healthy(change) && std::ranges::find(verdicts, name) == verdicts.end()) {
        verdicts.push_back(name);
      }
    }
    const bool ends_healthy = healthy(changes.back());
    const bool recovers = std::ranges::count_if(changes, healthy) > (ends_healthy ? 1 : 0);
    text += fmt::format(" Canard {} {} from {} s to {}{}{}.", canard + 1, fmt::join(verdicts, ", "),
                        text::fixed(changes[0].time_s, 2),
                        ends_healthy ? text::fixed(changes.back().time_s, 2) + " s" : "the end",
                        recovers ? ", healthy in between" : "", ends_healthy ? ", then healthy" : "");
  }
  return text;
}

std::string not_following(const flight::Flight& flight) {
  std::array<bool, core::canard_count> is_off{};
  for (const auto& [time_s, canard, verdict] : flight.canard_verdict_changes) {
    if (time_s <= flight.events.control_end_s.value_or(time_s)) {
      is_off[canard] = verdict == core::CanardVerdict::stalled || verdict == core::CanardVerdict::slipping ||
                       (is_off[canard] && verdict != core::CanardVerdict::healthy);
    }
  }
  std::string text;
  std::size_t count = 0;
  for (std::size_t i = 0; i < is_off.size(); ++i) {
    if (is_off[i]) {
      text += fmt::format("{}{}", count++ == 0 ? "" : ", ", i + 1);
    }
  }
  if (count > 1) {
    return fmt::format("canards {} do not follow their commands", text);
  }
  return count == 1 ? fmt::format("canard {} does not follow its command", text) : text;
}

}  // namespace fantail::report
