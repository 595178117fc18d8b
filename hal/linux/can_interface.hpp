// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace fantail::hal::on_linux {

/// A network interface of this PC.
struct Interface {
  int index = 0;
  bool can = false;
  bool up = false;
};

/// Empty when there is none of that name.
[[nodiscard]] std::optional<Interface> find_interface(const std::string& name);

/// Returns the interface when CAN frames can pass through it, else throws CanError. The message leads the reader on.
[[nodiscard]] Interface usable_interface(const std::string& name);

/// "can0: " and why no socket could be had, and what to do, from an error number.
[[nodiscard]] std::string socket_trouble(const std::string& name, int error);

}  // namespace fantail::hal::on_linux
