// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace fantail::tool {

/// Both ends included. The library's own range would take "nan".
[[nodiscard]] CLI::Validator within(double low, double high);

}  // namespace fantail::tool
