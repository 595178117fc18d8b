// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "input/section.hpp"

namespace fantail::input {

/// What results of a file are called: its name, or its folder's when that says no more than "scenario" or "vehicle", as
/// in a folder that fantail new has made.
[[nodiscard]] std::string name_of_file(const std::filesystem::path& file);

/// What kind of file a name stands for, and so in which folder the shipped ones lie.
enum class Shipped : std::uint8_t { scenario, vehicle, motor, plan, tunnel_result, rules };

/// Where the shipped files of a kind lie in the project, and what they are called.
struct ShippedPlace {
  std::string_view noun;       ///< for people: "flight plan"
  std::string_view folder;     ///< "firmware/plans"
  std::string_view extension;  ///< ".toml"
};

[[nodiscard]] constexpr ShippedPlace place_of(Shipped kind) {
  switch (kind) {
    case Shipped::scenario: return {"scenario", "sim/scenarios", ".toml"};
    case Shipped::vehicle: return {"vehicle", "sim/vehicles", ".toml"};
    case Shipped::motor: return {"motor", "sim/motors", ".eng"};
    case Shipped::tunnel_result: return {"tunnel result", "sim/tunnel_results", ".csv"};
    case Shipped::rules: return {"rule pack", "tools/rules/packs", ".toml"};
    case Shipped::plan: break;
  }
  return {"flight plan", "firmware/plans", ".toml"};
}

/// The file that a person means: a path when it names an existing file or looks like one, else a shipped name. Throws
/// text::Error (no_such_input) with the shipped names and a suggestion.
[[nodiscard]] std::filesystem::path find_input(Shipped kind, const std::string& name_or_path);

/// The file that a key of a document names: a shipped name, or a path from the folder of that document, or from the
/// working folder. A path given with --set counts from the working folder only. The error says where it was named.
[[nodiscard]] std::filesystem::path find_named_input(Shipped kind, const Document& document, Section& section,
                                                     std::string_view key);
/// The same where `name` is only a part of what the key says.
[[nodiscard]] std::filesystem::path find_named_input(Shipped kind, const Document& document, const Section& section,
                                                     std::string_view key, const std::string& name);

/// The shipped names of a kind, sorted.
[[nodiscard]] std::vector<std::string> shipped_names(Shipped kind);

/// Where the shipped files lie: the environment variable FANTAIL_DATA, else the folder given to set_data_folder(), else
/// beside an installed program, else the tree this program was built from.
[[nodiscard]] std::filesystem::path data_folder();

/// The same without FANTAIL_DATA: where what belongs to this program and to no other lies.
[[nodiscard]] std::filesystem::path program_folder();

/// For a library that finds itself in another program, which knows where its files are. Before any thread exists.
void set_data_folder(std::filesystem::path folder);

}  // namespace fantail::input
