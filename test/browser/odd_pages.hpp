// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "text/output_folder.hpp"

namespace fantail::test {

/// Pages of a result whose names are in any script and very long, and of one without data.
[[nodiscard]] std::array<text::NamedFile, 2> odd_pages();

}  // namespace fantail::test
