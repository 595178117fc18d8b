// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/flight.hpp"

namespace fantail::report {

/// A stretch of one phase, for the bands behind the plots.
struct PhaseBand {
  core::Phase phase = core::Phase::safe;
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// A labelled vertical line. An empty label: a line only (the later ones of many reference steps).
struct EventMark {
  double time_s = 0.0;
  std::string label;
};

[[nodiscard]] std::vector<PhaseBand> phase_bands(const Flight& flight);

/// In order of time.
[[nodiscard]] std::vector<EventMark> event_marks(const Flight& flight);

/// Where the plots begin: a second before lift-off or control start, so that minutes on the pad do not squeeze the
/// flight. flight.csv has everything.
[[nodiscard]] double plot_begin_s(const Flight& flight);

}  // namespace fantail::report
