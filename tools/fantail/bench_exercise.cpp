// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "bench/exercise.hpp"
#include "bench/gate.hpp"
#include "bench/perform.hpp"
#include "bench/sheet.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/bench_page.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "link/plan_transfer.hpp"
#include "link/session.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct ExerciseOptions {
  BenchOptions bench;
  PageOptions page;
  std::string vehicle;
  std::string plan;
  std::string out;
  std::optional<int> canard;  ///< from 1; empty: every one
  double to_deg = 5.0;
  double amplitude_deg = 3.0;
  double frequency_hz = 2.0;
  int cycles = 5;
};

using MakeExercise = std::function<bench::Exercise(const bench::Bounds&, const ExerciseOptions&)>;

std::size_t index(const ExerciseOptions& options) { return static_cast<std::size_t>(options.canard.value_or(1) - 1); }

bench::Exercise limits(const bench::Bounds& bounds, const ExerciseOptions& options) {
  return options.canard ? bench::Exercise::limits_of(bounds, index(options)) : bench::Exercise::limits(bounds);
}

bench::Exercise step(const bench::Bounds& bounds, const ExerciseOptions& options) {
  return bench::Exercise::step(bounds, index(options), degree * options.to_deg);
}

bench::Exercise sine(const bench::Bounds& bounds, const ExerciseOptions& options) {
  return bench::Exercise::sine(bounds, index(options),
                               {.amplitude_rad = degree * options.amplitude_deg,
                                .frequency_hz = options.frequency_hz,
                                .cycles = options.cycles});
}

// After the exercise the canards are centred before anything else happens, and after an interrupt too.
link::Recording perform(const bench::Exercise& exercise, const ExerciseOptions& options, link::Session& session,
                        link::AvionicsLink& link, BenchPage& page) {
  Progress progress{"moving the canards", {.unit = "s", .rate = " x real time", .total = exercise.duration_s()}};
  double seconds = 0.0;
  try {
    link::Recording recording = bench::perform(
        exercise, session, link,
        [&](double done_s) {
          seconds = done_s;
          progress.show(done_s);
          page.progress(done_s);
        },
        [&](const link::Tick& tick) { page.take(tick); });
    if (!session.close()) {
      say("fantail: " + options.bench.interface + ": the avionics did not confirm that the canards are centred\n");
    }
    return recording;
  } catch (const bench::TooSlow& error) {
    throw bench::TooSlow{error.what() + bench::advice(exercise, seconds)};
  } catch (const Interrupted&) {
    throw Interrupted{centre_after_interrupt(session)};
  }
}

template <typename Work>
auto or_usage(const Work& work) {
  try {
    return work();
  } catch (const std::invalid_argument& error) {
    throw UsageError{error.what()};
  }
}

// What can be asked of no canard is said before the rocket is looked for, and so is a sine that would show nothing. A
// step goes from the trim, which only the rocket knows.
void expect_possible(const ExerciseOptions& options, const MakeExercise& make,
                     const sim::CanardTolerances& tolerances) {
  or_usage([&] {
    bench::Bounds widest;
    widest.limit_rad.fill(degree * bench::widest_request_deg);
    const bench::Exercise what = make(widest, options);
    if (what.kind() == bench::ExerciseKind::sine) {
      bench::expect_enough_movement(what, index(options), tolerances);
    }
  });
}

// The session ends with it, so what it throws is caught with the canards told to go to their centres.
void exercise(const ExerciseOptions& options, const MakeExercise& make, const std::filesystem::path& folder,
              Desk& on_desk, CanPlace& place, link::AvionicsLink& link, BenchPage& page) {
  page.wait_for_viewer();
  const auto session = open_session(place, link);
  const bench::Bounds bounds = bench::bounds(link.reported<protocol::LimitReport>("canard limits"), session->trims());
  const bench::Exercise what = or_usage([&] {
    bench::Exercise made = make(bounds, options);
    bench::expect_enough_movement(made, index(options), on_desk.tolerances);
    return made;
  });
  complete(on_desk.heading, options.bench, link);
  page.begin(what, on_desk.tolerances, on_desk.heading);
  const link::Recording recording = perform(what, options, *session, link, page);
  complete(on_desk.heading, options.bench, link);
  const bench::Sheet sheet = bench::examine(recording, what, on_desk.tolerances, on_desk.heading);
  const std::string json = bench::sheet_json(sheet, made_with({}));
  const std::array<text::NamedFile, 3> files{{{"sheet.html", bench::sheet_html(sheet, recording, what)},
                                              {"sheet.json", json},
                                              {"sheet.csv", bench::sheet_csv(recording, what)}}};
  text::OutputFolder{folder}.write(files);
  const std::string viewers = page.finish(sheet, recording, what);
  if (options.bench.json) {
    fmt::print("{}", json);
  } else {
    show("{}\n  sheet  {}\n{}", painted_decision(bench::sheet_text(sheet, output_columns())),
         (folder / "sheet.html").string(), viewers.empty() ? "" : "  page   " + viewers + "\n");
  }
  if (sheet.judgement() == bench::Judgement::none) {
    throw link::LinkError{"no verdict: " + sheet.doubts.front()};
  }
  if (!sheet.passed()) {
    throw RequirementNotMet{""};
  }
}

