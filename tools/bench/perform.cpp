// SPDX-License-Identifier: MIT
#include "bench/perform.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <fmt/core.h>

#include "bench/punctuality.hpp"

namespace fantail::bench {
namespace {

// What a busy PC slept through is not asked for all at once: a hold that nobody saw begin would be too short to
// measure.
constexpr double longest_stride_s = 0.02;

// A sine has no holds, and must keep its frequency.
double latest_s(const Exercise& exercise, double done_s) {
  const Stretch& stretch = exercise.stretches()[exercise.stretch_at(done_s)];
  return stretch.part == Part::sine ? std::max(stretch.end_s, done_s + longest_stride_s) : done_s + longest_stride_s;
}

link::Recording record(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                       const std::function<void(double)>& progress,
                       const std::function<void(const link::Tick&)>& seen) {
  link::Recording recording;
  link.forget_ticks();
  Punctuality punctuality{link, session.now()};
  std::optional<std::int64_t> last;
  double done_s = 0.0;
  session.request(exercise.asked(0.0));
  while (done_s < exercise.duration_s()) {
    session.wait();
    punctuality.begin_look(session.now());
    // What has come since the last look was done under the request of that look, however long ago it was.
    const std::size_t stretch = exercise.stretch_at(done_s);
    const double end_s = latest_s(exercise, done_s);
    while (auto tick = link.take_tick()) {
      done_s = std::min(done_s + 1e-3 * static_cast<double>(tick->number - last.value_or(tick->number)), end_s);
      last = tick->number;
      tick->stretch = stretch;
      punctuality.note(*tick);
      if (recording.add(*tick) && seen) {
        seen(*tick);
      }
    }
    punctuality.end_look();
    session.request(exercise.asked(done_s));
    progress(done_s);
  }
  punctuality.end();
  return recording;
}

}  // namespace

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

link::Recording perform(const Exercise& exercise, link::Session& session, link::AvionicsLink& link,
                        const std::function<void(double)>& progress,
                        const std::function<void(const link::Tick&)>& seen) {
  try {
    return record(exercise, session, link, progress, seen);
  } catch (const Unmeasured&) {
    session.request({});  // all to their trims
    // A second rocket on the bus spoils a recording before its clock tells that it is there.
    session.look_for_second_rocket();
    throw;
  }
}

}  // namespace fantail::bench
