// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flight_log/flight_log.hpp"
#include "log_export/fields.hpp"
#include "log_export/replayed_flight.hpp"

namespace fantail::log_export {

/// flight.csv: its columns, one row for each tick of the log. To where no replay leads, only what the log itself holds
/// is in it; then there is a last column `replayed`, 0 or 1.
[[nodiscard]] std::string flight_csv(const ReplayedFlight& source, const flight::Flight& report);

/// The chosen fields, one row for each tick of the log. What is unknown is an empty cell.
[[nodiscard]] std::string csv(const ReplayedFlight& source, const Selection& selection);

/// What stands beside a table, as NAME.columns.json: unit and description of each of its columns, in their order. The
/// table itself stays one that every program reads.
[[nodiscard]] std::string columns_json(const std::string& table);

/// The same of a log of another version of Fantail, with the units of its own schema.
[[nodiscard]] std::string foreign_columns_json(const flight_log::Flight& flight, const std::string& table);

/// The columns of a log whose ticks are laid out as in another version of Fantail: its clock, then what its own schema
/// names, with the units as they stand there. Empty when the schema does not describe ticks.
[[nodiscard]] std::vector<std::string> foreign_fields(const flight_log::Flight& flight);

/// Such a log as a table; `names` are some of foreign_fields(). time_s is 0 at the first tick: what happened in the
/// flight only the other version knows. A value that a record is too short for is an empty cell.
[[nodiscard]] std::string foreign_csv(const flight_log::Flight& flight, std::span<const std::string> names,
                                      const Window& window);

// json(), parquet() and mcap() are written by the packages of fantail.files, and throw as files::exported() does.

/// One object: what the header says, the plan, events, health, gaps, under "columns" unit and description of each
/// chosen field, and under "ticks" a list for each, all of one length. Null: unknown.
/// pandas.DataFrame(json.load(open(FILE))["ticks"]) makes a table of it.
[[nodiscard]] std::string json(const ReplayedFlight& source, const Selection& selection);

/// A MAT-file of version 5 with five structs:
///   flight        of each chosen field a column of numbers; not a number: unknown
///   units, descriptions   of each a text
///   words         of each that holds words a cell of those that occur; the numbers are places in it, from 1 on
///   about         what the header says, the plan, events, health, gaps
[[nodiscard]] std::string mat(const ReplayedFlight& source, const Selection& selection);

/// A Parquet file with a column for each chosen field; null: unknown. Under the key "fantail" of its metadata stands
/// the JSON of about.hpp.
[[nodiscard]] std::string parquet(const ReplayedFlight& source, const Selection& selection);

/// An MCAP file with the board's clock, of JSON messages with a JSON schema each, which has unit and description of
/// every field:
///   /fantail/recorded  of the chosen fields those that stand in the log, every tick
///   /fantail/replayed  those that the replay made again, every tick of which one is known
///   /fantail/health    ten times a second
///   /fantail/events    events and gaps, as foxglove.Log
/// What is unknown is not in a message. Vehicle, versions, plan and gaps are the metadata.
[[nodiscard]] std::string mcap(const ReplayedFlight& source, const Selection& selection);

/// A ULog file, version 1, with the board's clock:
///   fantail_recorded  of the chosen fields those that stand in the log, every tick
///   fantail_replayed  those that the replay made again, every tick that it reached; a float that is not a number:
///   unknown fantail_health    ten times a second
/// Unit and description of each field are multi information messages, by the name of the topic. Events are logged
/// messages, the flight plan the parameters, vehicle and versions the information, gaps are dropouts.
/// Enumerations are numbers.
[[nodiscard]] std::string ulog(const ReplayedFlight& source, const Selection& selection);

/// An LCM log for lcm-logplayer, with the board's clock: the messages of a live flight, but state and canards of every
/// replayed tick. Health and events are those that stand in the log. What decodes them is telemetry::type_files().
[[nodiscard]] std::string lcm(const ReplayedFlight& source);

/// What the avionics would have put on the bus, as `candump -l` writes it down: "(12.345678) can0
/// 0A0#0011223344556677", with the board's time. Commands, encoders, status, motion, health, limits and heartbeat, as
/// often as the avionics sends them; answers to a bench are not in a flight log, and so not here. What only the bus
/// knew is zero.
[[nodiscard]] std::string candump(const ReplayedFlight& source);

}  // namespace fantail::log_export
