// SPDX-License-Identifier: MIT
#include <cctype>
#include <cstddef>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "bench/sheet.hpp"

namespace fantail::bench {
namespace {

// A step or a sine is always that of one canard, and its title says so.
bool is_of_one_canard(const Sheet& sheet) {
  return sheet.kind == ExerciseKind::limits && sheet.canards.size() == 1 && sheet.judgement() == Judgement::pass;
}

std::string others_not_moved(std::size_t canard) {
  std::vector<std::size_t> others;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    if (i != canard) {
      others.push_back(i + 1);
    }
  }
  return fmt::format("Canards {}, {} and {} were not moved.", others[0], others[1], others[2]);
}

}  // namespace

std::string headline(const Sheet& sheet) {
  return fmt::format("{}{}", display_name(sheet.judgement()),
                     is_of_one_canard(sheet) ? fmt::format(", canard {} only", sheet.canards.front().canard + 1) : "");
}

std::vector<std::string> conclusions(const Sheet& sheet) {
  std::vector<std::string> all;
  if (sheet.judgement() == Judgement::none) {
    for (const std::string& doubt : sheet.doubts) {
      all.push_back(fmt::format("{}{}.", static_cast<char>(std::toupper(static_cast<unsigned char>(doubt.front()))),
                                doubt.substr(1)));
    }
    all.emplace_back(
        sheet.recorded_whole
            ? "The canards are not judged. Send a plan with wider canard limits or smaller trims, and run again."
            : "The canards are not judged. End other programs on this PC, check the "
              "adapter and the bus, and run again.");
    return all;
  }
  for (const CanardResult& result : sheet.canards) {
    if (!result.passed()) {
      all.push_back(sentence(result.canard, result.diagnosis));
    }
  }
  for (const GeneralCheck& general : sheet.general) {
    if (!general.passed) {
      all.push_back(general.text);
    }
  }
  if (all.empty() && sheet.kind == ExerciseKind::limits) {
    if (is_of_one_canard(sheet)) {
      all.push_back(others_not_moved(sheet.canards.front().canard));
    }
    all.push_back(
        sheet.canards.size() == core::canard_count
            ? "According to their encoders, all four canards follow their commands to their limits and no further."
            : "According to its encoder, the canard follows its command to its limits and no further.");
    // An encoder that is mounted the other way round agrees with a servo that is: both can be wrong together.
    all.emplace_back(
        "Encoders do not show which way a canard rolls the rocket. Hold each one (fantail bench hold N 5) and look "
        "from outside, nose up. Its leading edge must turn to the right if the plan's direction is normal, to the left "
        "if it is reversed.");
  } else if (all.empty()) {
    all.push_back(
        fmt::format("Canard {} {}", sheet.canards.front().canard + 1,
                    sheet.kind == ExerciseKind::step
                        ? "went to the commanded angle in the required time and at the required speed. A step does not "
                          "show its other side, its trim and its backlash: fantail bench limits judges them."
                        : "followed the sine with the required amplitude, and stands at its trim. Its "
                          "phase lag is not judged; "
                          "fantail bench limits judges limits, backlash and speed."));
  }
  return all;
}

}  // namespace fantail::bench
