// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "telemetry/receiver.hpp"

namespace fantail::telemetry {

/// What a person or a script is shown of a sender, made once a look. Angles in degrees.
class Panel {
 public:
  Panel(std::string url, Receiver& receiver) : url_{std::move(url)}, receiver_{receiver} {}

  /// Takes the events and the recent figures. Call it before the others.
  void look(hal::Microseconds now);

  /// Some lines around a table of the canards; every line ends with a newline. What is old says so at its place.
  [[nodiscard]] std::string table() const;
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
  [[nodiscard]] std::string channels_text() const;

  std::string url_;
  Receiver& receiver_;
  hal::Microseconds now_{};
  std::vector<Heard<Event>> news_;          ///< since the look before
  std::deque<Heard<Event>> newest_events_;  ///< the last few
};

}  // namespace fantail::telemetry
