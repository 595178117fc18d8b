// SPDX-License-Identifier: MIT
#pragma once

namespace fantail::hal {

/// A contact that a hand or a wire closes: the arm switch, the abort input. Already debounced. Neither closed nor open
/// until it has settled after power-up. Never waits.
class Contact {
 public:
  virtual ~Contact() = default;
  [[nodiscard]] virtual bool closed() const = 0;  ///< false while it is not known
  [[nodiscard]] virtual bool open() const = 0;    ///< likewise
};

}  // namespace fantail::hal
