// SPDX-License-Identifier: MIT
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "bench/exercise.hpp"
#include "bench/perform.hpp"
#include "bench/sheet.hpp"
#include "bench/zero.hpp"
#include "fantail/bench_desk.hpp"
#include "fantail/can_place.hpp"
#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "link/plan_transfer.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ZeroOptions {
  BenchOptions bench;
  std::string plan;
  std::string write;
  std::string trusted = "encoder";
};

constexpr std::size_t runs = 3;

using Readings = link::Each<std::vector<bench::ZeroRun>>;

// Each canard alone, one after the other, and all of that again: what differs between the runs is the uncertainty.
Readings measure(link::Session& session, link::AvionicsLink& link, const sim::CanardTolerances& tolerances) {
  const bench::Bounds bounds = bench::bounds(link.reported<protocol::LimitReport>("canard limits"), session.trims());
  const double lap_s = bench::Exercise::limits_of(bounds, 0).duration_s();
  Progress progress{"moving the canards",
                    {.unit = "s", .rate = " x real time", .total = lap_s * static_cast<double>(4 * runs)}};
  Readings readings;
  double done_s = 0.0;
  for (std::size_t run = 0; run < runs; ++run) {
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      const auto exercise = bench::Exercise::limits_of(bounds, canard);
      const link::Recording recording =
          bench::perform(exercise, session, link, [&](double in_lap_s) { progress.show(done_s + in_lap_s); });
      session.wait();
      const bench::ZeroReading reading =
          bench::zero_reading(bench::examine(recording, exercise, tolerances, {}), canard);
      if (!reading.run) {
        throw RequirementNotMet{reading.refusal + " Nothing was written."};
      }
      readings[canard].push_back(*reading.run);
      session.wait();
      done_s += lap_s;
    }
  }
  return readings;
}

std::string list(const std::array<bench::ZeroFields, core::canard_count>& fields,
                 bench::Measured bench::ZeroFields::* field, int decimals) {
  std::string text;
  for (const bench::ZeroFields& each : fields) {
    text += fmt::format("{}{:.{}f}", text.empty() ? "[" : ", ", (each.*field).value, decimals);
  }
  return text + "]";
}

core::FlightPlan with_zeros(const core::FlightPlan& plan, std::span<const bench::CanardZero> zeros,
                            bench::Trusted trusted) {
  std::array<bench::ZeroFields, core::canard_count> fields;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    fields[i] = bench::measured_fields(plan.canards.each[i], zeros[i], trusted);
  }
  std::vector<input::Override> changes{
      {"canards", "pulse_per_degree_us", list(fields, &bench::ZeroFields::pulse_per_degree_us, 4)}};
  changes.push_back(
      trusted == bench::Trusted::encoder
          ? input::Override{"canards", "pulse_centre_us", list(fields, &bench::ZeroFields::pulse_centre_us, 2)}
          : input::Override{"canards", "encoder_zero_deg", list(fields, &bench::ZeroFields::encoder_zero_deg, 3)});
  try {
    return input::changed_plan(plan, changes);
  } catch (const text::Error& error) {
    throw RequirementNotMet{std::string{"no plan can have the measured values, so none was written: "} + error.what()};
  }
}

// Before any canard moves.
void expect_new_file(const std::string& file) {
  std::error_code ignored;
  if (!file.empty() && std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    throw text::OutputError{file + ": exists, and no plan is overwritten; choose another name for the new plan"};
  }
  if (!file.empty()) {
    const std::filesystem::path folder = std::filesystem::path{file}.parent_path();
    expect_room(folder.empty() ? std::filesystem::path{"."} : folder, "the plan with --write");
  }
}

void write_plan(const std::string& name, const core::FlightPlan& plan) {
  const std::filesystem::path file{name};
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path{"."};
  const std::array<text::NamedFile, 1> files{{{file.filename().string(), input::plan_table(plan)}}};
  expect_new_file(name);  // somebody may have made it meanwhile
  text::OutputFolder{folder}.write(files);
}

void zero(const ZeroOptions& options) {
  const Desk on_desk = desk("", options.plan);
  expect_new_file(options.write);
  const auto trusted = options.trusted == "servo" ? bench::Trusted::servo : bench::Trusted::encoder;
  CanPlace place{options.bench.interface};
  link::AvionicsLink link{place.bus()};
  await_rocket(options.bench, place, link);
  expect_plan_in_force(on_desk, options.bench, link);
  const core::FlightPlan plan = link::read_plan_in_force(place, link).plan;
  std::vector<bench::CanardZero> zeros;
  {
    const auto session = open_session(place, link);
    try {
      for (const auto& canard : measure(*session, link, on_desk.tolerances)) {
        zeros.push_back(bench::combined(canard));
      }
    } catch (const Interrupted&) {
      throw Interrupted{centre_after_interrupt(*session) + "; nothing was written"};
    }
    if (!session->close()) {
      say("fantail: " + options.bench.interface + ": the avionics did not confirm that the canards are centred\n");
    }
  }
  if (options.bench.json) {
    fmt::print("{}", bench::zero_json(zeros, plan.canards, trusted, made_with({})));
  } else {
    show_text(bench::zero_text(zeros, plan.canards, trusted));
  }
  if (!options.write.empty()) {
    write_plan(options.write, with_zeros(plan, zeros, trusted));
    if (!options.bench.json) {
      show("\n  plan  {}\n", options.write);
    }
  }
}

}  // namespace

void add_bench_zero(const Verb& bench) {
  auto verb = bench.verb(
      "zero", "Measure centre and scale of each canard against its encoder; can write them into a new plan file");
  auto options = std::make_shared<ZeroOptions>();
  add_bench_options(verb, options->bench, "Print one JSON object");
  verb.option("--plan", options->plan, "The plan that must be in force: a shipped name or a path")
      .offers(shipped(input::Shipped::plan))
      .value_name("PLAN");
  verb.option("--write", options->write, "New plan file: the plan in force with the measured values")
      .offers(files)
      .value_name("FILE");
  verb.option("--trust", options->trusted, "Which of the two is right at the centre; the other one is corrected")
      .one_of({"encoder", "servo"})
      .show_default();
  verb.examples(
      "Examples:\n"
      "  fantail bench zero --can can0                          a minute of movement; writes nothing\n"
      "  fantail bench zero --can can0 --write my_plan_2.toml   the plan in force, its servo pulses corrected\n"
      "  fantail bench zero --can can0 --trust servo --write my_plan_2.toml   its encoder zeros corrected instead");
  verb.action([options] { zero(*options); });
}

}  // namespace fantail::tool
