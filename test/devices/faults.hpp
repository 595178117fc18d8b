// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "whole_board.hpp"

namespace fantail::devices {

// The words of device_faults.txt, and what they are on this board.

enum class Fault : std::uint8_t { never, late, repeats, flips, other, for_50_ms, for_2_s };

struct Device {
  void (*set)(WholeBoard&, Fault, bool on);
  std::vector<Fault> faults;  ///< that it can have
};

/// By their names in the table.
extern const std::map<std::string, Fault> faults;
extern const std::map<std::string, Device> devices;

/// Of a fault that ends by itself.
[[nodiscard]] std::optional<int> duration_ms(Fault fault);

}  // namespace fantail::devices
