// SPDX-License-Identifier: MIT
#include <array>
#include <iterator>

#include <fmt/format.h>

#include "bench/sheet.hpp"
#include "bench/trace.hpp"
#include "text/degrees.hpp"

namespace fantail::bench {
namespace {

std::string_view name(Part part) {
  // In the order of Part.
  static constexpr std::array<std::string_view, 13> names{"settle",
                                                          "ramp_positive",
                                                          "hold_positive",
                                                          "return_from_positive",
                                                          "centre_from_above",
                                                          "ramp_negative",
                                                          "hold_negative",
                                                          "return_from_negative",
                                                          "centre_from_below",
                                                          "step_out",
                                                          "step_across",
                                                          "step_home",
                                                          "sine"};
  static_assert(static_cast<std::size_t>(Part::sine) + 1 == names.size());
  return names[static_cast<std::size_t>(part)];
}

}  // namespace

std::string sheet_csv(const link::Recording& recording, const Exercise& exercise) {
  std::string csv = "time_s,turn,part";
  for (std::size_t i = 1; i <= core::canard_count; ++i) {
    csv += fmt::format(",command_{0}_deg,encoder_{0}_deg,limited_{0}", i);
  }
  csv += '\n';
  std::size_t turn = 0;
  for (const link::Tick& tick : recording.ticks()) {
    while (turn + 1 < exercise.turns().size() && tick.stretch > exercise.turns()[turn].last) {
      ++turn;
    }
    const auto& alone = exercise.turns()[turn].canard;
    const auto since_first = static_cast<double>(tick.number - recording.ticks().front().number);
    fmt::format_to(std::back_inserter(csv), "{:.3f},{},{}", tick_s * since_first,
                   alone ? fmt::format("canard_{}", *alone + 1) : "all", name(exercise.stretches()[tick.stretch].part));
    const auto add = [&csv](const std::optional<double>& angle_rad) {
      csv += ',';
      if (angle_rad) {
        fmt::format_to(std::back_inserter(csv), "{:.2f}", text::degrees(*angle_rad));
      }
    };
    for (std::size_t i = 0; i < core::canard_count; ++i) {
      add(tick.command_rad[i]);
      add(tick.encoder_rad[i]);
      csv += tick.limited[i] ? ",1" : ",0";
    }
    csv += '\n';
  }
  return csv;
}

}  // namespace fantail::bench
