// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "files/rows.hpp"
#include "flight/flight.hpp"
#include "flight/table.hpp"

namespace fantail::logs {

/// The flight phases that stand as words in a column. One with a word that is no phase is not used, and a note of the
/// flight says so.
void read_phases(const flight::Table& table, const files::Rows& rows, std::size_t column, flight::Flight& flight);

/// What the phases of the rows tell of the events. Throws text::Error (bad_data) for a table, called `name`, of more
/// than one flight.
void note_phases(flight::Flight& flight, const std::string& name);

}  // namespace fantail::logs
