// SPDX-License-Identifier: MIT
// What the flashed image does when a device fails: from power-up on, and in a flight under control.
//
//   board_faults IMAGE TABLE [DEVICE]
//
// TABLE: device_faults.txt, which says what is to come of each; DEVICE: only the rows whose device begins so. Two rows
// at a time.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "device_trial.hpp"
#include "input/scenario_file.hpp"
#include "program.hpp"
#include "two_workers.hpp"

namespace {

using namespace fantail::board;
namespace core = fantail::core;

struct Row {
  std::size_t fault;
  DeviceTrial at_boot;
  DeviceTrial in_flight;
};

fantail::sim::Scenario with_all_sensors() {
  const std::vector<std::string> changes{"sensors.gyros=two_agree", "second_imu.fitted=yes", "sensors.barometer=fused",
                                         "barometer.fitted=yes"};
  return fantail::input::load_scenario("tasha3_launch2", fantail::input::parse_overrides(changes));
}

// It was told by a name, by a reason, or by a reset that tells why.
bool is_unnamed(const DeviceFault& fault, const DeviceTrial& trial) {
  const bool by_reason = trial.phase != core::Phase::controlling;
  return fault.is_named && trial.named[0] == '\0' && !by_reason;
}

bool is_bad(const DeviceFault& fault, const DeviceTrial& flown) {
  return !flown.came_to_an_end || flown.pins.beyond_plan > 0 || flown.pins.beyond_hard > 0 || is_unnamed(fault, flown);
}

std::string text_of(core::Phase phase, core::PhaseReason reason) {
  return std::string{core::name(phase)} + ": " + std::string{core::name(reason)};
}

void print_boot(const DeviceFault& fault, const DeviceTrial& trial) {
  const bool armed = trial.phase == core::Phase::armed;
  std::printf("| %s | %s | %s | %s | %.1f to %.1f | %d | %.0f | %d | %d | %s |\n", fault.device.c_str(),
              fault.how.c_str(),
              !trial.came_to_an_end ? "NO END"
              : armed               ? "armed"
                                    : "not armed",
              trial.named.data(), trial.pins.narrowest_us, trial.pins.widest_us, trial.pins.beyond_plan,
              trial.longest_tick_us, trial.ticks_missing, trial.restarts, armed ? "" : trial.refusal.data());
}

void print_flight(const DeviceFault& fault, const DeviceTrial& trial) {
  std::printf("| %s | %s | %s | %s | %.1f to %.1f | %d | %d, %.0f ms | %d | %.1f | %.0f | %d |%s\n",
              fault.device.c_str(), fault.how.c_str(),
              trial.came_to_an_end ? text_of(trial.phase, trial.reason).c_str() : "NO END", trial.named.data(),
              trial.pins.narrowest_us, trial.pins.widest_us, trial.pins.cut, trial.pins.beyond_plan,
              trial.pins.longest_beyond_ms, trial.restarts, trial.roll_deg, trial.longest_tick_us, trial.ticks_missing,
              is_bad(fault, trial) ? " <- BAD" : "");
}

void work(const Image& image, const std::vector<DeviceFault>& faults, const std::vector<std::size_t>& mine,
          const std::function<void(const Row&)>& tell) {
  const fantail::sim::Scenario scenarios[]{fantail::input::load_scenario("tasha3_launch2", {}), with_all_sensors()};
  std::unique_ptr<ControlledFlight> flown;
  const fantail::sim::Scenario* flies = nullptr;
  for (const std::size_t i : mine) {
    const fantail::sim::Scenario& scenario = scenarios[faults[i].needs_all_sensors ? 1 : 0];
    if (&scenario != flies) {
      flown.reset();  // the registers of a process are those of the board that was made last
      flown = std::make_unique<ControlledFlight>(image, scenario);
      flies = &scenario;
    }
    tell({.fault = i, .at_boot = boot_with(image, scenario, faults[i]), .in_flight = fly_with(*flown, faults[i])});
  }
}

std::string with_names(const std::string& what, const DeviceTrial& trial) {
  return what + (trial.named[0] == '\0' ? "" : std::string{": "} + trial.named.data());
}

// As TABLE has it: what hangs on the speed of the firmware is not in it.
std::string line_of(const DeviceFault& fault, const Row& row) {
  const DeviceTrial& boot = row.at_boot;
  const DeviceTrial& flight = row.in_flight;
  const bool goes_on = flight.phase == core::Phase::controlling;
  const std::string reset = flight.restarts > 0 ? "reset, " : "";
  return fmt::format(
      "| {} | {} | {} | {} |", fault.device, fault.how,
      with_names(boot.phase == core::Phase::armed ? "armed" : "not armed", boot),
      with_names(reset + (goes_on ? "control goes on" : fmt::format("control ends ({})", core::name(flight.reason))),
                 flight));
}

std::vector<std::string> lines_of(const std::string& table) {
  std::ifstream file{table};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    lines.push_back(line);
  }
  if (lines.empty()) {
    throw fantail::text::Error{fantail::text::ErrorKind::bad_data, table + ": there is no table"};
  }
  return lines;
}

int run(const Image& image, const std::string& table, const std::string& device) {
  const std::vector<std::string> expected = lines_of(table);
  std::vector<DeviceFault> faults = device_faults();
  std::erase_if(faults, [&](const DeviceFault& fault) { return !fault.device.starts_with(device); });
  if (faults.empty()) {
    throw fantail::text::Error{fantail::text::ErrorKind::usage, "no device of the board begins with " + device};
  }
  std::vector<Row> rows =
      by_two_workers<Row>(faults.size(), "faults", [&](int worker, const std::function<void(const Row&)>& tell) {
        std::vector<std::size_t> mine;
        for (auto i = static_cast<std::size_t>(worker); i < faults.size(); i += workers) {
          mine.push_back(i);
        }
        std::ranges::stable_sort(mine, {}, [&](std::size_t i) { return faults[i].needs_all_sensors; });
        work(image, faults, mine, tell);
      });
  std::ranges::sort(rows, {}, &Row::fault);
  std::puts(
      "From power-up on\n\n"
      "| device | fault | | named | whole pulses, us | beyond the plan | longest tick, us | ticks missing | resets "
      "| refusal |\n"
      "|---|---|---|---|---|---|---|---|---|---|");
  for (const Row& row : rows) {
    print_boot(faults[row.fault], row.at_boot);
  }
  std::puts(
      "\nFrom 0.5 s of control on, for 1.5 s\n\n"
      "| device | fault | phase | named | whole pulses, us | cut | beyond the plan | resets | roll, deg "
      "| longest tick, us | ticks missing |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|");
  bool bad = rows.size() != faults.size();
  for (const Row& row : rows) {
    print_flight(faults[row.fault], row.in_flight);
    bad = bad || is_bad(faults[row.fault], row.in_flight);
  }
  for (const Row& row : rows) {
    const std::string line = line_of(faults[row.fault], row);
    if (std::ranges::find(expected, line) == expected.end()) {
      fmt::print("not in {}:\n{}\n", table, line);
      bad = true;
    }
  }
  return bad ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(argc, argv, 2, 3, "board_faults IMAGE TABLE [DEVICE]",
                     [&] { return run(Image{argv[1]}, argv[2], argc > 3 ? argv[3] : ""); });
}
