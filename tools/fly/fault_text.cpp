// SPDX-License-Identifier: MIT
#include <cmath>
#include <string_view>
#include <variant>

#include <fmt/core.h>

#include "fly/describe.hpp"
#include "input/fault_file.hpp"
#include "sim/units.hpp"

namespace fantail::fly {
namespace {

std::string_view zero_of(const sim::Scenario& scenario) {
  return scenario.surroundings != sim::Surroundings::flight ? "the start command" : "ignition";
}

/// "from power-up to 3 s after ignition"
std::string time_text(const sim::Fault& fault, const sim::Scenario& scenario, std::string_view zero) {
  const bool always = fault.from_s <= -scenario.pad_time_s;
  const std::string from = always ? "power-up" : fmt::format("{:g}", fault.from_s);
  if (fault.until_s) {
    return fmt::format("from {} to {:g} s after {}", from, *fault.until_s, zero);
  }
  return always ? "from power-up" : fmt::format("from {} s after {}", from, zero);
}

std::string reset_text(const sim::Fault& fault, const sim::Reset& reset, std::string_view zero) {
  const std::string clock_error =
      reset.clock_error_s == 0.0 ? ""
                                 : fmt::format("; the avionics measure it {:g} s {}", std::abs(reset.clock_error_s),
                                               reset.clock_error_s > 0.0 ? "longer" : "shorter");
  return fmt::format("Fault: reset ({}) at {:g} s after {}; no tick for {:g} s, backup memory {}{}.",
                     hal::name(reset.cause), fault.from_s, zero, reset.gap_s,
                     reset.memory == sim::MemoryAfterReset::kept ? "kept" : "lost", clock_error);
}

/// Of a fault by device and behaviour.
std::string device_text(const sim::Fault& fault, std::string_view behaviour, const std::string& time) {
  const std::string whose = sim::is_of_canard(fault.device) ? fmt::format(" of canard {}", fault.canard + 1) : "";
  const auto* delayed = std::get_if<sim::Delayed>(&fault.how);
  const std::string late = delayed == nullptr ? "" : fmt::format(" by {:g} s", delayed->delay_s);
  const std::string again =
      fault.on_s > 0.0 ? fmt::format(", again and again for {:g} s with {:g} s between", fault.on_s, fault.off_s) : "";
  return fmt::format("Fault: {}{}: {}{}, {}{}.", input::name(fault.device), whose, behaviour, late, time, again);
}

/// The number of a fault that has one.
std::string number_text(const sim::Fault& fault) {
  if (const auto* offset = std::get_if<sim::RateOffset>(&fault.how)) {
    return fmt::format(", {:g} deg/s,", offset->rate_rad_s / sim::radians_per_degree);
  }
  if (const auto* noisy = std::get_if<sim::Noisy>(&fault.how)) {
    return fmt::format(", standard deviation {:g} counts", noisy->noise_counts);
  }
  const auto* gear = std::get_if<sim::GearFault>(&fault.how);
  if (gear == nullptr || !gear->angle_rad) {
    return "";
  }
  const double angle_deg = *gear->angle_rad / sim::radians_per_degree;
  return gear->fault == sim::ServoFault::stuck ? fmt::format(", jammed at {:g} degrees", angle_deg)
                                               : fmt::format(", {:g} degrees off", angle_deg);
}

}  // namespace

std::string fault_text(const sim::Fault& fault, const sim::Scenario& scenario) {
  const std::string_view zero = zero_of(scenario);
  if (const auto* reset = std::get_if<sim::Reset>(&fault.how)) {
    return reset_text(fault, *reset, zero);
  }
  const input::FaultWords& words = input::words_of(fault);
  const std::string time = time_text(fault, scenario, zero);
  if (!words.behaviour.empty()) {
    return device_text(fault, words.behaviour, time);
  }
  if (sim::is_of_canard(fault.device)) {
    return fmt::format("Fault: {}, canard {}{}, {}.", words.kind, fault.canard + 1, number_text(fault), time);
  }
  return fmt::format("Fault: {}{} {}.", words.kind, number_text(fault), time);
}

std::string never_happened(const sim::Scenario& scenario, double end_s) {
  std::string all;
  for (const sim::Fault& fault : scenario.faults) {
    if (fault.from_s > end_s) {
      all += fmt::format("{}The fault from {:g} s after {} on never happened: the flight ended at {:.2f} s.",
                         all.empty() ? "" : " ", fault.from_s, zero_of(scenario), end_s);
    }
  }
  return all;
}

}  // namespace fantail::fly
