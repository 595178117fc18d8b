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

  [[nodiscard]] sim::MakeFlightComputer maker();
  /// Nobody will ask any more: a virtual board tells what was measured at its pins.
  void end();
  /// From then on: what a virtual board complains of first, a reset, or what its processor or a device does not allow;
  /// empty: nothing.
  [[nodiscard]] const std::string& complaint() const { return complaint_; }
  /// From then on: what was measured goes into this folder, instead of that of an earlier flight. Its names.
  [[nodiscard]] std::vector<std::string> keep_diary(const std::filesystem::path& folder) const;
  /// Where it was flown, and what was the matter; nothing about this process.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  std::string where_;
  /// For what was measured, until it is kept.
  struct Diary {
    Diary();
    ~Diary();
    Diary(const Diary&) = delete;
    Diary& operator=(const Diary&) = delete;
    std::filesystem::path folder;
  };
  std::optional<Diary> diary_;      ///< of a virtual board
  hil::Emulator* board_ = nullptr;  ///< of target_
  std::string complaint_;
  std::optional<hil::Target> target_;
};

}  // namespace fantail::tool
