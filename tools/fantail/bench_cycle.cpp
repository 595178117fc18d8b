// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <unistd.h>

#include "bench/cycle.hpp"
#include "bench/exercise.hpp"
#include "bench/gate.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "link/plan_transfer.hpp"
#include "text/degrees.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct CycleOptions {
  BenchOptions bench;
  std::string vehicle;
  std::string plan;
  std::string out;
  double seconds = 600.0;
};

constexpr double line_period_s = 10.0;

// "120 s of 600: largest tracking error 0.21 deg (canard 2), battery 11.92 V"
std::string line(const bench::Cycle& cycle, double done_s) {
  std::string text =
      fmt::format("fantail: {:.0f} s of {:.0f}", done_s, cycle.lap_s * static_cast<double>(cycle.planned_laps));
  std::optional<double> largest_rad;
  std::size_t where = 0;
  for (std::size_t i = 0; i < core::canard_count; ++i) {
    const auto here = bench::tracking_error_course(cycle, i).worst;
    if (here && (!largest_rad || *here > *largest_rad)) {
      largest_rad = here;
      where = i + 1;
    }
  }
  if (largest_rad) {
    text += fmt::format(": largest tracking error {:.2f} deg (canard {})", text::degrees(*largest_rad), where);
  }
  if (const auto battery_v = bench::battery_course(cycle).last) {
    text += fmt::format(", battery {:.2f} V", *battery_v);
  }
  return text + "\n";
}

/// A line that is kept up to date on a terminal; one every ten seconds in a pipe.
class Teller {
 public:
  explicit Teller(const bench::Cycle& cycle, double all_s)
      : cycle_{cycle}, progress_{"moving the canards", {.unit = "s", .rate = " x real time", .total = all_s}} {}

  void show(double done_s) {
    progress_.show(done_s);
    if (!terminal_ && done_s >= next_s_) {
      next_s_ += line_period_s;
      say(line(cycle_, done_s));
    }
  }

 private:
  const bench::Cycle& cycle_;
  Progress progress_;
  bool terminal_ = ::isatty(STDERR_FILENO) == 1;
  double next_s_ = line_period_s;
};

void write(const bench::Cycle& cycle, const CycleOptions& options, const std::filesystem::path& folder) {
  const std::string json = bench::cycle_json(cycle, made_with({}));
  const std::array<text::NamedFile, 2> files{{{"cycle.json", json}, {"cycle.csv", bench::cycle_csv(cycle)}}};
  text::OutputFolder{folder}.write(files);
  if (options.bench.json) {
    fmt::print("{}", json);
  } else {
    show("{}\n  series  {}\n", painted_decision(bench::cycle_text(cycle, output_columns())),
         (folder / "cycle.csv").string());
  }
}

void run_laps(bench::Cycle& cycle, const bench::Exercise& lap, link::Session& session, link::AvionicsLink& link) {
  Teller teller{cycle, lap.duration_s() * static_cast<double>(cycle.planned_laps)};
  bench::perform_laps(cycle, lap, session, link, [&](double done_s) { teller.show(done_s); });
}

void cycle(const CycleOptions& options) {
  Desk on_desk = desk(options.vehicle, options.plan);
  const std::filesystem::path folder = options.out.empty() ? std::string{"out/cycle"} : options.out;
  expect_room(folder, "the figures with --out");
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  expect_plan_in_force(on_desk, options.bench, link);
  on_desk.heading.gate = bench::gate(link::read_plan_in_force(place, link).plan);
  const auto session = open_session(place, link);
  const auto lap = bench::Exercise::limits_together(
      bench::bounds(link.reported<protocol::LimitReport>("canard limits"), session->trims()));
  complete(on_desk.heading, options.bench, link);
  bench::Cycle result{.heading = on_desk.heading,
                      .tolerances = on_desk.tolerances,
                      .lap_s = lap.duration_s(),
                      .planned_laps = static_cast<std::size_t>(std::ceil(options.seconds / lap.duration_s()))};
  try {
    run_laps(result, lap, *session, link);
  } catch (const Interrupted&) {
    result.ended_because = "interrupted";
    const std::string centred = centre_after_interrupt(*session);
    if (result.laps.empty()) {
      throw Interrupted{centred + "; no lap was complete, and nothing was written"};
    }
    write(result, options, folder);
    throw Interrupted{centred + "; the earlier measurements are in " + folder.string()};
  } catch (const link::LinkError& error) {
    result.ended_because = error.what();
    if (!result.laps.empty()) {
      write(result, options, folder);
    }
    throw;
  }
  if (!session->close()) {
    say("fantail: " + options.bench.interface + ": the avionics did not confirm that the canards are centred\n");
  }
  write(result, options, folder);
  if (bench::judgement(result) != bench::Judgement::pass) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

void add_bench_cycle(const Verb& bench) {
  auto verb = bench.verb("cycle", "Move all canards to their limits repeatedly: lag, tracking and battery over time");
  auto options = std::make_shared<CycleOptions>();
  add_bench_options(verb, options->bench, "Print cycle.json instead of the text");
  verb.option("--for", options->seconds, "Duration; rounded up to whole laps of some seconds")
      .range(1.0, 86'400.0)
      .value_name("SECONDS")
      .show_default();
  add_desk_options(verb, options->vehicle, options->plan);
  verb.option("--out", options->out, "Folder for cycle.json and cycle.csv [out/cycle]").offers(folders);
  verb.examples(
      "Examples:\n"
      "  fantail bench cycle --can can0 --vehicle my_rocket.toml   ten minutes; exit code 1 if a canard fails\n"
      "  fantail bench cycle --can can0 --for 60                   one minute; Ctrl-C ends it and keeps the laps so "
      "far\n"
      "  fantail bench cycle --can vcan0 --for 30 --json           for a script");
  verb.action([options] { cycle(*options); });
}

}  // namespace fantail::tool
