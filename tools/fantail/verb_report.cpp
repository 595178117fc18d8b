// SPDX-License-Identifier: MIT
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "fantail/compare_results.hpp"
#include "fantail/deliver.hpp"
#include "fantail/log_info.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/terminal.hpp"
#include "logs/compare.hpp"
#include "logs/flight_file.hpp"
#include "logs/roll_log.hpp"
#include "report/results.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

struct ReportOptions {
  std::string a;
  std::string b;
  std::string out;
  std::optional<double> from_s;
  std::optional<double> to_s;
  std::string align = "none";
  std::optional<double> shift_s;
  bool remove_offset = false;
  bool json = false;
};

std::filesystem::path default_folder(const std::string& name) { return std::filesystem::path{"out"} / "report" / name; }

void report_one(const ReportOptions& options) {
  Chapters chapters{"report", 2, "reading " + options.a};
  flight::Flight flight = logs::read_flight(options.a);
  flight.command = "fantail report " + text::shell_word(options.a);
  give_up_if_interrupted();
  chapters.next("computing the figures and writing the page");
  const report::Results results = report::results(flight, made_with({options.a}));
  const std::filesystem::path folder =
      options.out.empty() ? default_folder(name_of_log(options.a)) : std::filesystem::path{options.out};
  report::write_report(flight, results, folder, options.a);
  chapters.end();
  deliver(results.document, {.json = options.json,
                             .last_line = fmt::format("  report   {0}/report.html\n  data     {0}/flight.csv",
                                                      text::printable(folder.string()))});
}

void report_two(const ReportOptions& options) {
  Chapters chapters{"report", 3, "reading " + options.a};
  const result::Made made = made_with({options.a, options.b});
  logs::RollLog a = logs::read_roll_log(options.a, {.options = ""}, {});
  chapters.next("reading " + options.b);
  logs::RollLog b = logs::read_roll_log(options.b, {.options = ""}, {});
  chapters.next("comparing the logs and writing the page");
  give_up_if_interrupted();
  CompareResults results{.a = options.a,
                         .b = options.b,
                         .names = distinct_names({options.a}, {options.b}),
                         .window = {},
                         .shift_found = options.align == "angle",
                         .logs = {options.a, options.b}};
  a.name = results.names.a;
  b.name = results.names.b;
  logs::CompareOptions question{.from_s = options.from_s, .to_s = options.to_s};
  question.shift_s = options.shift_s.value_or(0.0);
  question.find_shift = results.shift_found;
  question.remove_offset = options.remove_offset;
  results.comparison = logs::compare(a, b, question);
  results.take_warnings(a, b);
  give_up_if_interrupted();
  const std::filesystem::path folder =
      options.out.empty() ? default_folder(short_name(name_of_log(options.a) + "_and_" + name_of_log(options.b)))
                          : std::filesystem::path{options.out};
  deliver(overlay(results, a, b, made), {.folder = folder,
                                         .name = "compare",
                                         .page = "report",
                                         .inputs = results.logs,
                                         .json = options.json,
                                         .shown_files = {"page", "differences"},
                                         .when_written = [&chapters] { chapters.end(); }});
}

void fill(const Verb& verb) {
  auto options = std::make_shared<ReportOptions>();
  constexpr const char* what =
      "a flight log (.ftl), a CSV, MAT or Parquet file with columns of flight.csv, or a flight folder";
  verb.option("A", options->a, fmt::format("The flight: {}", what)).offers(files).required();
  auto b = verb.option("B", options->b, "A second flight to draw over it: the same kinds of file").offers(files);
  verb.option("--out", options->out,
              "Folder for report.html and the data behind it [out/report/A or out/report/A_and_B]")
      .offers(folders);
  verb.option("--from", options->from_s, "For two flights: start on A's clock, s")
      .check(objection_to_time)
      .value_name("S")
      .needs(b);
  verb.option("--to", options->to_s, "For two flights: end on A's clock, s")
      .check(objection_to_time)
      .value_name("S")
      .needs(b);
  auto align = verb.option("--align", options->align,
                           "none: use the clocks unchanged. angle: find the shift, up to 2 s either way, at which the "
                           "roll rates agree best")
                   .one_of({"none", "angle"})
                   .value_name("none|angle")
                   .show_default()
                   .needs(b);
  verb.option("--shift", options->shift_s, "Reading of B's clock at A's zero, s")
      .check(objection_to_time)
      .value_name("S")
      .excludes(align)
      .needs(b);
  verb.flag("--remove-offset", options->remove_offset,
            "Remove a constant difference of the roll angles: both begin the window at A's angle")
      .needs(b);
  verb.flag("--json", options->json, "Print summary.json (for two flights compare.json) instead of the text");
  verb.examples(
      "Exit code 0: the page was written, whether or not the roll was held. For one flight, `outcome` in summary.json "
      "and --json is the verdict (held, off_command, outside_model, not_held, oscillates, cut_short, not_judged, "
      "no_control, "
      "ascent_failed).\n"
      "Examples:\n"
      "  fantail report flown.ftl                             the recording of a board, as fly shows its flights\n"
      "  fantail report flown.ftl out/tasha3_launch2 --align angle --from 0 --to 12\n"
      "                                                       flown and simulated, one over the other\n"
      "  fantail report old_logger.csv --out /tmp/page --json\n"
      "                                                       a table from another program, for a script\n"
      "\n"
      "For the differences of two flights in figures, with limits for a script: fantail compare.");
  verb.action([options] { options->b.empty() ? report_one(*options) : report_two(*options); });
}

const VerbCode code{"report", fill};

}  // namespace
}  // namespace fantail::tool
