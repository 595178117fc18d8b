// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "faults/flown_cell.hpp"
#include "input/scenario_file.hpp"

namespace fantail::faults {

/// Every device, fault, phase and onset of one scenario, or a part of them.
struct Campaign {
  std::string scenario{};                  ///< shipped name or path
  std::vector<input::Override> changes{};  ///< the same in every flight
  std::uint64_t seed = 1;                  ///< of the first of the seeds
  std::string device{};                    ///< empty: all
  std::string fault{};                     ///< likewise
  std::string phase{};                     ///< likewise
  int step_ms = 10;                        ///< between two onsets, 1 or more
  int every = 50;                          ///< of those only each so-manieth
  std::size_t seeds = 1;                   ///< 1 or more; each flies every onset
};

/// One flight, as it is stored.
struct Run {
  std::uint64_t number = 0;  ///< in its cell, from 0
  std::uint64_t seed = 0;
  int begin_ms = 0;                  ///< after ignition
  std::optional<Outcome> outcome{};  ///< the first allowed one that it was; empty: none
  double apart_deg = 0.0;            ///< Findings
  double trim_after_s = 0.0;         ///< Findings
  double stands_after_s = 0.0;       ///< Findings
  std::string what{};                ///< of a flight that was none: what it was

  friend bool operator==(const Run&, const Run&) = default;
};

/// What a cell came to.
enum class Colour : std::uint8_t {
  green,
  red,
  known_limit,         ///< red, and nothing in this avionics can help it
  limit_without_need,  ///< green, and known_limits.cpp says that it may be red
  not_applicable,
};
[[nodiscard]] const char* name(Colour colour);

struct CellResult {
  Cell cell;
  Colour colour = Colour::not_applicable;
  std::uint64_t flights = 0;
  std::uint64_t red = 0;
  std::array<std::uint64_t, outcomes> counts{};  ///< of each Outcome, by its bit
  std::optional<Run> worst{};                    ///< a red one before all others
  std::string figure{};                          ///< of the worst, a clause
  std::string report{};                          ///< folder of its flight report, beside the page; empty: none
  const KnownLimit* limit = nullptr;
};

struct Result {
  Campaign campaign;
  std::string scenario;  ///< names, as a flight report has them
  std::string vehicle;
  std::string plan;
  std::vector<CellResult> cells;  ///< a row of the table after the other, phase by phase
  std::uint64_t flights = 0;
};

/// Of the cells that the campaign asks for and the scenario can have: how many flights they are. Throws text::Error for
/// a name that the table has not, and for a scenario without control.
struct Extent {
  std::size_t cells = 0;
  std::uint64_t flights = 0;
};
[[nodiscard]] Extent extent_of(const Campaign& campaign);

/// Flies every run that `folder` does not hold yet. Runs are stored by parts, each under another name first and then
/// renamed, so that whoever begins again finds a part whole or not at all; what `look` throws ends the campaign, and
/// the parts that are finished stay. The result depends on the campaign alone, not on threads or interruptions. `look`
/// is called with the flights done, a few times a second, from this thread.
///
/// Throws text::Error (bad_configuration) when the folder holds another campaign.
[[nodiscard]] Result fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                  const std::string& version, unsigned threads,
                                  const std::function<void(std::uint64_t done)>& look);

/// One run of a cell again. Throws text::Error for a cell that the scenario cannot have and a number that it has not.
struct Alone {
  sim::Scenario scenario;
  Expected expected;
  Findings findings;
};
[[nodiscard]] Alone fly_alone(const Campaign& campaign, const std::string& cell, std::uint64_t number);

/// Writes the flight report of a run.
void write_run(const Campaign& campaign, const std::string& cell, std::uint64_t number, const Alone& alone,
               const std::filesystem::path& folder);
/// The name of the folder that it goes into.
[[nodiscard]] std::string run_folder(const std::string& cell, std::uint64_t number);

/// The cells to look at first, as indices: the worst one of each of the five worst faults, red before known limits
/// before green.
[[nodiscard]] std::vector<std::size_t> worst_cells(const Result& result);
/// Flies the worst run of each of them again and writes its flight report into `folder`. `look` is called before each;
/// what it throws ends it.
void write_worst(Result& result, const std::filesystem::path& folder, const std::function<void()>& look);

/// A row of a part's file, with a newline, and back; empty for what is no such row.
[[nodiscard]] std::string row_of(const Run& run);
[[nodiscard]] std::optional<Run> run_of(std::string_view row);

/// Counts runs of a cell. The limit excuses those that begin at `excused_from_ms` after ignition or later.
[[nodiscard]] CellResult concluded(const Cell& cell, const std::vector<Run>& runs, const KnownLimit* limit,
                                   int excused_from_ms = std::numeric_limits<int>::min());

}  // namespace fantail::faults
