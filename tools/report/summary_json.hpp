// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "flight/flight.hpp"
#include "report/figures.hpp"
#include "report/verdict.hpp"

namespace fantail::report {

/// summary.json: every key is always there; what does not exist is null. Angles in degrees, ends with a newline.
[[nodiscard]] std::string summary_json(const flight::Flight& flight, const Figures& figures, const Verdict& verdict,
                                       const result::Made& made = {});

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
