// SPDX-License-Identifier: MIT
#include "fantail/flight_computer_option.hpp"

#include <filesystem>
#include <string_view>

#include <fmt/core.h>

#include "avionics/identity.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "hil/emulator.hpp"
#include "hil/wire.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

constexpr std::string_view serial = "serial:";

std::string objection_to_place(const std::string& text) {
  const bool device = text.starts_with(serial) && text.size() > serial.size();
  return text == "host" || text == "emulator" || device
             ? ""
             : '"' + text + "\" is not a flight computer; allowed: host, emulator, serial:DEVICE";
}

std::unique_ptr<hil::Wire> wire(const FlightComputerOptions& options) {
  if (options.on.starts_with(serial)) {
    return std::make_unique<hil::SerialPort>(options.on.substr(serial.size()));
  }
  hil::EmulatorOptions emulator;
  emulator.image = options.image.empty() ? hil::built_image() : std::filesystem::path{options.image};
  return std::make_unique<hil::Emulator>(emulator);
}

}  // namespace

void add_flight_computer_options(const Verb& verb, FlightComputerOptions& options) {
  verb.option("--on", options.on,
              "host (in this program), emulator (the ARM image on an emulated Cortex-M4), serial:DEVICE (a board on a "
              "serial line) [host]")
      .offers([](std::string_view /*begun*/) { return manual::Offer{.words = {"host", "emulator", "serial:"}}; })
      .check(objection_to_place)
      .value_name("PLACE");
  verb.option("--image", options.image,
              "The image for the emulator [the one that ./dev fly --on emulator has built, in the sources]")
      .offers(files)
      .value_name("FILE");
}

FlightComputerOption::FlightComputerOption(const FlightComputerOptions& options) {
  if (options.on == "host") {
    return;
  }
  where_ = options.on == "emulator" ? "an emulated Cortex-M4" : "the board at " + options.on.substr(serial.size());
  target_.emplace(wire(options), give_up_if_interrupted);
}

sim::MakeFlightComputer FlightComputerOption::maker() { return target_ ? target_->maker() : sim::simulated_board; }

std::vector<std::string> FlightComputerOption::notes() const {
  if (!target_) {
    return {};
  }
  const hil::TargetIdentity& identity = target_->identity();
  std::vector<std::string> notes{
      fmt::format("Flown on {}: {} {}, {}.", where_, identity.image, identity.version, identity.git_hash)};
  if (identity.git_hash != avionics::git_hash()) {
    notes.push_back(
        fmt::format("That image was built from other sources than this program, {}.", avionics::git_hash()));
  }
  if (const std::uint32_t overruns = target_->times().overruns; overruns != 0) {
    notes.push_back(text::counted(overruns, "tick") + " took the flight computer longer than a millisecond.");
  }
  if (const std::uint32_t again = target_->link().asked_again(); again != 0) {
    notes.push_back(text::counted(again, "message was", "messages were") +
                    " lost or damaged on the line, and sent again.");
  }
  return notes;
}

}  // namespace fantail::tool