void run(const ExerciseOptions& options, const MakeExercise& make) {
  Desk on_desk = desk(options.vehicle, options.plan);
  expect_possible(options, make, on_desk.tolerances);
  const std::filesystem::path folder = options.out.empty() ? std::string{"out/bench"} : options.out;
  expect_room(folder, "the sheet with --out");
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  expect_plan_in_force(on_desk, options.bench, link);
  on_desk.heading.gate = bench::gate(link::read_plan_in_force(place, link).plan);
  BenchPage page{options.page, (on_desk.heading.vehicle.empty() ? "Rocket" : on_desk.heading.vehicle) + " on " +
                                   options.bench.interface};
  try {
    exercise(options, make, folder, on_desk, place, link, page);
  } catch (const bench::Unmeasured& error) {
    page.give_up(error.what(), false);
    throw;
  } catch (const text::OutputError& error) {
    page.give_up(error.what(), false);
    throw;
  } catch (const std::exception& error) {
    page.give_up(error.what(), true);
    throw;
  }
}

Verb add(const Verb& bench, const char* name, const char* meaning, const std::shared_ptr<ExerciseOptions>& options,
         const MakeExercise& make) {
  const Verb verb = bench.verb(name, meaning);
  add_bench_options(verb, options->bench, "Print sheet.json instead of the text");
  add_desk_options(verb, options->vehicle, options->plan);
  add_page_options(verb, options->page, "the canards, and the sheet as it fills,");
  verb.option("--out", options->out, "Folder for sheet.html, sheet.json and sheet.csv [out/bench]").offers(folders);
  verb.action([options, make] { run(*options, make); });
  return verb;
}

void add_canard(const Verb& verb, ExerciseOptions& options) {
  verb.option("--canard", options.canard, "Which canard").range(1, 4).required().value_name("1..4");
}

}  // namespace

void add_bench_limits(const Verb& bench) {
  auto options = std::make_shared<ExerciseOptions>();
  const Verb verb =
      add(bench, "limits", "Move every canard to both limits, alone and together; makes a pass/fail sheet", options,
          limits);
  verb.option("--canard", options->canard, "Only this canard, for example after a repair [all four]")
      .range(1, 4)
      .value_name("1..4");
  verb.examples(
      "Examples:\n"
      "  fantail bench limits --can can0 --vehicle my_rocket.toml   half a minute; exit code 1 if a canard fails\n"
      "  fantail bench limits --can can0 --canard 3                 one canard alone, in a few seconds\n"
      "  fantail bench limits --can can0 --plan tasha3_launch2      refused if the rocket has another plan\n"
      "  fantail bench limits --can can0 --page                     watch the sheet fill in a browser\n"
      "  fantail bench limits --can vcan0 --json --out out/rehearsal  for a script");
}

void add_bench_step(const Verb& bench) {
  auto options = std::make_shared<ExerciseOptions>();
  const Verb verb = add(bench, "step", "Move one canard to an angle in one step, and back", options, step);
  add_canard(verb, *options);
  verb.option("--to", options->to_deg, "Shaft angle; far enough from the trim that tolerances do not hide the step")
      .range(-bench::widest_request_deg, bench::widest_request_deg)
      .value_name("DEG")
      .show_default();
  verb.examples(
      "Examples:\n"
      "  fantail bench step --can can0 --canard 2             5 deg and back\n"
      "  fantail bench step --can can0 --canard 2 --to -8     to the other side\n"
      "  fantail bench step --can vcan0 --canard 1 --json     rise time and slew rate, for a script");
}

void add_bench_sine(const Verb& bench) {
  auto options = std::make_shared<ExerciseOptions>();
  const Verb verb = add(bench, "sine", "Move one canard in a sine: amplitude ratio and phase lag", options, sine);
  add_canard(verb, *options);
  verb.option("--amplitude", options->amplitude_deg,
              "Amplitude about the centre; large enough that tolerances do not hide it")
      .range(0.1, bench::widest_request_deg)
      .value_name("DEG")
      .show_default();
  verb.option("--frequency", options->frequency_hz, "").range(0.05, 50.0).value_name("HZ").show_default();
  verb.option("--cycles", options->cycles, "Number of cycles; 0.1 to 60 s in total").range(1, 3000).show_default();
  verb.examples(
      "Examples:\n"
      "  fantail bench sine --can can0 --canard 3                              3 deg, 2 Hz, five times\n"
      "  fantail bench sine --can can0 --canard 3 --frequency 8 --cycles 20    the chirp's highest frequency\n"
      "  fantail bench sine --can vcan0 --canard 1 --amplitude 6 --json        for a script");
}

}  // namespace fantail::tool
