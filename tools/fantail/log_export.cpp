// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/exported.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/log_file.hpp"
#include "fantail/standard_streams.hpp"
#include "flight_log/integrity.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

struct ExportOptions {
  std::string log;
  std::string format;
  std::string out;
  std::vector<std::string> fields;
  log_export::Window window;
  std::optional<std::size_t> flight;
};

std::string objection_to_file(const std::string& text) {
  return text.empty() || text.back() == '/' ? '"' + text + "\" is not the name of a file" : "";
}

std::filesystem::path output_file(const ExportOptions& options, const ExportFormat& format) {
  if (!options.out.empty()) {
    return options.out;
  }
  const std::string flight = options.flight ? fmt::format("_flight_{}", *options.flight) : "";
  return std::filesystem::path{"out"} / "export" / (name_of_log(options.log) + flight + std::string{format.ending});
}

void export_log(const ExportOptions& options) {
  const auto& [from_s, until_s] = options.window;
  if (from_s && until_s && *from_s > *until_s) {
    throw UsageError{fmt::format("--from {:g} lies behind --until {:g}", *from_s, *until_s)};
  }
  const ExportFormat& format = *std::ranges::find(export_formats, options.format, &ExportFormat::name);
  flight_log::LogFile file = flight_log::read_log_file(options.log);
  const std::string foreign = flight_log::foreign_bytes_text(file);
  const flight_log::Flight flight = take_flight(file, options.flight);
  give_up_if_interrupted();
  const Exported exported = export_flight(
      {.log = options.log, .format = &format, .fields = options.fields, .window = options.window}, flight);
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
  text::OutputFolder{target.parent_path()}.write(
      std::array{text::NamedFile{target.filename().string(), exported.bytes}});
  fmt::print("{}\n", target.string());
}

}  // namespace

void add_log_export(const Verb& log) {
  auto verb = log.verb("export", "A flight log as a file that other programs read");
  auto options = std::make_shared<ExportOptions>();
  verb.option("LOG", options->log, "A flight log (.ftl), or a folder with a flight.ftl").required();
  verb.option("--to", options->format,
              "csv: flight.csv. ulog: for PlotJuggler and Foxglove. lcm: for lcm-logplayer. candump: the bus as "
              "it was, for canplayer and cantools. json: one object with everything")
      .required()
      .one_of({"csv", "ulog", "lcm", "candump", "json"})
      .value_name("csv|ulog|lcm|candump|json");
  verb.option("--out", options->out, "The file; - is standard output [out/export/NAME.ENDING]")
      .check(objection_to_file);
  verb.option("--fields", options->fields,
              "Only these, separated by commas, raw counts too; an unknown name lists all [csv: those of "
              "flight.csv; ulog, json: all]")
      .separated_by(',')
      .one_word_each_time()
      .value_name("A,B,C");
  verb.option("--from", options->window.from_s, "Begin, s on the clock of time_s").check(objection_to_time);
  verb.option("--until", options->window.until_s, "End, s on the clock of time_s (--to is the format)")
      .check(objection_to_time);
  verb.option("--flight", options->flight, "Which flight in a file with several, counted from 1");
  verb.examples(
      "Examples:\n"
      "  fantail log export out/tasha3_launch2 --to ulog      for PlotJuggler: out/export/tasha3_launch2.ulg\n"
      "  fantail log export flown.ftl --to csv --fields time_s,roll_angle_deg,rate_x_count --from 0 --until 12\n"
      "                                                       a table of your own, raw counts of the gyro in it\n"
      "  fantail log export flown.ftl --to candump --out - | cantools decode firmware/protocol/canard_bus.dbc\n"
      "                                                       what the bus carried in flight, in words");
  verb.action([options] { export_log(*options); });
}

}  // namespace fantail::tool
