// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "flight/flight.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::log_export {

/// On the clock of flight.csv, both ends included; empty: all that there is.
struct Window {
  std::optional<double> from_s{};
  std::optional<double> until_s{};
};

/// What every export is made from: one flight of a log and its replay.
class ReplayedFlight {
 public:
  /// Both outlive this object. `report` is to_report() of the two, for its clock.
  ReplayedFlight(const flight_log::Flight& flight, const flight_log::Regeneration& regeneration,
                 const flight::Flight& report, Window window = {});

  [[nodiscard]] const flight_log::Flight& flight() const { return flight_; }
  [[nodiscard]] const flight_log::Regeneration& regeneration() const { return regeneration_; }

  /// The replayed record of a tick; null where the replay could not come.
  [[nodiscard]] const core::TickRecord* record(std::size_t tick) const;
  /// On the clock of flight.csv: the number that its six decimals are, so that a window takes the same ticks of each
  /// export.
  [[nodiscard]] double time_s(core::Microseconds time) const {
    return static_cast<double>((time - zero_).count()) / 1e6;
  }
  [[nodiscard]] bool inside(core::Microseconds time) const { return inside(time_s(time)); }
  [[nodiscard]] bool inside(double time_s) const;

 private:
  const flight_log::Flight& flight_;
  const flight_log::Regeneration& regeneration_;
  core::Microseconds zero_{};
  Window window_;
};

}  // namespace fantail::log_export
