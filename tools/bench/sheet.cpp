// SPDX-License-Identifier: MIT
#include "bench/sheet.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "bench/measurement.hpp"
#include "bench/trace.hpp"
#include "bench/watch.hpp"
#include "core/flight_plan.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

using text::degrees;
using text::fixed;

constexpr double least_whole = 0.95;  // share of the exercise that must have been recorded
const double resolution_rad = text::radians(0.01);

bool all_passed(const std::vector<Check>& checks) {
  return std::ranges::all_of(checks, [](const Check& check) { return check.passed; });
}

Each<double> largest_commands_rad(const link::Recording& recording) {
  Each<double> largest{};
  for (const link::Tick& tick : recording.ticks()) {
    for (std::size_t i = 0; i < largest.size(); ++i) {
      largest[i] = std::max(largest[i], std::abs(tick.command_rad[i].value_or(0.0)));
    }
  }
  return largest;
}

// `step` and `sine` show what the person asked for; only what they do show is judged.
bool shown_by(ExerciseKind kind, Measure measure) {
  switch (measure) {
    case Measure::sign:
    case Measure::dropouts:
    case Measure::noise:
    case Measure::limit_kept:
    case Measure::others_moved: return true;
    case Measure::slew:
    case Measure::step_time: return kind != ExerciseKind::sine;
    case Measure::reached: return kind == ExerciseKind::step;
    case Measure::amplitude_ratio: return kind == ExerciseKind::sine;
    case Measure::centring_error: return kind != ExerciseKind::step;
    default: return kind == ExerciseKind::limits;
  }
}

class Examination {
 public:
  Examination(const link::Recording& recording, const Exercise& exercise, Sheet& sheet)
      : recording_{recording}, exercise_{exercise}, sheet_{sheet}, largest_rad_{largest_commands_rad(recording)} {}

  void canards() {
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      CanardResult result{.canard = canard};
      for (const Turn& turn : exercise_.turns()) {
        if (!turn.canard) {
          result.together = turn_result(turn, canard);
        } else if (*turn.canard == canard) {
          result.alone = turn_result(turn, canard);
        }
      }
      if (!result.alone && !result.together) {
        continue;
      }
      conclude(result);
      sheet_.canards.push_back(std::move(result));
    }
  }

  void general() {
    limits();
    board();
    const double expected = exercise_.duration_s() / tick_s;
    const auto spanned = static_cast<double>(sheet_.ticks + sheet_.lost_ticks);
    const double lost = sheet_.ticks == 0 ? 1.0 : static_cast<double>(sheet_.lost_ticks) / spanned;
    add(lost <= most_lost_share, "{} of {} ticks were lost on the way.", sheet_.lost_ticks, fixed(spanned, 0));
    travel();
    const std::size_t of_plan = sheet_.doubts.size();
    if (lost > most_lost_share) {
      doubt("{} of {} ticks were lost on the way", sheet_.lost_ticks, fixed(spanned, 0));
    }
    if (spanned < least_whole * expected) {
      doubt("only {} s of the {} s of the exercise were recorded", fixed(spanned * tick_s, 1),
            fixed(exercise_.duration_s(), 1));
    }
    for (const CanardResult& result : sheet_.canards) {
      if (exercise_.wave()) {
        sine_sent(result.alone->figures);
      }
      if (result.diagnosis.cause == Cause::not_measured) {
        doubt("canard {} could not be measured ({})", result.canard + 1, result.diagnosis.seen);
      }
    }
    sheet_.recorded_whole = sheet_.doubts.size() == of_plan;
  }

 private:
  template <typename... T>
  void add(bool passed, fmt::format_string<T...> format, T&&... values) {
    sheet_.general.push_back({.text = fmt::format(format, std::forward<T>(values)...), .passed = passed});
  }

  template <typename... T>
  void doubt(fmt::format_string<T...> format, T&&... values) {
    sheet_.doubts.push_back(fmt::format(format, std::forward<T>(values)...));
  }

  [[nodiscard]] TurnResult turn_result(const Turn& turn, std::size_t canard) const {
    TurnResult result{.figures = measure(recording_, exercise_, turn, canard)};
    if (turn.canard && result.figures.largest_command_rad) {
      result.figures.largest_command_rad = largest_rad_[canard];  // in others' turns too
    }
    if (exercise_.kind() == ExerciseKind::sine) {
      result.figures.slowest_ratio = slowest_ratio(recording_, exercise_, turn, canard, sheet_.tolerances);
    }
    result.checks = check(result.figures, exercise_.bounds(), canard, turn.canard.has_value(), sheet_.tolerances);
    std::erase_if(result.checks, [&](const Check& c) { return !shown_by(exercise_.kind(), c.measure); });
    result.diagnosis = diagnose(result.figures, result.checks, exercise_.bounds(), canard, sheet_.tolerances);
    return result;
  }

  // A canard can be judged by the sine only if that is what it was commanded.
  void sine_sent(const Figures& f) {
    const double frequency_hz = exercise_.wave()->frequency_hz;
    if (!f.wave_difference || *f.wave_difference <= most_difference(frequency_hz)) {
      return;
    }
    doubt(
        "the rocket did not receive the requested sine: at {:g} Hz its amplitude was {} instead of {} deg. It stood "
        "still for up to {} s and differed by {} % of its size (allowed: {} %)",
        frequency_hz, fixed(degrees(f.amplitude_rad.value_or(0.0)), 2),
        fixed(degrees(f.asked_amplitude_rad.value_or(0.0)), 2), fixed(f.longest_standstill_s.value_or(0.0), 3),
        fixed(100.0 * *f.wave_difference, 0), fixed(100.0 * most_difference(frequency_hz), 0));
  }

  static void conclude(CanardResult& result) {
    const bool alone_healthy = !result.alone || result.alone->diagnosis.cause == Cause::healthy;
    const bool from_together = alone_healthy && result.together;
    result.diagnosis = from_together ? result.together->diagnosis : result.alone->diagnosis;
    if (from_together && result.alone && result.diagnosis.cause != Cause::healthy) {
      result.diagnosis.seen = "healthy alone; with all four moving, " + result.diagnosis.seen;
      result.diagnosis.look_at += " A fault that shows only with all four moving may be in their common supply.";
    }
  }

  void limits() {
    const double hard_rad = static_cast<double>(core::hard_canard_limit.radians());
    const Each<double>& limits_rad = exercise_.bounds().limit_rad;
    const double widest_rad = *std::ranges::max_element(limits_rad);
    add(widest_rad <= hard_rad + resolution_rad, "The widest limit in force is {} deg; the hard limit is {} deg.",
        fixed(degrees(widest_rad), 2), fixed(degrees(hard_rad), 0));
    for (std::size_t i = 0; i < limits_rad.size(); ++i) {
      if (largest_rad_[i] > limits_rad[i] + 2.0 * resolution_rad) {
        add(false, "Canard {} was commanded to {} deg, beyond its limit of {} deg.", i + 1,
            fixed(degrees(largest_rad_[i]), 2), fixed(degrees(limits_rad[i]), 2));
      }
      if (sheet_.heading.planned_limit_rad &&
          std::abs((*sheet_.heading.planned_limit_rad)[i] - limits_rad[i]) > resolution_rad) {
        add(false, "Canard {}: the avionics reports a limit of {} deg, the plan given here has {} deg.", i + 1,
            fixed(degrees(limits_rad[i]), 2), fixed(degrees((*sheet_.heading.planned_limit_rad)[i]), 2));
      }
    }
  }

  // The check has its sentence either way: what is signed says that the board was asked.
  void board() {
    if (!sheet_.heading.board) {
      return;
    }
    const std::vector<std::string> bars = bars_to_arming(*sheet_.heading.board);
    if (bars.empty()) {
      add(true, "The board reports no fault that forbids arming.");
    } else {
      add(false, "The rocket cannot be armed: its board reported {}. Correct that, and make a new sheet.",
          fmt::join(bars, ", "));
    }
  }

  // A canard that hardly moves shows neither scale nor speed.
  void travel() {
    for (const CanardResult& result : sheet_.canards) {
      if (exercise_.kind() == ExerciseKind::limits && too_little_travel(exercise_.bounds(), result.canard)) {
        doubt(
            "canard {} has a limit of {} deg and a trim of {} deg; with less than {} deg between them it is not judged",
            result.canard + 1, fixed(degrees(exercise_.bounds().limit_rad[result.canard]), 2),
            fixed(degrees(exercise_.bounds().centre_rad[result.canard]), 2), fixed(degrees(least_travel_rad()), 1));
      }
    }
  }

  const link::Recording& recording_;
  const Exercise& exercise_;
  Sheet& sheet_;
  Each<double> largest_rad_;
};

}  // namespace

