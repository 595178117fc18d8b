// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "fantail/interrupt.hpp"
#include "fantail/log_file.hpp"
#include "fantail/log_verbs.hpp"
#include "fantail/standard_streams.hpp"
#include "flight_log/integrity.hpp"
#include "flight_log/to_report.hpp"
#include "log_export/candump.hpp"
#include "log_export/csv.hpp"
#include "log_export/json.hpp"
#include "log_export/lcm.hpp"
#include "log_export/ulog.hpp"
#include "report/output_folder.hpp"
#include "sim/input_error.hpp"

namespace fantail::tool {
namespace {

struct Format {
  std::string_view name;
  std::string_view ending;
  bool has_fields;
};
constexpr std::array<Format, 5> formats{{{"csv", ".csv", true},
                                         {"ulog", ".ulg", true},
                                         {"lcm", ".lcmlog", false},
                                         {"candump", ".log", false},
                                         {"json", ".json", true}}};

struct ExportOptions {
  std::string log;
  std::string format;
  std::string out;
  std::vector<std::string> fields;
  std::optional<double> from_s;
  std::optional<double> until_s;
  std::optional<std::size_t> flight;
};

std::string objection_to_time(const std::string& text) {
  double value = 0.0;
  return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? ""
                                                                        : '"' + text + "\" is not a number of seconds";
}

[[noreturn]] void refuse(const std::string& complaint) {
  throw CLI::ValidationError{complaint, CLI::ExitCodes::ValidationError};
}

const Format& format_of(const ExportOptions& options) {
  return *std::ranges::find(formats, options.format, &Format::name);
}

std::optional<log_export::Selection> selection(const ExportOptions& options) {
  if (options.fields.empty()) {
    return {};
  }
  if (!format_of(options).has_fields) {
    refuse(fmt::format("--fields: --to {} has messages of its own; allowed with csv, ulog and json", options.format));
  }
  log_export::Selection chosen;
  for (const std::string& name : options.fields) {
    const auto field = log_export::find_field(name);
    if (!field) {
      refuse("--fields: " + log_export::unknown_field(name));
    }
    if (std::ranges::find(chosen, *field) != chosen.end()) {
      refuse(fmt::format("--fields: {} stands there twice", name));
    }
    chosen.push_back(*field);
  }
  return chosen;
}

// What the replay alone can give is not there without one; a file of nothing but headers would look like a success.
void require_replay(const ExportOptions& options, const flight_log::Flight& flight,
                    const flight_log::Regeneration& replay) {
  const bool needs_replay = options.fields.empty() && options.format != "ulog" && options.format != "json";
  if (flight.ticks.empty()) {
    throw sim::InputError{sim::InputFault::bad_data,
                          fmt::format("{}: {}", options.log,
                                      flight.foreign_ticks.empty()
                                          ? "holds no tick of the flight"
                                          : "its ticks are laid out as in another version of Fantail; export it with "
                                            "that one (fantail log info says which)")};
  }
  if (needs_replay && replay.compared == 0) {
    throw sim::InputError{
        sim::InputFault::bad_data,
        fmt::format("{}: {} What stands in the log itself can be exported: --to csv --fields "
                    "time_us,phase,command_deg,rate_x_count,encoder_1_count",
                    options.log, replay.obstacle.empty() ? "No tick of it could be replayed." : replay.obstacle)};
  }
}

std::string content(const ExportOptions& options, const log_export::Source& source, const report::Flight& report,
                    const std::optional<log_export::Selection>& chosen) {
  if (options.format == "csv") {
    return chosen ? log_export::csv(source, *chosen) : log_export::flight_csv(source, report);
  }
  if (options.format == "candump") {
    return log_export::candump(source);
  }
  if (options.format == "lcm") {
    return log_export::lcm(source);
  }
  const log_export::Selection fields = chosen.value_or(log_export::every_field());
  return options.format == "ulog" ? log_export::ulog(source, fields) : log_export::json(source, fields);
}

std::filesystem::path output_file(const ExportOptions& options) {
  if (!options.out.empty()) {
    return options.out;
  }
  const std::string flight = options.flight ? fmt::format("_flight_{}", *options.flight) : "";
  return std::filesystem::path{"out"} / "export" /
         (name_of_log(options.log) + flight + std::string{format_of(options).ending});
}

void export_log(const ExportOptions& options) {
  if (options.from_s && options.until_s && *options.from_s > *options.until_s) {
    refuse(fmt::format("--from {:g} lies behind --until {:g}", *options.from_s, *options.until_s));
  }
  const auto chosen = selection(options);
  flight_log::LogFile file = flight_log::read_log_file(options.log);
  const std::string foreign = flight_log::foreign_words(file);
  const flight_log::Flight flight = take_flight(std::move(file), options.flight);
  give_up_if_interrupted();
  const flight_log::Regeneration replay =
      flight.plan ? flight_log::regenerate(flight, *flight.plan) : flight_log::Regeneration{};
  require_replay(options, flight, replay);
  const report::Flight report = flight_log::to_report(flight, replay);
  const log_export::Source source{flight, replay, report, {.from_s = options.from_s, .until_s = options.until_s}};
  if (std::ranges::none_of(flight.ticks, [&](const auto& t) { return source.inside(t.tick.time); })) {
    throw sim::InputError{
        sim::InputFault::bad_data,
        fmt::format("{}: no tick between --from and --until; the log goes from {:.6f} s to {:.6f} s", options.log,
                    source.time_s(flight.ticks.front().tick.time), source.time_s(flight.ticks.back().tick.time))};
  }
  const std::string bytes = content(options, source, report, chosen);
  give_up_if_interrupted();
  if (!foreign.empty()) {
    say("fantail: note: " + options.log + ": " + foreign + "\n");
  }
  for (const std::string& note : report.notes) {
    say("fantail: note: " + note + "\n");
  }
  if (options.out == "-") {
    fmt::print("{}", bytes);
    return;
  }
  const std::filesystem::path target = output_file(options);
  report::OutputFolder{target.parent_path()}.write(std::array{report::NamedFile{target.filename().string(), bytes}});
  fmt::print("{}\n", target.string());
}

}  // namespace

void add_log_export(CLI::App& log) {
  auto* verb = log.add_subcommand("export", "A flight log as a file that other programs read");
  auto options = std::make_shared<ExportOptions>();
  verb->add_option("LOG", options->log, "A flight log (.ftl), or a folder with a flight.ftl")->required();
  verb->add_option("--to", options->format,
                   "csv: flight.csv. ulog: for PlotJuggler and Foxglove. lcm: for lcm-logplayer. candump: the bus as "
                   "it was, for canplayer and cantools. json: one object with everything")
      ->required()
      ->check(CLI::IsMember({"csv", "ulog", "lcm", "candump", "json"}))
      ->type_name("csv|ulog|lcm|candump|json");
  verb->add_option("--out", options->out, "The file; - is standard output [out/export/NAME.ENDING]");
  verb->add_option("--fields", options->fields,
                   "Only these, separated by commas, raw counts too; an unknown name lists all [csv: those of "
                   "flight.csv; ulog, json: all]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("A,B,C");
  verb->add_option("--from", options->from_s, "Begin, s on the clock of time_s")->check(objection_to_time);
  verb->add_option("--until", options->until_s, "End, s on the clock of time_s (--to is the format)")
      ->check(objection_to_time);
  verb->add_option("--flight", options->flight, "Of several flights in one file, counted from 1");
  verb->footer(
      "Examples:\n"
      "  fantail log export out/tasha3_launch2 --to ulog      for PlotJuggler: out/export/tasha3_launch2.ulg\n"
      "  fantail log export flown.ftl --to csv --fields time_s,roll_angle_deg,rate_x_count --from 0 --until 12\n"
      "                                                       a table of your own, raw counts of the gyro in it\n"
      "  fantail log export flown.ftl --to candump --out - | cantools decode firmware/protocol/canard_bus.dbc\n"
      "                                                       what the bus carried in flight, in words");
  verb->callback([options] { export_log(*options); });
}

}  // namespace fantail::tool
