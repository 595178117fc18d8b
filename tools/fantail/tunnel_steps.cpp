// SPDX-License-Identifier: MIT
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "fantail/airframe_options.hpp"
#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/log_options.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/tunnel_options.hpp"
#include "identify/doubts.hpp"
#include "input/messages.hpp"
#include "sim/atmosphere.hpp"
#include "tunnel/steps.hpp"

namespace fantail::tool {
namespace {

constexpr const char* steps_folder = "out/tunnel/steps";

struct StepsVerbOptions {
  std::string run;
  LogOptions logs;
  AirframeOptions airframe;
  std::optional<double> speed_m_s;
  std::string wind;
  std::optional<double> density_kg_m3;
  std::optional<double> elevation_m;
  std::string method = "continuous";
  std::string initial = "fitted";
  std::string only;
  tunnel::StepOptions steps;
  TunnelOutput output;
};

tunnel::StepsHeading heading(const StepsVerbOptions& options, const logs::RollLog& log, const NamedAirframe& frame) {
  tunnel::StepsHeading heading{.log = log.name,
                               .vehicle = frame.vehicle,
                               .airframe_source = frame.name,
                               .airframe = frame.airframe,
                               .density_kg_m3 = options.density_kg_m3.value_or(1.2),
                               .density_source = options.density_kg_m3 ? "--density" : "the default",
                               .options = options.steps};
  heading.options.method =
      options.method == "grid" ? identify::result::Method::grid : identify::result::Method::continuous;
  heading.options.start =
      options.initial == "fitted" ? identify::model::Start::fitted : identify::model::Start::measured;
  heading.options.direction = options.only.empty()   ? tunnel::Direction::both
                              : options.only == "up" ? tunnel::Direction::up
                                                     : tunnel::Direction::down;
  const tunnel::StepSpeed speed = tunnel::speed_of_steps(
      log, options.run, {.speed_m_s = options.speed_m_s, .wind = options.wind, .truth = options.logs.truth});
  heading.speed_m_s = speed.speed_m_s;
  heading.speed_source = speed.source;
  heading.options.record.speed_m_s = speed.speed_m_s;
  if (options.elevation_m) {
    heading.density_kg_m3 = sim::Atmosphere{.model = sim::DensityModel::isa}.density_kg_m3(*options.elevation_m);
    heading.density_source =
        fmt::format("standard atmosphere at {} m above the sea", input::plain_number(*options.elevation_m));
  }
  heading.options.record.density_kg_m3 = heading.density_kg_m3;
  return heading;
}

void steps(const StepsVerbOptions& options) {
  logs::RollLog log = logs::read_roll_log(options.run, reading(options.logs), {.canard = true});
  save_columns(options.logs, options.run);
  const NamedAirframe frame = named_airframe(options.airframe, options.run, reading(options.logs));
  log.warnings.insert(log.warnings.end(), frame.warnings.begin(), frame.warnings.end());
  tunnel::StepsHeading head = heading(options, log, frame);
  head.options.record.roll_inertia = frame.flown_inertia.empty()
                                         ? identify::inertia_on_clock(log, frame.inertia_since_ignition, log.warnings)
                                         : frame.flown_inertia;
  std::optional<Progress> progress;
  const auto tell = [&](std::size_t done, std::size_t of) {
    give_up_if_interrupted();
    if (!progress) {
      progress.emplace("identifying the steps of " + options.run,
                       Progress::Measure{.unit = "steps", .rate = " a second", .total = static_cast<double>(of)});
    }
    progress->show(static_cast<double>(done));
  };
  const tunnel::StepTable table = tunnel::identify_steps(log, head.airframe, head.options, tell);
  progress.reset();
  deliver(tunnel::steps_answer(head, table, made_with({options.run, options.wind})),
          delivery(options.output, steps_folder, "steps", {options.run, options.wind}, {"page", "steps"}));
}

void add_run_options(const Verb& verb, StepsVerbOptions& options) {
  verb.option("RUN", options.run,
              "A flight folder, a flight log (.ftl), or a CSV, MAT or Parquet file with reference_deg and canard_deg")
      .offers(files)
      .required();
  verb.section("Rocket and air");
  add_airframe_options(verb, options.airframe);
  verb.option("--speed", options.speed_m_s, "Wind speed, instead of tunnel.csv's mean or the log's own")
      .check(within(0.1, 1000.0))
      .value_name("M/S");
  verb.option("--wind", options.wind, "The tunnel's log, instead of the tunnel.csv beside the run")
      .offers(files)
      .value_name("FILE");
  auto density =
      verb.option("--density", options.density_kg_m3, "Air density [1.2]").check(within(0.01, 5.0)).value_name("KG/M3");
  verb.option("--elevation", options.elevation_m,
              "Height of the tunnel above sea level: sets the density to the standard atmosphere there")
      .check(within(-500, 9000))
      .value_name("M")
      .excludes(density);
  verb.section("Columns of the log");
  add_log_options(verb, options.logs);
}

void add_method_options(const Verb& verb, StepsVerbOptions& options) {
  verb.option("--seconds", options.steps.seconds, "Time from the start of each step that is used")
      .check(within(0.05, 600.0))
      .value_name("S")
      .show_default();
  verb.option("--intervals", options.steps.intervals,
              "Number of intervals of the disturbance in each step; 0: it is constant")
      .check(within(0, 20))
      .show_default();
  verb.option("--method", options.method, "continuous, or the published search on a grid")
      .one_of({"continuous", "grid"})
      .value_name("continuous|grid")
      .show_default();
  verb.option("--initial", options.initial,
              "Angle and rate at the start of each step: fitted, or as measured (as published)")
      .one_of({"fitted", "measured"})
      .value_name("fitted|measured")
      .show_default();
  verb.option("--only", options.only, "Steps in one direction only").one_of({"up", "down"}).value_name("up|down");
  verb.option("--lag", options.steps.record.lag_s, "Time by which the canard column lags the gyro's")
      .check(within(-1.0, 1.0))
      .value_name("S")
      .show_default();
}

}  // namespace

void add_tunnel_steps(const Verb& tunnel) {
  auto verb = tunnel.verb("steps", "The roll model of every step of a square-wave run, and their spread");
  auto options = std::make_shared<StepsVerbOptions>();
  add_run_options(verb, *options);
  verb.section("Steps and method");
  add_method_options(verb, *options);
  verb.section("Results");
  add_tunnel_output(verb, options->output, steps_folder);
  verb.examples(
      "Examples:\n"
      "  fantail tunnel steps out/tunnel_steps                    the run of fantail fly tunnel_steps\n"
      "  fantail tunnel steps out/tunnel_steps --method grid --only up\n"
      "                                                           by the published method, steps up only\n"
      "  fantail tunnel steps run.csv --speed 22 --inertia 0.00393 --area 5.0265e-5 --json\n"
      "                                                           another logger's file, for a script");
  verb.action([options] { steps(*options); });
}

}  // namespace fantail::tool
