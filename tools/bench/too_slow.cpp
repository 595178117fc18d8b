// SPDX-License-Identifier: MIT
#include "bench/too_slow.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/core.h>

namespace fantail::bench {

std::string advice(const Exercise& exercise, double done_s) {
  // At its end it is voided for what is missing of the whole.
  if (exercise.kind() != ExerciseKind::limits || exercise.turns().size() == 1 || done_s >= exercise.duration_s()) {
    return {};
  }
  double alone_s = 0.0;
  for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
    alone_s = std::max(alone_s, Exercise::limits_of(exercise.bounds(), canard).duration_s());
  }
  return done_s < alone_s
             ? std::string{}
             : fmt::format(". One canard alone, with --canard N, takes {:.1f} s; this PC kept up for {:.1f} s", alone_s,
                           done_s);
}

}  // namespace fantail::bench
