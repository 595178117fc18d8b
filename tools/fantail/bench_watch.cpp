// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "bench/watch.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/live_screen.hpp"
#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"

namespace fantail::tool {
namespace {

struct WatchOptions {
  BenchOptions bench;
  std::optional<double> seconds;
};

// A person reads a few times a second, a log once.
constexpr hal::Microseconds screen_period{200'000};
constexpr hal::Microseconds line_period{1'000'000};

void watch(const WatchOptions& options) {
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  bench::Watch watch{options.bench.interface, link, place.bus()};
  if (options.bench.wait_s) {
    try {
      await_rocket(options.bench, place, link);
    } catch (const Interrupted&) {  // the way to end it
      return;
    }
  }
  std::optional<LiveScreen> screen;
  if (!options.bench.json && output_is_screen()) {
    screen.emplace();
  }
  const hal::Microseconds period = screen ? screen_period : line_period;
  const hal::Microseconds end = options.seconds
                                    ? place.now() + hal::Microseconds{static_cast<std::int64_t>(1e6 * *options.seconds)}
                                    : hal::Microseconds::max();
  try {
    for (hal::Microseconds next = place.now() + period;; next = std::max(next + period, place.now())) {
      do {
        place.wait(std::max(next - place.now(), hal::Microseconds{0}));
        // All of it, also when this process was held up: else the load would be that of a time that is over.
        while (link.listen(place.now())) {
        }
      } while (place.now() < next);
      link.expect_one_rocket();  // else the rows would be of both
      watch.look(place.now());
      const bool is_seen = screen ? screen->draw(painted_phase(watch.table()))
                                  : show_live(options.bench.json ? watch.json() : watch.line());
      if (!is_seen || place.now() >= end) {
        return;
      }
    }
  } catch (const Interrupted&) {  // NOLINT(bugprone-empty-catch): the way to end it
  }
}

}  // namespace

void add_bench_watch(const Verb& bench) {
  auto verb = bench.verb("watch", "Show canards, phase, bus load and errors live; one line a second in a pipe");
  auto options = std::make_shared<WatchOptions>();
  add_bench_options(verb, options->bench, "Print one JSON object a second, one per line");
  add_end_option(verb, options->seconds);
  verb.examples(
      "Examples:\n"
      "  fantail bench watch --can can0                   a live table; Ctrl-C ends\n"
      "  fantail bench watch --can can0 | tee pad.log     a line a second\n"
      "  fantail bench watch --can vcan0 --json --for 10  ten objects, for a script");
  verb.action([options] { watch(*options); });
}

}  // namespace fantail::tool
