// SPDX-License-Identifier: MIT
#include "telemetry/changes.hpp"

namespace fantail::telemetry {

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
