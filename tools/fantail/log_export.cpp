// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "fantail/command_line.hpp"
#include "fantail/log_info.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/standard_streams.hpp"
#include "flight_log/flight_log.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/to_report.hpp"
#include "input/messages.hpp"
#include "log_export/formats.hpp"
#include "log_export/replayed_flight.hpp"
#include "telemetry/messages.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ExportFormat {
  std::string_view name;
  std::string_view ending;
  /// The chosen fields; null: the format has messages of its own.
  std::string (*write_fields)(const log_export::ReplayedFlight& source, const log_export::Selection& selection);
};
inline constexpr std::array<ExportFormat, 8> export_formats{{{"csv", ".csv", log_export::csv},
                                                             {"mat", ".mat", log_export::mat},
                                                             {"parquet", ".parquet", log_export::parquet},
                                                             {"mcap", ".mcap", log_export::mcap},
                                                             {"ulog", ".ulg", log_export::ulog},
                                                             {"lcm", ".lcmlog", nullptr},
                                                             {"candump", ".log", nullptr},
                                                             {"json", ".json", log_export::json}}};

/// What a person wants of a log.
struct ExportQuestion {
  std::string log;  ///< its file, for messages
  const ExportFormat* format = nullptr;
  std::vector<std::string> fields{};  ///< empty: those that the format has by itself
  log_export::Window window{};
};

struct Exported {
  std::string bytes;
  std::string columns{};           ///< of a table: units and descriptions, for a file beside it
  std::vector<std::string> notes;  ///< what the log has lost, a sentence each
};

[[noreturn]] void refuse_fields(const std::string& complaint) { throw UsageError{"--fields: " + complaint}; }

[[noreturn]] void refuse_log(const ExportQuestion& question, const std::string& complaint) {
  throw text::Error{text::ErrorKind::bad_data, question.log + ": " + complaint};
}

void require_once(std::span<const std::string> names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::ranges::find(names.first(i), names[i]) != names.begin() + static_cast<std::ptrdiff_t>(i)) {
      refuse_fields(names[i] + " appears twice");
    }
  }
}

std::optional<log_export::Selection> selection(const ExportQuestion& question) {
  if (question.fields.empty()) {
    return {};
  }
  log_export::Selection chosen;
  for (const std::string& name : question.fields) {
    const auto field = log_export::find_field(name);
    if (!field) {
      refuse_fields(log_export::unknown_field(name));
    }
    chosen.push_back(*field);
  }
  return chosen;
}

flight_log::Regeneration replay_of(const flight_log::Flight& flight) {
  if (flight.plan) {
    return flight_log::regenerate(flight, *flight.plan);
  }
  flight_log::Regeneration none;
  none.records.resize(flight.ticks.size());
  none.unreachable = flight.ticks.size();
  none.obstacle = flight.has_header ? fmt::format("Its plan cannot be used: {}.", flight.plan_fault)
                                    : "It has no intact header, so there is no plan.";
  return none;
}

std::string content(const ExportQuestion& question, const log_export::ReplayedFlight& source,
                    const flight::Flight& report, const std::optional<log_export::Selection>& chosen) {
  if (question.format->name == "csv" && !chosen) {
    return log_export::flight_csv(source, report);
  }
  if (question.format->write_fields != nullptr) {
    return question.format->write_fields(source, chosen.value_or(log_export::every_field(source)));
  }
  return question.format->name == "lcm" ? log_export::lcm(source) : log_export::candump(source);
}

Exported export_foreign(const ExportQuestion& question, const flight_log::Flight& flight) {
  const std::vector<std::string> all = log_export::foreign_fields(flight);
  constexpr std::string_view what = "its ticks have the layout of another version of Fantail";
  if (all.empty()) {
    refuse_log(question, fmt::format("{}, and its schema does not describe them", what));
  }
  if (question.format->name != "csv") {
    refuse_log(question, fmt::format("{}; their content can be exported with --to csv", what));
  }
  for (const std::string& name : question.fields) {
    if (std::ranges::find(all, name) == all.end()) {
      const auto meant = input::suggestion(name, all);
      refuse_fields(fmt::format("no field \"{}\"{} in this log of another version; there are: {}", name,
                                meant ? " (did you mean " + *meant + "?)" : "", fmt::join(all, ", ")));
    }
  }
  std::string table = log_export::foreign_csv(flight, question.fields.empty() ? all : question.fields, question.window);
  std::string columns = log_export::foreign_columns_json(flight, table);
  return {
      .bytes = std::move(table),
      .columns = std::move(columns),
      .notes = {fmt::format("Written by Fantail {}: {}. The table holds what the log contains; nothing was replayed.",
                            flight.firmware_version, what)}};
}

