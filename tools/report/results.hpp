// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// What a flight came to, with the text of summary.json: for the terminal and --json.
struct Results {
  Figures figures;
  Verdict verdict;
  std::string summary;
};

/// `made` goes into the summary.
[[nodiscard]] Results results(const flight::Flight& flight, const result::Made& made = {});

/// Writes flight.csv, summary.json, report.html, flight.ftl when something was recorded, of a run in a tunnel
/// tunnel.csv, of a flight with a path trajectory.csv, of one on the gimbal or on pins turning.csv, and where it is
/// known how it would have rolled without control without_control.csv into a folder, all or none; see OutputFolder.
/// What an earlier run left there under one of these names does not stay, unless it is of `made_from`: that is refused.
/// Returns the names of what it wrote. Throws OutputError.
std::vector<std::string> write_results(const flight::Flight& flight, const Results& results,
                                       const std::filesystem::path& folder,
                                       const std::vector<std::filesystem::path>& made_from = {});

/// Writes flight.csv, summary.json and report.html of a flight that was read from `input`. A folder that holds the
/// files of a flight, flight.ftl, tunnel.csv, trajectory.csv, turning.csv or without_control.csv, is refused: a report
/// replaces nothing that cannot be made again. Throws OutputError.
void write_report(const flight::Flight& flight, const Results& results, const std::filesystem::path& folder,
                  const std::filesystem::path& input);

}  // namespace fantail::report
