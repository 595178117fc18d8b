// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "fantail/command_line.hpp"
#include "fantail/deliver.hpp"
#include "fantail/log_options.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/tunnel_options.hpp"
#include "logs/flight_file.hpp"
#include "text/error.hpp"
#include "tunnel/swirl.hpp"

namespace fantail::tool {
namespace {

constexpr const char* swirl_folder = "out/tunnel/swirl";

struct SessionOptions {
  std::string roll;
  std::string wind;
  std::string steady;
};

struct SwirlVerbOptions {
  SessionOptions without;
  SessionOptions with;
  LogOptions logs;
  std::optional<double> alpha_m2;
  std::optional<double> beta_m;
  double from_speed_m_s = tunnel::SwirlOptions{}.from_speed_m_s;
  tunnel::SteadyOptions finding;
  TunnelOutput output;
};

tunnel::RollSession read(const SessionOptions& options, const SwirlVerbOptions& all) {
  tunnel::RollSession session;
  session.roll = logs::read_roll_log(options.roll, reading(all.logs), {.roll_angle = false, .roll_rate = true});
  save_columns(all.logs, options.roll);
  session.wind = tunnel::wind_of(session.roll, options.roll, options.wind, all.logs.truth);
  if (session.wind.fan_rpm.empty() && options.steady.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      options.roll +
                          ": the speeds come from the log itself, which does not contain the fan speed; give the "
                          "steady times with --steady-without and --steady-with"};
  }
  session.steady = steady_segments(session.wind, options.steady, all.finding);
  return session;
}

/// Which rocket rolled, or an empty text; with what was changed of its roll on the command line, and with its file
/// where that is not the shipped one. A flight log has the name alone, which a copy may have kept.
std::string rocket_of(const SessionOptions& options, const logs::RollLog& log, const logs::Reading& reading) {
  const auto flown = logs::flown_airframe(options.roll, reading);
  if (!flown) {
    return log.vehicle.empty() ? "" : log.vehicle + ", whose file is not named";
  }
  if (flown->vehicle_file != "tasha3_tunnel") {
    return fmt::format("{} (vehicle {})", flown->vehicle,
                       flown->vehicle_file.empty() ? "unknown" : flown->vehicle_file);
  }
  const auto changed = std::ranges::find_if(
      flown->changes, [](const std::string& change) { return change.starts_with("aerodynamics."); });
  return changed == flown->changes.end() ? flown->vehicle : flown->vehicle + " with " + *changed;
}

/// Nobody's roll is assumed but that of the rocket which the published numbers are of.
tunnel::OwnRoll roll_of(const SwirlVerbOptions& options, const tunnel::SwirlSessions& sessions) {
  if (options.alpha_m2 && options.beta_m) {
    return {.alpha_m2 = *options.alpha_m2, .beta_m = *options.beta_m, .source = "as given"};
  }
  for (const auto& [typed, read] :
       {std::pair{&options.without, &sessions.without}, std::pair{&options.with, &sessions.with}}) {
    const std::string rocket = rocket_of(*typed, read->roll, reading(options.logs));
    if (rocket != "Tasha III, wind tunnel") {
      throw UsageError{fmt::format(
          "{}: {}, and the published damping and torque constant are those of Tasha III only. Give its own with "
          "--alpha M2 and --beta M; fantail tunnel steps finds both, as the means of its table",
          typed->roll,
          rocket.empty() ? "the rocket that rolled here is unknown" : "the rocket that rolled here is " + rocket)};
    }
  }
  return tunnel::published_roll();
}

void swirl(const SwirlVerbOptions& options) {
  Chapters chapters{"tunnel swirl", 3, "reading the run without straightener"};
  tunnel::SwirlSessions sessions{.without = read(options.without, options), .with = {}};
  chapters.next("reading the run with straightener");
  sessions.with = read(options.with, options);
  chapters.next("comparing the two runs and writing the page");
  const tunnel::Swirl swirl = tunnel::examine_swirl(
      sessions.without, sessions.with, {.roll = roll_of(options, sessions), .from_speed_m_s = options.from_speed_m_s});
  const std::vector<std::filesystem::path> made_from{options.without.roll, options.without.wind, options.with.roll,
                                                     options.with.wind};
  const result::Document document = tunnel::swirl_answer(sessions, swirl, made_with(made_from));
  chapters.end();
  deliver(document, delivery(options.output, swirl_folder, "swirl", made_from));
}

void add_session(const Verb& verb, const std::string& word, SessionOptions& options) {
  verb.option("--wind-" + word, options.wind,
              "The tunnel's log of that session, instead of the tunnel.csv beside the roll log or its own speeds")
      .offers(files)
      .value_name("FILE");
  add_steady_option(verb, "--steady-" + word, options.steady,
                    "Steady times of that session, instead of finding them: beginnings in seconds, or begin:end");
}

}  // namespace

void add_tunnel_swirl(const Verb& tunnel) {
  auto verb = tunnel.verb("swirl", "Fin offset due to swirl, from free rolling");
  auto options = std::make_shared<SwirlVerbOptions>();
  verb.option("WITHOUT", options->without.roll,
              "Roll log without flow straightener: a flight folder, a flight log (.ftl), or a CSV, MAT or Parquet file")
      .offers(files)
      .required();
  verb.option("WITH", options->with.roll, "Roll log with flow straightener").offers(files).required();
  verb.section("Wind and windows of each session");
  add_session(verb, "without", options->without);
  add_session(verb, "with", options->with);
  verb.section("Roll model");
  auto alpha = verb.option("--alpha", options->alpha_m2,
                           "Damping of the rocket that rolled, from fantail tunnel steps [published 19.4 for the "
                           "shipped Tasha III, wind tunnel]");
  auto beta = verb.option("--beta", options->beta_m, "Torque constant, likewise [published 9.6 for that rocket]");
  alpha.check(within(1e-6, 1e6)).value_name("M2").needs(beta);
  beta.check(within(1e-6, 1e6)).value_name("M").needs(alpha);
  verb.option("--from-speed", options->from_speed_m_s, "The swirl is the mean difference from this speed on")
      .check(within(0.0, 1e4))
      .value_name("M/S")
      .show_default();
  verb.section("Columns of the logs");
  add_log_options(verb, options->logs);
  verb.section("Results");
  add_tunnel_output(verb, options->output, swirl_folder);
  verb.examples(
      "Examples:\n"
      "  fantail tunnel swirl out/tunnel_swirl_without out/tunnel_swirl_with\n"
      "                                     the sessions of fantail fly\n"
      "  fantail tunnel swirl bare.csv crate.csv --wind-without bare_wind.csv --wind-with crate_wind.csv \\\n"
      "      --alpha 0.097 --beta 0.06      rocket and tunnel logged apart, on one clock\n"
      "  fantail tunnel swirl out/tunnel_swirl_without out/tunnel_swirl_with --alpha 23 --beta 9 --json\n"
      "                                     with another rocket's roll model, for a script");
  verb.action([options] { swirl(*options); });
}

}  // namespace fantail::tool
