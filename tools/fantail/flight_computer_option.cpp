// SPDX-License-Identifier: MIT
#include "fantail/flight_computer_option.hpp"

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "avionics/identity.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "hil/wire.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view serial = "serial:";

std::string objection_to_place(const std::string& text) {
  const bool device = text.starts_with(serial) && text.size() > serial.size();
  return text == "host" || text == "emulator" || text == "board" || device
             ? ""
             : '"' + text + "\" is not a flight computer; allowed: host, emulator, board, serial:DEVICE";
}

hil::EmulatorOptions emulator(const FlightComputerOptions& options) {
  hil::EmulatorOptions emulator;
  emulator.image = options.image.empty() ? hil::built_image() : std::filesystem::path{options.image};
  return emulator;
}

hil::EmulatorOptions virtual_board(const FlightComputerOptions& options, const std::filesystem::path& diary) {
  hil::EmulatorOptions board;
  board.image =
      options.image.empty() ? hil::built_image("fantail-stm32f405.elf") : std::filesystem::path{options.image};
  board.program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "fantail-board";
  board.diary = diary;
  return board;
}

constexpr const char* diary_names[] = {"board_can.log", "board_complaints.txt", "board_console.txt",
                                       "board_pulses.csv"};

}  // namespace

void add_flight_computer_options(const Verb& verb, FlightComputerOptions& options) {
  verb.option(
          "--on", options.on,
          "host (in this program), emulator (an emulated Cortex-M4), board (the bytes that are flashed, on a virtual "
          "board), serial:DEVICE (a board on a serial line) [host]")
      .offers(
          [](std::string_view /*begun*/) { return manual::Offer{.words = {"host", "emulator", "board", "serial:"}}; })
      .check(objection_to_place)
      .value_name("PLACE");
  verb.option("--image", options.image,
              "The image for the emulator or the board [the one that ./dev fly --on PLACE has built, in the sources]")
      .offers(files)
      .value_name("FILE");
}

FlightComputerOption::FlightComputerOption(const FlightComputerOptions& options) {
  if (options.on == "host") {
    return;
  }
  std::unique_ptr<hil::Wire> wire;
  if (options.on == "emulator") {
    where_ = "an emulated Cortex-M4";
    wire = std::make_unique<hil::Emulator>(emulator(options));
  } else if (options.on == "board") {
    where_ = "a virtual board";
    diary_.emplace();
    auto board = std::make_unique<hil::Emulator>(virtual_board(options, diary_->folder));
    board_ = board.get();
    wire = std::move(board);
  } else {
    where_ = "the board at " + options.on.substr(serial.size());
    wire = std::make_unique<hil::SerialPort>(options.on.substr(serial.size()));
  }
  // Between two processes nothing is lost, and a slow PC may take long for a start.
  const hil::Timeouts timeouts = board_ != nullptr ? hil::Timeouts{.send_again = 60s, .give_up = 60s} : hil::Timeouts{};
  target_.emplace(std::move(wire), give_up_if_interrupted, timeouts);
}

FlightComputerOption::Diary::Diary() {
  std::error_code failed;
  std::string name = std::filesystem::temp_directory_path(failed) / "fantail-board-XXXXXX";
  if (failed || ::mkdtemp(name.data()) == nullptr) {
    throw text::OutputError{fmt::format("the folder for temporary files (TMPDIR): {}",
                                        failed ? failed.message() : std::generic_category().message(errno))};
  }
  folder = name;
}

FlightComputerOption::Diary::~Diary() {
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

void FlightComputerOption::end() {
  if (board_ != nullptr) {
    board_->end();
    std::ifstream complaints{diary_->folder / "board_complaints.txt"};
    std::getline(complaints, complaint_);
  }
}

std::vector<std::string> FlightComputerOption::keep_diary(const std::filesystem::path& folder) const {
  std::vector<std::string> names;
  for (const char* name : diary_names) {
    std::filesystem::remove(folder / name);
    if (diary_ && std::filesystem::exists(diary_->folder / name)) {
      std::filesystem::copy_file(diary_->folder / name, folder / name);
      names.emplace_back(name);
    }
  }
  return names;
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
  if (!complaint_.empty()) {
    notes.push_back("Not all was well on the board, by the time since its power-up: " + complaint_ + ".");
  }
  if (const std::uint32_t again = target_->link().asked_again(); again != 0) {
    notes.push_back(text::counted(again, "message was", "messages were") +
                    " sent again, because no answer came in time.");
  }
  return notes;
}

}  // namespace fantail::tool