bool TurnResult::passed() const { return all_passed(checks); }

bool CanardResult::passed() const {
  return (!alone || alone->passed()) && (!together || together->passed()) && diagnosis.cause == Cause::healthy;
}

result::Answer answer(Judgement judgement) {
  switch (judgement) {
    case Judgement::pass: return result::Answer::yes;
    case Judgement::fail: return result::Answer::no;
    case Judgement::none: break;
  }
  return result::Answer::undecided;
}

Judgement Sheet::judgement() const {
  if (std::ranges::any_of(canards, [](const auto& c) { return c.diagnosis.cause == Cause::limit_not_kept; })) {
    return Judgement::fail;
  }
  if (!doubts.empty()) {
    return Judgement::none;
  }
  const bool all_well = !canards.empty() &&
                        std::ranges::all_of(canards, [](const CanardResult& c) { return c.passed(); }) &&
                        std::ranges::all_of(general, [](const GeneralCheck& c) { return c.passed; });
  return all_well ? Judgement::pass : Judgement::fail;
}

std::string_view name(Judgement judgement) {
  switch (judgement) {
    case Judgement::pass: return "pass";
    case Judgement::fail: return "fail";
    case Judgement::none: break;
  }
  return "none";
}

std::string_view display_name(Judgement judgement) {
  switch (judgement) {
    case Judgement::pass: return "PASS";
    case Judgement::fail: return "FAIL";
    case Judgement::none: break;
  }
  return "NO VERDICT";
}

Sheet examine(const link::Recording& recording, const Exercise& exercise, const sim::CanardTolerances& tolerances,
              const Heading& heading) {
  Sheet sheet{.kind = exercise.kind(),
              .heading = heading,
              .bounds = exercise.bounds(),
              .tolerances = tolerances,
              .ticks = recording.ticks().size(),
              .lost_ticks = recording.lost_ticks(),
              .duration_s = recording.ticks().empty() ? 0.0
                                                      : tick_s * static_cast<double>(recording.ticks().back().number -
                                                                                     recording.ticks().front().number)};
  Examination examination{recording, exercise, sheet};
  examination.canards();
  examination.general();
  return sheet;
}

}  // namespace fantail::bench
