// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "listen/heard.hpp"

namespace fantail::listen {

/// Mean before lift-off; of a log without one, of all of it.
[[nodiscard]] std::optional<double> pad_mean(const Heard& heard, const Signal& signal);

struct Rest {
  double mean_m_s2 = 0.0;
  std::string where{};  ///< "Before lift-off", begins a sentence
};

/// What an axial force reads at rest: before lift-off; of a log that is not known to have any of that, at its
/// beginning.
[[nodiscard]] std::optional<Rest> at_rest(const Heard& heard, const Signal& axial);

}  // namespace fantail::listen
