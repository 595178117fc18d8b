// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "hil/target.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::tool {

/// Where the avionics runs that a world flies.
struct FlightComputerOptions {
  std::string on = "host";
  std::string image;
};

void add_flight_computer_options(const Verb& verb, FlightComputerOptions& options);

/// The avionics in this process, in an emulator, or at the end of a serial line.
class FlightComputerOption {
 public:
  /// Throws hil::TargetError and text::Error.
  explicit FlightComputerOption(const FlightComputerOptions& options);

  [[nodiscard]] sim::MakeFlightComputer maker();
  /// Where it was flown, and what was the matter; nothing about this process.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  std::string where_;
  std::optional<hil::Target> target_;
};

}  // namespace fantail::tool
