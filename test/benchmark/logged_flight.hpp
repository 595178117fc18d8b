// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "flight_log/regenerate.hpp"

namespace fantail::benchmark {

/// A flight of a little more than 30 s as the avionics recorded it: a tunnel run. Flown once, at the first use.
struct LoggedFlight {
  std::vector<std::byte> bytes;
  flight_log::Flight flight;
  flight_log::Regeneration regeneration;
};
[[nodiscard]] const LoggedFlight& logged_flight();

}  // namespace fantail::benchmark
