// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fantail::sim {

/// What kind of file a name stands for, and so in which folder the shipped ones lie.
enum class Shipped { scenario, vehicle, motor, plan };

/// The file that a person means: a path when it names an existing file or looks like one, else a shipped name. Throws
/// InputError (no_such_input) with the shipped names and a suggestion.
[[nodiscard]] std::filesystem::path find_input(Shipped kind, const std::string& name_or_path);

/// The shipped names of a kind, sorted.
[[nodiscard]] std::vector<std::string> shipped_names(Shipped kind);

/// Where the shipped files lie: the environment variable FANTAIL_DATA, else the tree this program was built from.
[[nodiscard]] std::filesystem::path data_folder();

}  // namespace fantail::sim
