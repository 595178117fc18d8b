// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "hil/emulator.hpp"
#include "hil/target.hpp"
#include "sim/flight_computer.hpp"

namespace fantail::tool {

/// Where the avionics runs that a world flies.
struct FlightComputerOptions {
  std::string on = "host";
  std::string image;
};

void add_flight_computer_options(const Verb& verb, FlightComputerOptions& options);

/// The avionics in this process, in an emulator, on a virtual board, or at the end of a serial line.
class FlightComputerOption {
 public:
  /// Throws hil::TargetError and text::Error.
  explicit FlightComputerOption(const FlightComputerOptions& options);

  FlightComputerOption(const FlightComputerOption&) = delete;
  FlightComputerOption& operator=(const FlightComputerOption&) = delete;
  ~FlightComputerOption();

  [[nodiscard]] sim::MakeFlightComputer maker();
  /// After the flight: what a virtual board has measured at its pins goes into this folder. Their names; none of
  /// others.
  std::vector<std::string> keep_diary(const std::filesystem::path& folder);
  /// The first thing that the firmware did and its processor or a device does not allow; empty: none. Known after
  /// keep_diary().
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  /// Where it was flown, and what was the matter; nothing about this process.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  std::string where_;
  std::filesystem::path diary_;     ///< a folder of this object; empty: no virtual board
  hil::Emulator* board_ = nullptr;  ///< of target_
  std::string complaint_;
  std::optional<hil::Target> target_;
};

}  // namespace fantail::tool
