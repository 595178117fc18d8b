// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace fantail::flight_log {

/// What bytes without a single record are, as the end of a sentence: "a CSV file". People take the wrong file more
/// often than a log is damaged beyond reading.
[[nodiscard]] std::string looks_like(std::span<const std::byte> bytes);

}  // namespace fantail::flight_log
