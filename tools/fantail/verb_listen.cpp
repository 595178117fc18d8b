// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "files/load.hpp"
#include "flight/table.hpp"
#include "input/document.hpp"
#include "input/plan_file.hpp"
#include "input/shipped.hpp"
#include "listen/answer.hpp"
#include "listen/fly_log.hpp"
#include "listen/mounting.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ListenOptions {
  std::string log;
  std::string map;
  std::string columns;
  std::string barometer;
  std::string barometer_columns;
  std::string mounting;
  std::string plan = "tasha3_launch2";
  std::optional<double> longest_gap_s;
  double pad_s = 0.0;
  std::string out;
  bool json = false;
};

std::string names_of_maps() {
  std::string names;
  for (const files::Logger& logger : files::loggers()) {
    names += files::has_axial(logger) ? fmt::format("{}{}", names.empty() ? "" : ", ", logger.name) : "";
  }
  return names;
}

struct Chosen {
  files::Sources sources{};
  const files::Logger* logger = nullptr;  ///< whose map says some of it
};

[[noreturn]] void refuse_columns(const flight::Table& table) {
  const std::string use = files::use_without_axial(table.columns());
  throw text::Error{
      text::ErrorKind::bad_data,
      use.empty() ? fmt::format("{}: its columns fit no known logger; name at least time and axial force: --columns "
                                "time=COLUMN:UNIT,axial=COLUMN:UNIT. {}",
                                table.name(), flight::missing_column("known", table.columns()))
                  : fmt::format("{}: {}", table.name(), use)};
}

// What the person says goes before what the map says.
Chosen choose(const ListenOptions& o, const flight::Table& table) {
  files::Sources typed;
  if (!o.columns.empty()) {
    typed = files::parse_columns(o.columns, "--columns", listen::heard_quantities);
  }
  const bool has_axial = files::find(typed, files::Quantity::axial) != nullptr;
  if (has_axial && files::find(typed, files::Quantity::time) != nullptr && o.map.empty()) {
    return {typed};
  }
  const files::Logger* const logger = o.map.empty() ? files::logger_of(table.columns()) : files::find_logger(o.map);
  if (logger == nullptr || !(has_axial || files::has_axial(*logger))) {
    refuse_columns(table);
  }
  return {files::merged(typed, files::sources_of(*logger, listen::heard_quantities)), logger};
}

std::string columns_from(const ListenOptions& o, const flight::Table& table, const Chosen& chosen) {
  const bool uses_map =
      chosen.logger != nullptr && std::ranges::any_of(chosen.sources, [&](const files::Source& source) {
        return !source.must_be_there && table.find(source.column);
      });
  return uses_map || (chosen.logger != nullptr && o.columns.empty())
             ? fmt::format("{}columns of the map {}{}", o.columns.empty() ? "" : "columns as typed, the rest from ",
                           chosen.logger->name, o.map.empty() ? ", which fits them" : "")
             : "";
}

/// A logger that may sit any way round tells by the force on the pad where the nose is.
std::optional<listen::Mounting> mounting_of(const ListenOptions& o, const Chosen& chosen) {
  if (!o.mounting.empty()) {
    return listen::parse_mounting(o.mounting);
  }
  const bool is_unknown = chosen.logger != nullptr && chosen.logger->any_mounting && o.columns.empty();
  return is_unknown ? std::optional{listen::parse_mounting(listen::mounting_by_pad)} : std::nullopt;
}

listen::ImuLog read(const ListenOptions& o) {
  const files::Loaded file = files::load(o.log, files::Beside::nothing);
  const Chosen chosen = choose(o, file.table);
  listen::ImuLog log = listen::imu_log(file, chosen.sources);
  log.columns_from = columns_from(o, file.table, chosen);
  log.doubt = chosen.logger != nullptr ? chosen.logger->doubt : "";
  log.notes.insert(log.notes.begin(), file.notes.begin(), file.notes.end());
  if (const auto mounting = mounting_of(o, chosen)) {
    listen::turn_into_rocket(log, *mounting, files::find(chosen.sources, files::Quantity::axial)->offset != 0.0);
  }
  if (!o.barometer.empty()) {
    const files::Sources what_else =
        files::parse_columns(o.barometer_columns, "--barometer-columns", listen::heard_quantities);
    if (files::find(what_else, files::Quantity::height) == nullptr) {
      throw UsageError{"--barometer-columns: the height is missing, as in time=ts:s,height=h:m"};
    }
    listen::add_barometer(log, files::load(o.barometer, files::Beside::nothing).table, what_else);
  }
  return log;
}

listen::Heard fly(const ListenOptions& o, listen::ImuLog log) {
  const std::filesystem::path plan = input::find_input(input::Shipped::plan, o.plan);
  const listen::Question question{.plan_name = input::name_of_file(plan),
                                  .plan = input::read_plan(input::Document::load(plan.string())),
                                  .longest_bridge_s = o.longest_gap_s,
                                  .pad_s = o.pad_s};
  Progress progress{"running the flight code on " + log.name,
                    {"s", " x real time", log.end_s() - log.begin_s() + o.pad_s}};
  return listen::fly_log(std::move(log), question, [&](double done_s) {
    give_up_if_interrupted();
    progress.show(done_s);
  });
}

