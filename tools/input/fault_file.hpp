// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "core/flight_plan.hpp"
#include "input/field.hpp"
#include "sim/fault.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// What a fault is called in scenario files: by a kind of its own, or as kind `device` by device and behaviour. One
/// that has an end by the one, and one that stays by the other, may be the same fault.
struct FaultWords {
  std::string_view kind;
  std::string_view behaviour;  ///< of kind device; empty: of the others, and of that kind itself
  std::string_view meaning;    ///< a clause
  sim::Fault fault;            ///< of which nothing else is known; has an end where the file has to give one
};

/// A row for each kind, and one for each device and behaviour. Each fault that can be flown is one of these.
[[nodiscard]] std::span<const FaultWords> fault_kinds();
[[nodiscard]] std::span<const FaultWords> device_faults();
[[nodiscard]] const FaultWords& words_of(const sim::Fault& fault);

/// As scenario files call it.
[[nodiscard]] std::string_view name(sim::Device device);

/// A key of [[faults]], and the kinds that have it.
struct FaultField {
  Field<sim::Fault> field;
  bool (*belongs_to)(const FaultWords&);
};

/// Everything that one of the [[faults]] may say. A key may stand here twice, for different kinds.
[[nodiscard]] std::span<const FaultField> fault_fields();

/// The [[faults]] of a scenario file, for this vehicle and plan. Throws text::Error.
[[nodiscard]] std::vector<sim::Fault> read_faults(const Document& document, const sim::Vehicle& vehicle,
                                                  const core::FlightPlan& plan);

}  // namespace fantail::input
