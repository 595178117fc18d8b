// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/can_bus.hpp"
#include "json/value.hpp"
#include "link/avionics_link.hpp"
#include "protocol/bus_messages.hpp"

namespace fantail::bench {

/// The names of docs/can.md; "bit_31" for one that only newer avionics knows.
[[nodiscard]] std::vector<std::string> fault_names(std::uint32_t faults);

/// "no fault; reset by power-on, battery not measured, 0 control ticks missed"
[[nodiscard]] std::string board_text(const protocol::BoardReport& report);

/// Each fault of board, flash or stored plan that keeps the avionics from arming, with the names of docs/can.md.
[[nodiscard]] std::vector<std::string> bars_to_arming(const protocol::BoardReport& report);

/// Puts board_faults, reset_cause, battery_v, ticks_missed, plan_source and flash_failed into an object; all null when
/// the board has not reported. `plan_key`: the name of plan_source there.
void add_board(json::Value& to, const std::optional<protocol::BoardReport>& report, const char* plan_key);

/// The state of the bus and its senders, updated at every look.
class Watch {
 public:
  Watch(std::string interface, const link::AvionicsLink& link, const hal::CanBus& bus)
      : interface_{std::move(interface)}, link_{link}, bus_{bus} {}

  /// Takes the bus load since the last look. Call it before the others.
  void look(hal::Microseconds now);

  /// A table of the canards with a few lines around it; every line ends with a newline.
  [[nodiscard]] std::string table() const;
  /// The same in one line, for a pipe.
  [[nodiscard]] std::string line() const;
  /// One JSON object in one line. A value that is not known, or older than two seconds, is null.
  [[nodiscard]] std::string json() const;

 private:
  template <typename Message>
  [[nodiscard]] std::optional<Message> known() const;
  [[nodiscard]] std::string bus_text() const;
  [[nodiscard]] std::string replies_text() const;
  [[nodiscard]] std::string refused() const;

  std::string interface_;
  const link::AvionicsLink& link_;
  const hal::CanBus& bus_;
  hal::Microseconds now_{};
  hal::Microseconds last_look_{};
  std::uint64_t last_bits_ = 0;
  double load_percent_ = 0.0;
};

}  // namespace fantail::bench
