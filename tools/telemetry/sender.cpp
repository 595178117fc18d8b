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

void Changes::look(core::Microseconds time, core::Phase phase, core::PhaseReason reason, Sender& sender) {
  if (phase_ && *phase_ != phase) {
    sender.send(time, Event{.phase = Event::PhaseChange{.before = *phase_, .phase = phase, .reason = reason}});
  }
  phase_ = phase;
}

void Changes::look(core::Microseconds time, const Each<core::CanardVerdict>& verdicts, Sender& sender) {
  for (std::size_t i = 0; verdicts_ && i < verdicts.size(); ++i) {
    if ((*verdicts_)[i] != verdicts[i]) {
      sender.send(
          time, Event{.verdict = Event::VerdictChange{.canard = i, .before = (*verdicts_)[i], .verdict = verdicts[i]}});
    }
  }
  verdicts_ = verdicts;
}

}  // namespace fantail::telemetry
