// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "fantail/command_line.hpp"
#include "runs/folder.hpp"

namespace fantail::tool {

/// This program and the sources that it was built from: what flies.
[[nodiscard]] std::string program_that_flies();

/// Where a verb keeps its flights beside its results until these are written: those of the same command, program and
/// files are gone on from, and others are removed. `command`: with everything that makes a flight another one.
[[nodiscard]] runs::Place place_of_flights(const std::string& verb, const std::string& command,
                                           const std::filesystem::path& folder,
                                           const std::vector<std::filesystem::path>& files);

/// Throws Interrupted when somebody has interrupted, and says whether flights are kept: `kept` is where they would be,
/// the folder of their parts or a file, in the folder of the results.
void leave_if_interrupted(const std::filesystem::path& folder, const std::string& kept = runs::Place{}.parts);

/// `campaign detection`.
void fill_detection(const Verb& verb);

/// `campaign faults`.
void fill_faults(const Verb& verb);

/// `campaign rare`: how probable a failure is that no ordinary campaign meets.
void fill_rare(const Verb& verb);

/// `campaign hardover`: what one canard that fails does to the flight.
void fill_hardover(const Verb& verb);

}  // namespace fantail::tool
