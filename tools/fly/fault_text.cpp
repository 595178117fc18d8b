// SPDX-License-Identifier: MIT
#include "fly/fault_text.hpp"

#include <cmath>
#include <string_view>

#include <fmt/core.h>

#include "input/fault_file.hpp"
#include "sim/units.hpp"

namespace fantail::fly {
namespace {

std::string clock_error(const sim::Reset& reset) {
  return reset.clock_error_s == 0.0
             ? ""
             : fmt::format("; the avionics takes it for {:g} s {}", std::abs(reset.clock_error_s),
                           reset.clock_error_s > 0.0 ? "longer" : "shorter");
}

std::string device_text(const sim::Fault& fault, std::string_view zero, bool always) {
  const sim::Misbehaviour& how = fault.misbehaviour;
  const std::string whose = sim::is_of_canard(how.device) ? fmt::format(" of canard {}", fault.canard + 1) : "";
  const std::string late =
      how.behaviour == sim::Behaviour::delayed ? fmt::format(" by {:g} s", how.delay_s) : std::string{};
  const std::string again = how.on_s > 0.0
                                ? fmt::format(", again and again for {:g} s with {:g} s between", how.on_s, how.off_s)
                                : std::string{};
  return fmt::format("Fault: {}{}: {}{}, from {} to {:g} s after {}{}.", input::name(how.device), whose,
                     input::name(how.behaviour), late,
                     always ? std::string{"power-up"} : fmt::format("{:g}", fault.from_s), fault.until_s, zero, again);
}

}  // namespace

std::string fault_text(const sim::Fault& fault, const sim::Scenario& scenario) {
  const std::string_view zero = scenario.surroundings != sim::Surroundings::flight ? "the start command" : "ignition";
  const std::string_view kind = input::name(fault.kind);
  const bool always = fault.from_s <= -scenario.pad_time_s;
  if (sim::is_of_device(fault.kind)) {
    return device_text(fault, zero, always);
  }
  if (sim::is_of_sensor(fault.kind)) {
    const std::string from = always ? "power-up" : fmt::format("{:g}", fault.from_s);
    const std::string offset = sim::is_offset(fault.kind)
                                   ? fmt::format(", {:g} deg/s,", fault.rate_offset_rad_s / sim::radians_per_degree)
                                   : "";
    return fmt::format("Fault: {}{} from {} to {:g} s after {}.", kind, offset, from, fault.until_s, zero);
  }
  if (sim::is_reset(fault.kind)) {
    return fmt::format("Fault: {} ({}) at {:g} s after {}; no tick for {:g} s, backup memory {}{}.", kind,
                       hal::name(fault.reset.cause), fault.from_s, zero, fault.reset.gap_s,
                       fault.reset.memory == sim::MemoryAfterReset::kept ? "kept" : "lost", clock_error(fault.reset));
  }
  std::string number;
  if (fault.angle_rad) {
    const double angle_deg = *fault.angle_rad / sim::radians_per_degree;
    number = fault.kind == sim::FaultKind::canard_stuck ? fmt::format(", jammed at {:g} degrees", angle_deg)
                                                        : fmt::format(", {:g} degrees off", angle_deg);
  } else if (fault.kind == sim::FaultKind::encoder_noisy) {
    number = fmt::format(", standard deviation {:g} counts", fault.noise_counts);
  }
  const std::string from = always ? "power-up" : fmt::format("{:g} s after {}", fault.from_s, zero);
  return fmt::format("Fault: {}, canard {}{}, from {}.", kind, fault.canard + 1, number, from);
}

}  // namespace fantail::fly
