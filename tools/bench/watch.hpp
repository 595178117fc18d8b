// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "hal/can_bus.hpp"
#include "link/avionics_link.hpp"

namespace fantail::bench {

/// What is known about the bus and whoever speaks on it, made once a look.
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
