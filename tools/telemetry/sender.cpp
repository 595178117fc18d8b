// SPDX-License-Identifier: MIT
#include "telemetry/sender.hpp"

#include <random>

namespace fantail::telemetry {

std::int64_t new_run() {
  std::random_device device;
  const std::uint64_t high = device();
  // 53 bits: scripts in languages whose numbers are doubles can compare it too.
  return static_cast<std::int64_t>((high << 21U ^ device()) & 0x1F'FFFF'FFFF'FFFFU);
}

}  // namespace fantail::telemetry
