// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "log_export/fields.hpp"
#include "log_export/source.hpp"

namespace fantail::log_export {

/// A ULog file, version 1, with the board's clock:
///   fantail_recorded  of the chosen fields those that stand in the log, every tick
///   fantail_replayed  those that the replay made again, every tick that it reached; a float that is not a number:
///   unknown fantail_health    ten times a second
/// Events are logged messages, the flight plan the parameters, vehicle and versions the information, gaps are dropouts.
/// Enumerations are numbers.
[[nodiscard]] std::string ulog(const Source& source, const Selection& selection);

}  // namespace fantail::log_export
