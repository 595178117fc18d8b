// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "identify/study.hpp"

namespace fantail::identify {

/// One object with the numbers of the one result; with several windows or methods {"results": [...]} of such objects,
/// in the order of the windows. An open end of an interval is null.
[[nodiscard]] std::string result_json(const Study& study);

}  // namespace fantail::identify