Exported export_flight(const ExportQuestion& question, const flight_log::Flight& flight) {
  if (!question.fields.empty() && question.format->write_fields == nullptr) {
    refuse_fields(fmt::format("--to {} has fixed messages; --fields is for the other formats", question.format->name));
  }
  require_once(question.fields);
  if (!flight.foreign_ticks.empty()) {
    return export_foreign(question, flight);
  }
  const auto chosen = selection(question);
  if (flight.ticks.empty()) {
    refuse_log(question, "contains no tick of the flight");
  }
  const flight_log::Regeneration replay = replay_of(flight);
  const bool only_replayed = question.format->write_fields == nullptr;
  if (only_replayed && replay.compared == 0) {
    // A file of nothing but headers would look like a success.
    refuse_log(question, fmt::format("{} The recorded data can be exported with --to csv",
                                     replay.obstacle.empty() ? "None of its ticks can be replayed." : replay.obstacle));
  }
  flight::Flight report = flight_log::to_report(flight, replay);
  if (only_replayed && replay.unreachable > 0) {
    report.notes.push_back(
        fmt::format("The messages of --to {} come from a replay, so ticks that could not be replayed are missing. "
                    "--to csv has every tick.",
                    question.format->name));
  }
  const log_export::ReplayedFlight source{flight, replay, report, question.window};
  if (std::ranges::none_of(flight.ticks, [&](const auto& t) { return source.inside(t.tick.time); })) {
    refuse_log(question, fmt::format("no tick between --from and --until; the log goes from {:.6f} s to {:.6f} s",
                                     source.time_s(flight.ticks.front().tick.time),
                                     source.time_s(flight.ticks.back().tick.time)));
  }
  std::string bytes = content(question, source, report, chosen);
  std::string columns = question.format->name == "csv" ? log_export::columns_json(bytes) : "";
  return {.bytes = std::move(bytes), .columns = std::move(columns), .notes = report.notes};
}

struct ExportOptions {
  std::string log;
  std::string format;
  std::string out;
  std::vector<std::string> fields;
  log_export::Window window;
  std::optional<std::size_t> flight;
};

std::string objection_to_file(const std::string& text) {
  return text.back() == '/' ? '"' + text + "\" is not the name of a file" : "";
}

std::filesystem::path output_file(const ExportOptions& options, const ExportFormat& format) {
  if (!options.out.empty()) {
    return options.out;
  }
  const std::string flight = options.flight ? fmt::format("_flight_{}", *options.flight) : "";
  return std::filesystem::path{"out"} / "export" / (name_of_log(options.log) + flight + std::string{format.ending});
}

/// The log, and the files of a flight beside it or the target: a flight.csv has columns that no log can give back.
std::vector<std::filesystem::path> files_to_spare(const std::filesystem::path& log,
                                                  const std::filesystem::path& target) {
  const bool in_folder = std::filesystem::is_directory(log);
  std::vector<std::filesystem::path> all{in_folder ? log / "flight.ftl" : log};
  for (const std::filesystem::path& folder : {in_folder ? log : log.parent_path(), target.parent_path()}) {
    if (std::filesystem::exists(folder / "summary.json")) {
      for (const char* name : {"flight.csv", "flight.ftl", "summary.json", "report.html", "tunnel.csv",
                               "trajectory.csv", "turning.csv", "without_control.csv"}) {
        all.push_back(folder / name);
      }
    }
  }
  return all;
}

/// What is there under this name must look like an earlier export: no slip of the pen may lose a scenario or a log.
void refuse_to_replace(const std::filesystem::path& target, const ExportFormat& format) {
  if (target != "-" && target.extension() != format.ending && std::filesystem::exists(target)) {
    throw text::OutputError{
        fmt::format("--out {}: this file exists, and its name does not end in {} like an earlier export; choose "
                    "another name",
                    target.string(), format.ending)};
  }
}

