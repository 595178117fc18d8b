// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::report {

// The files of page/ and third_party/uplot, compiled in by embed.cmake.
extern const std::string_view page_css;
extern const std::string_view page_js;
extern const std::string_view overview_css;
extern const std::string_view uplot_css;
extern const std::string_view uplot_js;
extern const std::string_view uplot_licence;

}  // namespace fantail::report
