// SPDX-License-Identifier: MIT
#include "telemetry/words.hpp"

#include <fmt/core.h>

namespace fantail::telemetry {

std::string words(const Event& event) {
  if (event.phase) {
    return fmt::format("{} -> {} ({})", core::name(event.phase->before), core::name(event.phase->phase),
                       core::name(event.phase->reason));
  }
  if (event.verdict) {
    return fmt::format("canard {}: {} -> {}", event.verdict->canard + 1, core::name(event.verdict->before),
                       core::name(event.verdict->verdict));
  }
  return "nothing";
}

}  // namespace fantail::telemetry
