// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "flight/flight.hpp"

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

[[nodiscard]] std::vector<PhaseBand> phase_bands(const flight::Flight& flight);

/// In order of time.
[[nodiscard]] std::vector<EventMark> event_marks(const flight::Flight& flight);

/// What the plots show at first: from a second before lift-off or control start to half a second after control and
/// apogee, so that neither minutes on the pad nor a tumbling descent squeeze the flight. flight.csv has everything.
struct Window {
  double begin_s = 0.0;
  double end_s = 0.0;
};
[[nodiscard]] Window plot_window(const flight::Flight& flight);

/// The rows from a time up to and including another.
[[nodiscard]] std::span<const flight::Row> rows_between(const flight::Flight& flight, double begin_s, double end_s);

}  // namespace fantail::report
