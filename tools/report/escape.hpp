// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace fantail::report {

/// Text for HTML or SVG, between tags or inside a quoted attribute.
[[nodiscard]] std::string escape_html(std::string_view text);

/// JSON for the inside of a <script> element: no "<" survives, so no text can close the element.
[[nodiscard]] std::string escape_script_json(std::string_view json);

}  // namespace fantail::report
