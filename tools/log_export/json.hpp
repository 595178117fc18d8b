// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "log_export/fields.hpp"
#include "log_export/source.hpp"

namespace fantail::log_export {

/// One object: what the header says, the plan, events, health, gaps, and under "ticks" a list for each chosen field,
/// all of one length. Null: unknown. pandas.DataFrame(json.load(open(FILE))["ticks"]) makes a table of it.
[[nodiscard]] std::string json(const Source& source, const Selection& selection);

}  // namespace fantail::log_export