listen::PageFolder output_folder(const ListenOptions& o) {
  return o.out.empty() ? listen::page_folder(std::filesystem::path{"out"} / "listen", o.log)
                       : listen::PageFolder{.folder = o.out};
}

void listen_to(const ListenOptions& o) {
  if (o.barometer.empty() != o.barometer_columns.empty()) {
    throw UsageError{"--barometer FILE and --barometer-columns time=...,height=... need each other"};
  }
  const listen::Heard heard = fly(o, read(o));
  give_up_if_interrupted();
  const listen::PageFolder place = output_folder(o);
  deliver(
      listen::answer(heard, made_with({o.log, o.barometer})),
      {.folder = place.folder, .name = "listen", .inputs = {o.log, o.barometer}, .json = o.json, .when_written = [&] {
         if (!place.remark.empty()) {
           say(fmt::format("fantail: {} This page is in {}; --out names another place.\n", place.remark,
                           place.folder.string()));
         }
       }});
}

std::string objection_to_map(const std::string& text) {
  const files::Logger* const logger = files::find_logger(text);
  return logger != nullptr && files::has_axial(*logger)
             ? ""
             : fmt::format("\"{}\" is not a map of a logger's columns; allowed: {}", text, names_of_maps());
}

std::string objection_to_mounting(const std::string& text) {
  try {
    (void)listen::parse_mounting(text);
    return {};
  } catch (const text::Error& error) {
    return error.what();
  }
}

void fill(const Verb& verb) {
  auto options = std::make_shared<ListenOptions>();
  verb.option("LOG", options->log,
              "A ULog (.ulg), MAT or Parquet file, any other type that `fantail convert` reads, or a CSV file")
      .offers(files)
      .required();
  verb.option("--columns", options->columns,
              "QUANTITY=[-][SCALE*]COLUMN:UNIT for time, axial (or axial_from_rest, zero on the pad), second_axial, "
              "lateral_y, lateral_z, roll_rate, pitch_rate, yaw_rate, height, speed; x points to the nose")
      .value_name("QUANTITY=COLUMN:UNIT,...");
  verb.option("--map", options->map,
              fmt::format("Map of a logger's columns [the one that fits]. --columns overrides it. {}", names_of_maps()))
      .check(objection_to_map)
      .value_name("MAP");
  verb.option("--mounting", options->mounting,
              "How the logger sits: by which angle, in degrees, about which of the rocket's axes, as \"45 about x\". "
              "Or \"pad\": its force on the pad points to the nose")
      .check(objection_to_mounting)
      .value_name("\"DEG about AXIS\"");
  verb.option("--barometer", options->barometer, "Separate file with the height").offers(files).value_name("FILE");
  verb.option("--barometer-columns", options->barometer_columns,
              "Its columns for time, height and speed, as in --columns")
      .value_name("QUANTITY=COLUMN:UNIT,...");
  verb.option("--plan", options->plan, "The flight plan: a shipped name or a path")
      .offers(shipped(input::Shipped::plan))
      .show_default();
  verb.option("--longest-gap", options->longest_gap_s,
              "Longest time between two samples that is interpolated, s [ten usual intervals; in a log faster than "
              "400 Hz the plan's stale time]")
      .check(within(1e-4, 10.0))
      .value_name("S");
  verb.option("--pad", options->pad_s, "Seconds of rest to add before the log, at the mean readings up to lift-off")
      .check(within(0.0, 3600.0))
      .value_name("S");
  verb.option("--out", options->out,
              "Folder for listen.html and listen.json [out/listen/LOG; if that has the page of another file, "
              "out/listen/LOG_2, ...]")
      .offers(folders);
  verb.flag("--json", options->json, "Print listen.json instead of the text");
  verb.examples(
      "Examples:\n"
      "  fantail listen flight.csv --columns time=ts:s,axial=-Ay:m/s2,roll_rate=Gy:deg/s,height=alt:m\n"
      "                                               any log; a minus reverses an axis\n"
      "  fantail listen 2022-06-24-serial-6583-flight-0003.csv --pad 5\n"
      "                                               an export of AltosUI; its log begins 0.3 s before the launch\n"
      "  fantail listen imu.csv --map cats --barometer flightInfo.csv --barometer-columns time=ts:s,height=height:m\n"
      "                                               a CATS Vega, with its height beside it\n"
      "  fantail listen log.ulg --plan tasha3_launch1 --json\n"
      "                                               a PX4 log, with the plan of the first published launch");
  verb.action([options] { listen_to(*options); });
}

const VerbCode code{"listen", fill};

}  // namespace
}  // namespace fantail::tool
