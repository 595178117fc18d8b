// SPDX-License-Identifier: MIT
#pragma once

#include "logs/table.hpp"
#include "report/flight.hpp"

namespace fantail::logs {

/// A table with the columns of flight.csv, or some of them, as a flight: rows, phases and the events that phases tell.
/// What the table does not have is not known in the flight either. Throws sim::InputError (bad_data): no time_s or
/// nothing else that Fantail knows, time that does not go on.
[[nodiscard]] report::Flight read_flight_csv(const Table& table);

}  // namespace fantail::logs
