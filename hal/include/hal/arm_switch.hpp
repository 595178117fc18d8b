// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::hal {

/// The switch that a hand closes at the pad; already debounced.
class ArmSwitch {
 public:
  virtual ~ArmSwitch() = default;
  /// Open at power-up, until it has been seen closed. Never waits.
  [[nodiscard]] virtual bool closed() const = 0;
};

}  // namespace fantail::hal
