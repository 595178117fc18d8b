// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::bench {

/// page/sheet.css, compiled in.
extern const std::string_view sheet_css;

}  // namespace fantail::bench
