// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "input/field.hpp"
#include "sim/fault.hpp"
#include "sim/vehicle.hpp"

namespace fantail::input {

/// What a kind of fault is called in scenario files, and what is broken then.
struct FaultText {
  std::string_view name;
  std::string_view meaning;
};

/// In the order of FaultKind.
[[nodiscard]] std::span<const FaultText> fault_texts();
[[nodiscard]] inline std::string_view name(sim::FaultKind kind) {
  return fault_texts()[static_cast<std::size_t>(kind)].name;
}

/// As scenario files call them.
[[nodiscard]] std::string_view name(sim::Device device);
[[nodiscard]] std::string_view name(sim::Behaviour behaviour);

/// A key of [[faults]], and the kinds that have it.
struct FaultField {
  Field<sim::Fault> field;
  bool (*belongs_to)(sim::FaultKind);
};

/// Everything that one of the [[faults]] may say. A key may stand here twice, for different kinds.
[[nodiscard]] std::span<const FaultField> fault_fields();

/// A fault of which nothing but the kind is known.
[[nodiscard]] sim::Fault usual_fault(sim::FaultKind kind);

/// The [[faults]] of a scenario file, for this vehicle. Throws text::Error.
[[nodiscard]] std::vector<sim::Fault> read_faults(const Document& document, const sim::Vehicle& vehicle);

}  // namespace fantail::input
