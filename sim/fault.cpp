// SPDX-License-Identifier: MIT
#include "sim/fault.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/document.hpp"
#include "sim/input_error.hpp"
#include "sim/servo.hpp"
#include "sim/shown.hpp"
#include "sim/units.hpp"

namespace fantail::sim {
namespace {

// In the order of FaultKind.
constexpr std::array<std::string_view, 11> fault_kinds{
    "canard_stuck",      "canard_hardover",   "canard_dead",   "canard_slipping", "canard_reversed",      "canard_slow",
    "canard_wrong_trim", "encoder_unplugged", "encoder_noisy", "imu_dropout",     "accelerometer_dropout"};

std::optional<double> read_stuck_angle(Section& section, double servo_stop_rad) {
  if (!section.has("angle_deg")) {
    return std::nullopt;
  }
  const double angle_deg = section.number("angle_deg", {-90, 90});
  if (std::abs(radians_per_degree * angle_deg) > servo_stop_rad) {
    section.refuse("angle_deg", "= " + shown(angle_deg) + "; allowed: within the servo's stop, " +
                                    about(servo_stop_rad / radians_per_degree) + " either way");
  }
  return radians_per_degree * angle_deg;
}

double read_trim_error(Section& section) {
  const double angle_deg = section.number("angle_deg", {-15, 15}, usual_wrong_trim_rad / radians_per_degree);
  if (angle_deg == 0.0) {
    section.refuse("angle_deg", "= 0; allowed: -15 to 15, but not 0");
  }
  return radians_per_degree * angle_deg;
}

Fault read_fault(Section& section, double servo_stop_rad) {
  Fault fault{};
  fault.kind = static_cast<FaultKind>(section.choice("kind", fault_kinds));
  fault.from_s = section.number("from_s", {-600, 600});
  if (is_dropout(fault.kind)) {
    fault.until_s = section.number("until_s", {fault.from_s, 600});
  } else {
    fault.canard = static_cast<std::size_t>(section.integer("canard", {1, 4}) - 1);
  }
  if (fault.kind == FaultKind::canard_stuck) {
    fault.angle_rad = read_stuck_angle(section, servo_stop_rad);
  } else if (fault.kind == FaultKind::canard_wrong_trim) {
    fault.angle_rad = read_trim_error(section);
  } else if (fault.kind == FaultKind::encoder_noisy) {
    fault.noise_counts = section.number("noise_counts", {1, 1000}, fault.noise_counts);
  }
  section.finish();
  return fault;
}

}  // namespace

std::string_view name(FaultKind kind) { return fault_kinds[static_cast<std::size_t>(kind)]; }

std::vector<Fault> read_faults(const Document& document, double servo_stop_rad) {
  std::vector<Fault> faults;
  const TomlNode node = document.root()["faults"];
  if (!node) {
    return faults;
  }
  const auto elements = node.elements();
  if (!elements || elements->empty() || !std::ranges::all_of(*elements, &TomlNode::is_table)) {
    throw InputError{InputFault::bad_configuration,
                     document.where("", "faults", node) + ": faults must be written as [[faults]]"};
  }
  for (const TomlNode element : *elements) {
    Section section{document, "faults", element};
    faults.push_back(read_fault(section, servo_stop_rad));
  }
  return faults;
}

}  // namespace fantail::sim
