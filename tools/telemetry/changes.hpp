// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "telemetry/sender.hpp"

namespace fantail::telemetry {

/// Makes an event of every change of the phase and of each verdict. What was so when it began to look is no change,
/// except that the avionics begins in Safe with healthy canards.
class Changes {
 public:
  void look(core::Microseconds time, core::Phase phase, core::PhaseReason reason, Sender& sender);
  void look(core::Microseconds time, const Each<core::CanardVerdict>& verdicts, Sender& sender);

  /// For who comes late: the first look is where it begins.
  void begin_with_first_look() {
    phase_.reset();
    verdicts_.reset();
  }

 private:
  std::optional<core::Phase> phase_{core::Phase::safe};
  std::optional<Each<core::CanardVerdict>> verdicts_{Each<core::CanardVerdict>{}};
};

}  // namespace fantail::telemetry
