// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "identify/study.hpp"

namespace fantail::identify {

/// report.html: what was found, how well each number is known in plain words, and the pictures behind it.
[[nodiscard]] std::string result_html(const Study& study);

}  // namespace fantail::identify