void export_log(const ExportOptions& options) {
  const auto& [from_s, until_s] = options.window;
  if (from_s && until_s && *from_s > *until_s) {
    throw UsageError{fmt::format("--from {:g} is after --until {:g}", *from_s, *until_s)};
  }
  const ExportFormat& format = *std::ranges::find(export_formats, options.format, &ExportFormat::name);
  refuse_to_replace(output_file(options, format), format);
  Chapters chapters{"log export", 2, "reading " + options.log};
  flight_log::LogFile file = flight_log::read_log_file(options.log);
  const std::string foreign = flight_log::foreign_bytes_text(file);
  const flight_log::Flight flight = take_flight(file, options.flight);
  give_up_if_interrupted();
  chapters.next("replaying the flight and writing it as " + options.format);
  const Exported exported = export_flight(
      {.log = options.log, .format = &format, .fields = options.fields, .window = options.window}, flight);
  chapters.end();
  give_up_if_interrupted();
  if (!foreign.empty()) {
    say("fantail: note: " + foreign + "\n");
  }
  for (const std::string& note : exported.notes) {
    say("fantail: note: " + note + "\n");
  }
  if (options.out == "-") {
    fmt::print("{}", exported.bytes);
    return;
  }
  const std::filesystem::path target = output_file(options, format);
  std::vector<text::NamedFile> files{{target.filename().string(), exported.bytes}};
  if (!exported.columns.empty()) {
    files.push_back({target.stem().string() + ".columns.json", exported.columns});
  }
  if (format.name == "lcm") {
    for (const telemetry::TypeFile& type : telemetry::type_files()) {
      files.push_back({std::string{type.name}, std::string{type.text}});
    }
  }
  text::OutputFolder{target.parent_path(), files_to_spare(options.log, target)}.write(files);
  fmt::print("{}\n", target.string());
}

}  // namespace

void add_log_export(const Verb& log) {
  auto verb = log.verb("export", "A flight log as a file that other programs read");
  auto options = std::make_shared<ExportOptions>();
  verb.option("LOG", options->log, "A flight log (.ftl), or a folder with a flight.ftl").offers(files).required();
  verb.option("--to", options->format,
              "csv: flight.csv. mat: for MATLAB, Octave and SciPy. parquet: for pandas and DuckDB. mcap: for "
              "Foxglove. ulog: for PlotJuggler. lcm: for lcm-logplayer. candump: the bus frames, for canplayer and "
              "cantools. json: one object with everything")
      .required()
      .one_of({"csv", "mat", "parquet", "mcap", "ulog", "lcm", "candump", "json"})
      .value_name("csv|mat|parquet|mcap|ulog|lcm|candump|json");
  verb.option("--out", options->out, "The file; - is standard output [out/export/NAME.ENDING]")
      .offers(files)
      .check(objection_to_file);
  verb.option("--fields", options->fields,
              "Only these, separated by commas; an unknown name lists all [csv: those of flight.csv; others: all]")
      .separated_by(',')
      .one_word_each_time()
      .value_name("A,B,C");
  verb.option("--from", options->window.from_s, "Start, s on the clock of time_s").check(objection_to_time);
  verb.option("--until", options->window.until_s, "End, likewise (--to is the format)").check(objection_to_time);
  add_flight_choice(verb, options->flight);
  verb.examples(
      "Examples:\n"
      "  fantail log export out/tasha3_launch2 --to ulog      for PlotJuggler: out/export/tasha3_launch2.ulg\n"
      "  fantail log export flown.ftl --to csv --fields time_s,roll_angle_deg,rate_x_count --from 0 --until 12\n"
      "                                                       a table of your choice, with raw counts of the gyro\n"
      "  fantail log export flown.ftl --to candump --out - | cantools decode canard_bus.dbc\n"
      "                                                       the bus messages in words; canard_bus.dbc is in\n"
      "                                                       PREFIX/share/fantail or the sources' firmware/protocol");
  verb.action([options] { export_log(*options); });
}

}  // namespace fantail::tool
