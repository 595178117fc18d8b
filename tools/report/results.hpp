// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "flight/flight.hpp"
#include "report/answer.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// What a flight came to.
struct Results {
  Figures figures;
  Verdict verdict;
  result::Document document;  ///< without pictures: for the terminal and summary.json
};

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

/// Adds what a folder's summary.json says of its flight beyond flight.csv: names, seed, events, why phases changed,
/// verdicts on canards, imposed roll, notes. Nothing happens without the file. Throws text::Error (bad_data) when
/// it is no summary.
void add_summary(flight::Flight& flight, const std::filesystem::path& file);

/// Its events alone, in the same way; and what the sensors could not measure.
[[nodiscard]] flight::Events summary_events(const std::filesystem::path& file);
[[nodiscard]] flight::Unmeasured summary_unmeasured(const std::filesystem::path& file);

/// What it says of the time under control. Empty: it does not.
struct SummaryOfControl {
  std::optional<double> start_s{};
  std::optional<double> end_s{};
  std::optional<double> time_s{};
  std::optional<double> roll_turns{};
};
[[nodiscard]] SummaryOfControl summary_of_control(const std::filesystem::path& file);

/// SHA-256 of the flight.ftl that was written with it; empty without the file, and where there was no log.
[[nodiscard]] std::optional<std::string> summary_log_sha256(const std::filesystem::path& file);

/// Which airframe flew. Empty without the file, and for a summary of an older version, which does not say. Throws as
/// add_summary does.
[[nodiscard]] std::optional<flight::FlownAirframe> summary_airframe(const std::filesystem::path& file);

}  // namespace fantail::report
