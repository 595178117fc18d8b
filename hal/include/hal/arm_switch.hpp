// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::hal {

/// The switch that a hand closes at the pad; already debounced. Neither closed nor open until its contacts have settled
/// after power-up. Never waits.
class ArmSwitch {
 public:
  virtual ~ArmSwitch() = default;
  [[nodiscard]] virtual bool closed() const = 0;  ///< false while it is not known
  [[nodiscard]] virtual bool open() const = 0;    ///< likewise
};

}  // namespace fantail::hal
