// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "input/document.hpp"

namespace fantail::tool {

struct FlownVehicle {
  std::optional<input::Document> document{};
  std::string why_unknown{};  ///< and how to name it
};

/// Of a log: the vehicle of this name or path. Without it the shipped one that summary.json beside the log names, with
/// the changes of that flight. Throws text::Error for a named one that is not there, and as logs::flown_airframe()
/// does.
[[nodiscard]] FlownVehicle flown_vehicle(const std::filesystem::path& log, const std::optional<std::string>& named);

}  // namespace fantail::tool
