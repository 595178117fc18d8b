// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/exercise.hpp"
#include "bench/measurement.hpp"
#include "bench/verdict.hpp"
#include "core/canard_monitor.hpp"
#include "link/avionics_link.hpp"
#include "protocol/bus_messages.hpp"
#include "result/answer.hpp"
#include "sim/canard_tolerances.hpp"
#include "text/layout.hpp"

namespace fantail::bench {

/// Facts from the caller that the recording does not have. Texts may be anything; they are escaped when shown.
struct Heading {
  std::string vehicle{};
  std::string plan{};      ///< its name; empty: not known
  std::string plan_crc{};  ///< of the plan in force, as text
  std::string gate{};      ///< gate() of it
  std::string date{};
  std::string avionics{};  ///< the avionics that answered, and where: "can0, protocol 1"
  std::string version{};   ///< of Fantail
  std::vector<std::string> notes{};
  /// Limits that the plan given here has; the avionics must report the same.
  std::optional<Each<double>> planned_limit_rad{};
  /// The last verdict of the avionics' own monitor; shown and not judged.
  Each<std::optional<core::CanardVerdict>> monitor{};
  /// The last report of the board, with every fault that it had while the bench received. Empty: unknown, and the sheet
  /// does not mention it.
  std::optional<protocol::BoardReport> board{};
};

struct TurnResult {
  Figures figures{};
  std::vector<Check> checks{};
  Diagnosis diagnosis{};
  [[nodiscard]] bool passed() const;
};

struct CanardResult {
  std::size_t canard = 0;
  std::optional<TurnResult> alone{};
  std::optional<TurnResult> together{};
  Diagnosis diagnosis{};  ///< of the turn alone; when that was healthy, of the turn together
  [[nodiscard]] bool passed() const;
};

/// What must hold for the whole sheet, beyond each canard's own figures.
struct GeneralCheck {
  std::string text{};  ///< a sentence with the result
  bool passed = false;
};

enum class Judgement : std::uint8_t {
  pass,
  fail,
  none,  ///< the recording has gaps, so the canards are not judged
};

[[nodiscard]] result::Answer answer(Judgement judgement);

struct Sheet {
  ExerciseKind kind{};
  Heading heading{};
  Bounds bounds{};
  sim::CanardTolerances tolerances{};
  std::size_t ticks = 0;
  std::size_t lost_ticks = 0;
  double duration_s = 0.0;  ///< between the first and the last tick
  std::vector<CanardResult> canards{};
  std::vector<GeneralCheck> general{};
  std::vector<std::string> doubts{};  ///< why there is no basis for a judgement, a clause each
  bool recorded_whole = true;         ///< the doubts are about the plan's limits alone
  /// A canard that was commanded beyond its limit fails whatever else is doubtful.
  [[nodiscard]] Judgement judgement() const;
  [[nodiscard]] bool passed() const { return judgement() == Judgement::pass; }
};

[[nodiscard]] std::string_view name(Judgement judgement);          ///< for files: "pass"
[[nodiscard]] std::string_view display_name(Judgement judgement);  ///< "PASS", "FAIL", "NO VERDICT"

/// The large word: "PASS", or "PASS, canard 1 only" where `limits` moved only that one.
[[nodiscard]] std::string headline(const Sheet& sheet);

/// Measures, judges and names the causes. Some 10 ms for `limits` of four canards.
[[nodiscard]] Sheet examine(const link::Recording& recording, const Exercise& exercise,
                            const sim::CanardTolerances& tolerances, const Heading& heading);

/// One sentence for each thing that failed, canards first; one when all passed.
[[nodiscard]] std::vector<std::string> conclusions(const Sheet& sheet);

/// One object; every figure with its unit in its name.
[[nodiscard]] std::string sheet_json(const Sheet& sheet, const result::Made& made = {});

/// The series behind the sheet, one row a tick that was received. Empty: not driven, or no valid reading.
[[nodiscard]] std::string sheet_csv(const link::Recording& recording, const Exercise& exercise);

/// For a terminal: plain ASCII, aligned, at most 100 columns except for sentences.
[[nodiscard]] std::string sheet_text(const Sheet& sheet, std::size_t columns = text::any_width);

/// A printable page, complete in itself: no script, nothing loaded.
[[nodiscard]] std::string sheet_html(const Sheet& sheet, const link::Recording& recording, const Exercise& exercise);
/// The inside of that page.
[[nodiscard]] std::string sheet_inner_html(const Sheet& sheet, const link::Recording& recording,
                                           const Exercise& exercise);
/// The same of a sheet of the first turns (Exercise::beginning): what has failed so far, and no verdict.
/// `turns_to_come` others are still to be done, or will not be when `given_up_because` says why.
[[nodiscard]] std::string sheet_so_far_html(const Sheet& sheet, const link::Recording& recording,
                                            const Exercise& exercise, std::size_t turns_to_come,
                                            const std::string& given_up_because = {});
/// The same if the canards are not judged, with the reason `why`. `title`: the rocket.
[[nodiscard]] std::string no_sheet_html(const std::string& title, const std::string& why);

/// The inside of a page, as HTML, while an exercise goes on: the sheet of the turns that are over. They are cut as in
/// the whole sheet, by what the exercise has done: on a slow PC that is behind the rocket's clock.
class FillingSheet {
 public:
  FillingSheet(Exercise exercise, const sim::CanardTolerances& tolerances, Heading heading)
      : exercise_{std::move(exercise)}, tolerances_{tolerances}, heading_{std::move(heading)} {}

  /// The next tick. The sheet when another turn is over with it; with the last turn comes the whole sheet instead.
  [[nodiscard]] std::optional<std::string> take(const link::Tick& tick);
  /// The exercise was given up, and `why`: the results of finished turns stay.
  [[nodiscard]] std::string given_up(const std::string& why) const;

 private:
  [[nodiscard]] std::string html(const std::string& given_up_because) const;

  Exercise exercise_;
  sim::CanardTolerances tolerances_;
  Heading heading_;
  link::Recording recording_;
  std::size_t turns_over_ = 0;
};

}  // namespace fantail::bench
