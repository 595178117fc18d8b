// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "input/shipped.hpp"
#include "manual/command.hpp"

// What a shell may offer for the values of several verbs.
namespace fantail::tool {

/// The shipped names of a kind, asked of the data that is installed, or a file.
[[nodiscard]] manual::Offering shipped(input::Shipped kind);

[[nodiscard]] manual::Offer files(std::string_view begun);
[[nodiscard]] manual::Offer folders(std::string_view begun);

/// Those that the kernel has now.
[[nodiscard]] manual::Offer can_interfaces(std::string_view begun);

// "section.key=" of every key, and behind the "=" of a choice its words.
[[nodiscard]] manual::Offer changes(std::string_view begun);  ///< of plan, vehicle and scenario
[[nodiscard]] manual::Offer changes_of_plan(std::string_view begun);
[[nodiscard]] manual::Offer changes_of_vehicle(std::string_view begun);

}  // namespace fantail::tool
