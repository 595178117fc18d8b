// SPDX-License-Identifier: MIT
#include "input/fault_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include <fmt/core.h>

#include "input/messages.hpp"
#include "text/error.hpp"

// Reads and checks the [[faults]] of a scenario file.
namespace fantail::input {
namespace {

/// How a device of the kind `device` goes wrong.
sim::How read_behaviour(Section& section, const Field<sim::Fault>& field, sim::Device device) {
  const Words words_of_file = field.allowed.words;
  const std::string_view word = words_of_file[section.choice(field.key, words_of_file)];
  std::string allowed;
  for (const FaultWords& words : device_faults()) {
    if (words.fault.device == device && words.behaviour == word) {
      return words.fault.how;
    }
    if (words.fault.device == device) {
      allowed.append(allowed.empty() ? "" : ", ").append(words.behaviour);
    }
  }
  section.refuse(field.key, fmt::format("= {}; allowed for {}: {}", word, name(device), allowed));
}

void check_angle(Section& section, const sim::GearFault& gear, double servo_stop_rad) {
  if (gear.angle_rad && std::abs(*gear.angle_rad) > servo_stop_rad) {
    section.refuse("angle_deg",
                   fmt::format("= {}; allowed: within the servo's stop, {} either way",
                               plain_number(deg.in_file(*gear.angle_rad)), about(deg.in_file(servo_stop_rad))));
  }
  if (gear.fault == sim::ServoFault::wrong_trim && *gear.angle_rad == 0.0) {
    section.refuse("angle_deg", "= 0; allowed: -15 to 15, but not 0");
  }
}

void check(Section& section, const sim::Fault& fault, const FaultWords& words, const sim::Vehicle& vehicle,
           const core::FlightPlan& plan) {
  if (fault.device == sim::Device::second_imu && !vehicle.second_imu_is_fitted) {
    const bool by_device = section.has("device");
    section.refuse(by_device ? "device" : "kind",
                   fmt::format("= {}, and the vehicle has no second IMU (second_imu.fitted)",
                               by_device ? name(fault.device) : words.kind));
  }
  if (fault.device == sim::Device::barometer && !vehicle.barometer.is_fitted) {
    section.refuse("device", "= barometer, and the vehicle has none (barometer.fitted)");
  }
  if (fault.device == sim::Device::abort_input && plan.run.abort_input == core::AbortInput::none) {
    section.refuse("device", "= abort_input, and the plan has none (run.abort_input)");
  }
  if (fault.until_s && *fault.until_s <= fault.from_s) {
    section.refuse("until_s", fmt::format("= {} is out of range; allowed: later than from_s = {}, up to 3600",
                                          plain_number(*fault.until_s), plain_number(fault.from_s)));
  }
  if (const auto* gear = std::get_if<sim::GearFault>(&fault.how)) {
    check_angle(section, *gear, vehicle.servo.stop_rad);
  }
  if (std::holds_alternative<sim::Reset>(fault.how) && fault.from_s < 0.0) {
    section.refuse("from_s", fmt::format("= {}; allowed for a reset: 0 to 3600", plain_number(fault.from_s)));
  }
  if (fault.on_s > 0.0 && fault.on_s < 0.001) {
    section.refuse("on_s", fmt::format("= {}; allowed: 0, or 0.001 to 3600", plain_number(fault.on_s)));
  }
  if (fault.off_s > 0.0 && fault.on_s == 0.0) {
    section.refuse("off_s", fmt::format("= {}; allowed without on_s: 0", plain_number(fault.off_s)));
  }
}

sim::Fault read_fault(Section& section, const sim::Vehicle& vehicle, const core::FlightPlan& plan) {
  const Field<sim::Fault>& kind = fault_fields().front().field;
  const FaultWords& words = fault_kinds()[section.choice(kind.key, kind.allowed.words)];
  sim::Fault fault = words.fault;
  for (const auto& [field, belongs_to] : fault_fields().subspan(1)) {
    if (!belongs_to(words)) {
      continue;
    }
    if (field.place.set == nullptr) {
      fault.how = read_behaviour(section, field, fault.device);
    } else {
      read_field(section, field, fault);
    }
  }
  section.finish();
  check(section, fault, words, vehicle, plan);
  return fault;
}

}  // namespace

std::vector<sim::Fault> read_faults(const Document& document, const sim::Vehicle& vehicle,
                                    const core::FlightPlan& plan) {
  std::vector<sim::Fault> faults;
  const TomlNode node = document.root()["faults"];
  if (!node) {
    return faults;
  }
  const auto elements = node.elements();
  if (!elements || elements->empty() || !std::ranges::all_of(*elements, &TomlNode::is_table)) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      document.where("", "faults", node) + ": faults must be written as [[faults]]"};
  }
  for (const TomlNode element : *elements) {
    Section section{document, "faults", element};
    faults.push_back(read_fault(section, vehicle, plan));
  }
  return faults;
}

}  // namespace fantail::input
