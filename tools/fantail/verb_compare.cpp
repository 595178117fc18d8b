// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "fantail/compare_results.hpp"
#include "fantail/deliver.hpp"
#include "fantail/log_options.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "identify/choices.hpp"
#include "logs/compare.hpp"
#include "logs/flight_file.hpp"
#include "logs/roll_log.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::tool {
namespace {

struct LogChoice {
  std::string path;
  std::string motion = "measured";
  ColumnOptions columns;
};

struct CompareVerbOptions {
  LogChoice a;
  LogChoice b;
  std::optional<double> from_s;
  std::optional<double> to_s;
  std::optional<std::string> window;
  std::string align = "none";
  std::optional<double> shift_s;
  bool remove_offset = false;
  std::optional<double> most_angle_deg;
  std::optional<double> most_rate_deg_s;
  std::string out = "out/compare";
  bool json = false;
  bool save_columns = false;
};

std::string objection_to_requirement(const std::string& text) {
  return text::number(text).value_or(-1.0) >= 0.0 ? "" : '"' + text + "\" is not a number of 0 or more";
}

logs::RollLog read(const LogChoice& choice, const char* dashes) {
  return logs::read_roll_log(choice.path, reading(choice.columns, dashes, choice.motion == "true"), {});
}

logs::CompareOptions question(const CompareVerbOptions& options, const logs::RollLog& a) {
  logs::CompareOptions question{.from_s = options.from_s, .to_s = options.to_s};
  if (options.window) {
    const identify::Window window = identify::find_window(a, *options.window);
    question.from_s = window.from_s;
    question.to_s = window.to_s;
  }
  question.shift_s = options.shift_s.value_or(0.0);
  question.find_shift = options.align == "angle";
  question.remove_offset = options.remove_offset;
  return question;
}

std::optional<double> in_radians(const std::optional<double>& degrees) {
  return degrees ? std::optional{text::radians(*degrees)} : std::nullopt;
}

/// Of what Fantail wrote, its flight log or folder; empty: it is another's, or its plan is not known.
std::optional<core::Start> start_of(const LogChoice& choice) {
  std::error_code ignored;
  if (!logs::is_flight_log(choice.path) && !std::filesystem::is_directory(choice.path, ignored)) {
    return {};
  }
  const std::optional<core::FlightPlan> plan = logs::flown_plan(choice.path, {});
  return plan ? std::optional{plan->run.start} : std::nullopt;
}

void remark_on_kinds(CompareResults& results, const std::optional<core::Start>& a,
                     const std::optional<core::Start>& b) {
  if (a && b && *a != *b) {
    const bool a_is_tunnel = *a == core::Start::tunnel;
    results.warnings.push_back(
        fmt::format("{} is a tunnel run and {} is a launch: the clock of the first is 0 at control start, that of the "
                    "other at lift-off.",
                    a_is_tunnel ? results.names.a : results.names.b, a_is_tunnel ? results.names.b : results.names.a));
  }
}

void compare_logs(const CompareVerbOptions& options) {
  if (options.save_columns && options.a.columns.said.empty() && options.b.columns.said.empty()) {
    throw UsageError{"--save-columns: there is nothing to save without --a-columns or --b-columns"};
  }
  Chapters chapters{"compare", 3, "reading " + options.a.path};
  const result::Made made = made_with({options.a.path, options.b.path});
  logs::RollLog a = read(options.a, "--a-");
  chapters.next("reading " + options.b.path);
  logs::RollLog b = read(options.b, "--b-");
  chapters.next("comparing the logs and writing the page");
  for (const auto& [choice, dashes] : {std::pair{&options.a, "--a-"}, std::pair{&options.b, "--b-"}}) {
    if (options.save_columns && !choice->columns.said.empty()) {
      save_columns(choice->columns, choice->path, dashes);
    }
  }
  give_up_if_interrupted();
  CompareResults results{
      .a = fmt::format("{} ({})", options.a.path, options.a.motion),
      .b = fmt::format("{} ({})", options.b.path, options.b.motion),
      .names = distinct_names({options.a.path, options.a.motion}, {options.b.path, options.b.motion}),
      .window = options.window.value_or(""),
      .shift_found = options.align == "angle",
      .required_angle_rad = in_radians(options.most_angle_deg),
      .required_rate_rad_s = in_radians(options.most_rate_deg_s),
      .logs = {options.a.path, options.b.path}};
  a.name = results.names.a;
  b.name = results.names.b;
  results.comparison = logs::compare(a, b, question(options, a));
  remark_on_kinds(results, start_of(options.a), start_of(options.b));
  results.take_warnings(a, b);
  give_up_if_interrupted();
  deliver(comparison(results, made), {.folder = options.out,
                                      .name = "compare",
                                      .inputs = results.logs,
                                      .json = options.json,
                                      .shown_files = {"page", "differences"},
                                      .when_written = [&chapters] { chapters.end(); }});
  if (const std::vector<std::string> objections = results.objections(); !objections.empty()) {
    throw RequirementNotMet{fmt::format("{}", fmt::join(objections, "; "))};
  }
}

void add_log(const Verb& verb, const std::string& name, const std::string& capital, LogChoice& choice) {
  verb.option(capital, choice.path, "CSV, MAT or Parquet file, flight log (.ftl) or flight folder")
      .offers(files)
      .required();
  verb.option("--" + name, choice.motion,
              "Roll motion of " + capital + ": as measured, or the true one of a simulation")
      .one_of({"measured", "true"})
      .value_name("measured|true")
      .show_default();
  add_columns_option(verb, "--" + name + "-", choice.columns);
}

void add_alignment(const Verb& verb, CompareVerbOptions& options) {
  auto window = verb.option("--window", options.window, "By A's events: control, thrust, coast, step:N, or FROM:TO");
  verb.option("--from", options.from_s, "Start on A's clock, s")
      .check(objection_to_time)
      .value_name("S")
      .excludes(window);
  verb.option("--to", options.to_s, "End on A's clock, s").check(objection_to_time).value_name("S").excludes(window);
  auto align = verb.option("--align", options.align,
                           "none: use the clocks unchanged. angle: find the shift, up to 2 s either way, at which "
                           "the roll rates agree best")
                   .one_of({"none", "angle"})
                   .value_name("none|angle")
                   .show_default();
  verb.option("--shift", options.shift_s, "Reading of B's clock at A's zero, s")
      .check(objection_to_time)
      .value_name("S")
      .excludes(align);
  verb.flag("--remove-offset", options.remove_offset,
            "Remove a constant difference of the roll angles: both begin the window at A's angle");
}

void fill(const Verb& verb) {
  auto options = std::make_shared<CompareVerbOptions>();
  verb.section("Logs and their columns");
  add_log(verb, "a", "A", options->a);
  add_log(verb, "b", "B", options->b);
  add_save_columns_option(verb, options->save_columns);
  verb.section("Window and alignment");
  add_alignment(verb, *options);
  verb.section("Results");
  verb.option("--require-angle", options->most_angle_deg, "Largest mean difference of the angle, deg; else exit code 1")
      .check(objection_to_requirement)
      .value_name("DEG");
  verb.option("--require-rate", options->most_rate_deg_s,
              "Largest mean difference of the rate, deg/s; else exit code 1")
      .check(objection_to_requirement)
      .value_name("DEG/S");
  verb.option("--out", options->out, "Folder for compare.html, compare.json and differences.csv")
      .offers(folders)
      .show_default();
  verb.flag("--json", options->json, "Print compare.json instead of the text");
  verb.examples(
      "Examples:\n"
      "  fantail compare out/tasha3_launch2 out/tasha3_launch2 --b true --window control\n"
      "                                                      how well the avionics measured its own roll\n"
      "  fantail compare flown.csv out/tasha3_launch2 --align angle --remove-offset --from 0.5 --to 8\n"
      "                                                      a logger with another clock and another zero\n"
      "  fantail compare new.csv old.csv --b-columns rad,roll_angle_deg=phi --require-angle 0.5 --json\n"
      "                                                      a check for a script: exit code 1 if the difference is "
      "larger");
  verb.action([options] { compare_logs(*options); });
}

const VerbCode code{"compare", fill};

}  // namespace
}  // namespace fantail::tool
