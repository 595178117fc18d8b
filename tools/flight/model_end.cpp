// SPDX-License-Identifier: MIT
#include "flight/model_end.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "text/apart.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::flight {
namespace {

std::string mach_end() { return fmt::format("Mach {}", text::brief(model_ends_at_mach, 2)); }
std::string attack_end() { return text::brief(text::degrees(model_ends_at_attack_rad), 1); }

std::string how_far(ModelEnd end, const Extremes& worst) {
  switch (end) {
    case ModelEnd::mach: return fmt::format("up to Mach {}", text::apart(*worst.top_mach, model_ends_at_mach, 2));
    case ModelEnd::stability:
      return fmt::format("with a static margin down to {} calibres",
                         text::apart(*worst.static_margin_calibres, 0.0, 2));
    case ModelEnd::attack: break;
  }
  return fmt::format(
      "with an angle of attack of up to {} deg under control",
      text::apart(text::degrees(*worst.angle_of_attack_rad), text::degrees(model_ends_at_attack_rad), 1));
}

std::string where_it_ends(ModelEnd end) {
  switch (end) {
    case ModelEnd::mach: return "to " + mach_end();
    case ModelEnd::stability: return "for a stable rocket";
    case ModelEnd::attack: break;
  }
  return fmt::format("to {} deg", attack_end());
}

std::string are(ModelEnd end) {
  switch (end) {
    case ModelEnd::mach: return "are faster than " + mach_end();
    case ModelEnd::stability: return "are of a rocket that is not stable";
    case ModelEnd::attack: break;
  }
  return fmt::format("meet the air at more than {} deg", attack_end());
}

std::string asked(ModelEnd end) {
  switch (end) {
    case ModelEnd::mach: return "at most " + mach_end();
    case ModelEnd::stability: return "a static margin above zero";
    case ModelEnd::attack: break;
  }
  return fmt::format("an angle of attack of at most {} deg under control", attack_end());
}

/// A clause for each end that the flight is beyond.
template <typename ClauseOf>
std::string clauses(const Extremes& worst, const char* between, ClauseOf clause_of) {
  std::string all;
  for (const ModelEnd end : model_ends) {
    if (is_beyond(end, worst)) {
      all += (all.empty() ? "" : between) + clause_of(end);
    }
  }
  return all;
}

}  // namespace

bool is_beyond(ModelEnd end, const Extremes& extremes) {
  switch (end) {
    case ModelEnd::mach: return extremes.top_mach.value_or(0.0) > model_ends_at_mach;
    case ModelEnd::stability: return extremes.static_margin_calibres.value_or(1.0) <= 0.0;
    case ModelEnd::attack: break;
  }
  return extremes.angle_of_attack_rad.value_or(0.0) > model_ends_at_attack_rad;
}

bool is_beyond_model(const Extremes& extremes) {
  return std::ranges::any_of(model_ends, [&](ModelEnd end) { return is_beyond(end, extremes); });
}

Extremes worst_of(const std::vector<Extremes>& flights) {
  const auto farther = [](std::optional<double>& all, const std::optional<double>& one, bool is_worse) {
    all = one && (!all || is_worse) ? one : all;
  };
  Extremes worst;
  for (const Extremes& one : flights) {
    farther(worst.top_mach, one.top_mach, one.top_mach > worst.top_mach);
    farther(worst.static_margin_calibres, one.static_margin_calibres,
            one.static_margin_calibres < worst.static_margin_calibres);
    farther(worst.angle_of_attack_rad, one.angle_of_attack_rad, one.angle_of_attack_rad > worst.angle_of_attack_rad);
  }
  return worst;
}

std::string how_far_beyond(const Extremes& worst) {
  return clauses(worst, "; ", [&worst](ModelEnd end) {
    return fmt::format("{}{}, but the simulation of roll is valid only {}",
                       end == ModelEnd::stability ? "not stable, " : "", how_far(end, worst), where_it_ends(end));
  });
}

std::string outside_model(const std::string& beyond) {
  return beyond.empty() ? "" : fmt::format("Outside the model: {}. ", beyond);
}

std::string which_are_beyond(const std::vector<Extremes>& runs) {
  const Extremes worst = worst_of(runs);
  return clauses(worst, ". ", [&](ModelEnd end) {
    const auto count = std::ranges::count_if(runs, [end](const Extremes& run) { return is_beyond(end, run); });
    return fmt::format("{} of {} {}, {}", count, text::counted(runs.size(), "run"), are(end), how_far(end, worst));
  });
}

std::string what_the_model_asks(const Extremes& worst) { return clauses(worst, ", ", asked); }

}  // namespace fantail::flight
