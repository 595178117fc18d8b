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
#include "runs/row_text.hpp"

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
  int every = 50;                          ///< of those only one in so many, 1 or more
  std::size_t seeds = 1;                   ///< 1 or more; each flies every onset
};

/// One flight, as it is stored.
struct Run {
  std::uint64_t number = 0;  ///< in its cell, from 0
  std::uint64_t seed = 0;
  int begin_ms = 0;                  ///< after ignition
  std::optional<Outcome> outcome{};  ///< the first allowed one that it was; empty: none
  bool is_breach = false;            ///< of what holds for every flight, which no limit excuses
  bool came_back = false;            ///< Findings, of a flight that was none
  double apart_deg = 0.0;            ///< Findings: of its outcome
  double trim_after_s = 0.0;         ///< Findings
  double stands_after_s = 0.0;       ///< Findings
  std::string what{};                ///< of a flight that was none: what it was

  friend bool operator==(const Run&, const Run&) = default;
};
inline void fields(runs::RowText& text, Run& run) {
  text(run.number, run.seed, run.begin_ms, run.outcome, run.is_breach, run.came_back, run.apart_deg, run.trim_after_s,
       run.stands_after_s, run.what);
}

/// What a cell came to.
enum class Colour : std::uint8_t {
  green,
  red,
  known_limit,         ///< red, and nothing in this avionics can help it
  not_judged,          ///< green, by flights of which nothing is asked but what holds for every one
  limit_without_need,  ///< green, and known_limits.cpp says that it may be red
  not_applicable,
};
[[nodiscard]] const char* name(Colour colour);

/// The limit of a cell, and from when on it excuses.
struct CellLimit {
  const KnownLimit* limit = nullptr;
  int from_ms = std::numeric_limits<int>::min();  ///< after ignition

  [[nodiscard]] bool is_late(const Run& run) const { return run.begin_ms >= from_ms; }
  [[nodiscard]] bool excuses(const Run& run) const {
    return limit != nullptr && is_late(run) && !run.is_breach && (limit->excuse != Excuse::comes_back || run.came_back);
  }
};

/// Runs of a cell, counted one by one, so that none has to be kept.
struct CellSum {
  std::uint64_t flights = 0;
  std::uint64_t red = 0;
  std::uint64_t late = 0;                        ///< begun when the limit excuses them
  std::uint64_t not_excused = 0;                 ///< red
  std::array<std::uint64_t, outcomes> counts{};  ///< of each Outcome, by its bit
  std::optional<Run> worst{};                    ///< a red one before all others; of equals the first

  void add(const Run& run, const CellLimit& limit);
  /// Runs that come after these.
  void add(const CellSum& later);
};

struct CellResult {
  Cell cell;
  Colour colour = Colour::not_applicable;
  std::uint64_t flights = 0;
  std::uint64_t red = 0;
  std::array<std::uint64_t, outcomes> counts{};
  std::optional<Run> worst{};
  std::string figure{};    ///< of the worst, a clause
  std::string report{};    ///< folder of its flight report, beside the page; empty: none
  bool is_reached = true;  ///< the flight without the fault has time in its phase; else nothing was flown
  const KnownLimit* limit = nullptr;
  std::string of_rocket{};  ///< whether the rocket that was flown does what the limit asks for; empty: not computed
};

struct Result {
  Campaign campaign;
  std::string scenario;  ///< names, as a flight report has them
  std::string vehicle;
  std::string plan;
  std::vector<CellResult> cells;  ///< a row of the table after the other, phase by phase
  std::uint64_t flights = 0;
  std::uint64_t damaged = 0;     ///< stored parts that were damaged, and were flown again
  std::string never_happened{};  ///< faults of the scenario's own, a sentence each; empty: all began
  std::string beyond_model{};    ///< how far its flight without a fault is beyond the roll model; empty: not
};

/// Of the cells that the campaign asks for and the scenario can have: how many flights they are.
struct Extent {
  std::size_t cells = 0;
  std::uint64_t flights = 0;
};
/// A campaign of more is refused: with that it would take days.
inline constexpr std::uint64_t most_flights = 10'000'000;

/// A campaign that can be flown, with what it takes from its flights without any fault.
struct Prepared {
  Campaign campaign;
  Twins twins;
  Extent extent;
};
/// Flies the twins. `look` is called with how many are done, a few times a second, from this thread; what it throws
/// ends it. Throws text::Error for a name that the table has not, for a scenario without control, and for too many
/// flights, before they are listed.
[[nodiscard]] Prepared prepare(const Campaign& campaign, unsigned threads = 0,
                               const std::function<void(std::size_t done)>& look = {});
[[nodiscard]] inline Extent extent_of(const Campaign& campaign) { return prepare(campaign).extent; }

/// Flies every run that `folder` does not hold yet, as runs::run() does. The result depends on the campaign alone.
[[nodiscard]] Result fly_campaign(const Prepared& prepared, const std::filesystem::path& folder,
                                  const std::string& program, unsigned threads,
                                  const std::function<void(std::uint64_t done)>& look);
[[nodiscard]] inline Result fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                         const std::string& program, unsigned threads,
                                         const std::function<void(std::uint64_t done)>& look) {
  return fly_campaign(prepare(campaign, threads), folder, program, threads, look);
}

/// One run of a cell again. Throws text::Error for a cell that the scenario cannot have and a number that it has not.
struct Alone {
  sim::Scenario scenario;
  Expected expected;
  Findings findings;
  Run run;
  CellResult judged;         ///< as if it were the cell's only one: the same verdict as the campaign's
  std::string beyond_model;  ///< as in Result
};
[[nodiscard]] Alone fly_alone(const Prepared& prepared, const std::string& cell, std::uint64_t number);

/// A campaign of this cell alone, whose runs are those of the whole one. Throws text::Error (usage) for no cell.
[[nodiscard]] Campaign only(Campaign campaign, const std::string& cell);
[[nodiscard]] inline Alone fly_alone(const Campaign& campaign, const std::string& cell, std::uint64_t number) {
  return fly_alone(prepare(only(campaign, cell)), cell, number);
}

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
void write_worst(Result& result, const Prepared& prepared, const std::filesystem::path& folder,
                 const std::function<void()>& look);

/// What a cell came to.
[[nodiscard]] CellResult conclude(const Cell& cell, const CellSum& sum, const KnownLimit* limit);
[[nodiscard]] CellResult concluded(const Cell& cell, const std::vector<Run>& runs, const CellLimit& limit);

/// Of what makes a flight this one and no other, beside its scenario: a digest of the first twin, of a few flights with
/// a fault, and of the table. Another one when simulator, flight law, judge or table make something else of them.
[[nodiscard]] std::string fingerprint(const Twins& twins);

}  // namespace fantail::faults
