// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <deque>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "telemetry/receiver.hpp"
#include "text/layout.hpp"

namespace fantail::telemetry {

/// The display of a sender for a person or a script, updated at every look. Angles in degrees.
class Panel {
 public:
  Panel(std::string url, Receiver& receiver) : url_{std::move(url)}, receiver_{receiver} {}

  /// Takes the events and the recent figures. Call it before the others.
  void look(hal::Microseconds now);

  /// Some lines around a table of the canards; every line ends with a newline. For a place of so many columns. What is
  /// old says so at its place.
  [[nodiscard]] std::string table(std::size_t columns = text::any_width) const;
  /// The same in one line, for a pipe, after a line for each event since the last look.
  [[nodiscard]] std::string lines() const;
  /// One JSON object in one line. What is not known is null; what is known but old has "stale": true beside it.
  [[nodiscard]] std::string json() const;

 private:
  template <typename Content>
  [[nodiscard]] bool is_stale(const std::optional<Heard<Content>>& heard) const {
    return !heard || now_ - heard->came > Receiver::stale_after;
  }
  template <typename Content>
  [[nodiscard]] std::string age_text(const std::optional<Heard<Content>>& heard) const;
  [[nodiscard]] std::string link_state() const;
  [[nodiscard]] std::string motion_text() const;
  [[nodiscard]] std::string canards_text() const;
  [[nodiscard]] std::string health_text() const;
  [[nodiscard]] std::string channels_text(std::size_t columns) const;

  std::string url_;
  Receiver& receiver_;
  hal::Microseconds now_{};
  std::vector<Heard<Event>> news_;          ///< since the look before
  std::deque<Heard<Event>> newest_events_;  ///< the last few
};

// What the text and the JSON of the panel both need.

[[nodiscard]] inline std::optional<double> degrees(const std::optional<double>& radians) {
  return radians ? std::optional{*radians * 180.0 / std::numbers::pi} : std::nullopt;
}

[[nodiscard]] inline double in_seconds(hal::Microseconds time) { return static_cast<double>(time.count()) / 1e6; }

/// "launched -> controlling (guide_clear)", "canard 3: healthy -> stalled".
[[nodiscard]] inline std::string event_text(const Event& event) {
  if (event.phase) {
    return fmt::format("{} -> {} ({})", core::name(event.phase->before), core::name(event.phase->phase),
                       core::name(event.phase->reason));
  }
  return fmt::format("canard {}: {} -> {}", event.verdict->canard + 1, core::name(event.verdict->before),
                     core::name(event.verdict->verdict));
}

/// What has not come lately; what was missed before and came late does not make it less than none.
[[nodiscard]] inline std::int64_t lost_lately(const ChannelFigures& recent) {
  return std::max(recent.lost, std::int64_t{0});
}

}  // namespace fantail::telemetry
