// SPDX-License-Identifier: MIT
#include "fantail/bench_log.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "fantail/deliver.hpp"
#include "fantail/flight_files.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"

namespace fantail::tool {
namespace {

namespace fs = std::filesystem;
using Json = json::Value;

constexpr double mega = 1e6;

std::vector<link::ListedFlight> list_flights(LogVisit& visit) {
  Progress progress{"looking for flights in the record",
                    {.unit = "bytes", .rate = " a second", .total = static_cast<double>(visit.info.used_bytes)}};
  return link::list_flights(visit.reader, visit.info.used_bytes, [&](std::uint32_t done) { progress.show(done); });
}

void list(LogVisit& visit) {
  visit.tell("{:.2f} MB recorded, {:.2f} MB free\n", visit.info.used_bytes / mega, visit.info.free_bytes / mega);
  visit.json["flights"] = Json::array();
  int number = 0;
  for (const link::ListedFlight& flight : list_flights(visit)) {
    number += 1;
    visit.tell("  flight {}  {:.2f} MB  {}, power-up {}\n", number, flight.stretch.size / mega,
               flight.vehicle.empty() ? "vehicle not known" : flight.vehicle, flight.power_up);
    visit.json["flights"].push_back({{"flight", number},
                                     {"begin", flight.stretch.offset},
                                     {"bytes", flight.stretch.size},
                                     {"vehicle", flight.vehicle},
                                     {"power_up", flight.power_up}});
  }
}

link::LogStretch stretch_of(LogVisit& visit) {
  if (!visit.options.flight) {
    return {.offset = 0, .size = visit.info.used_bytes};
  }
  const auto flights = list_flights(visit);
  const auto number = static_cast<std::size_t>(*visit.options.flight);
  if (number > flights.size()) {
    throw RequirementNotMet{
        fmt::format("there is no flight {}; the rocket has {}, see --list", number, flights.size())};
  }
  return flights[number - 1].stretch;
}

std::string integrity_words(const link::RecordedFlight& flight, bool agrees) {
  if (!flight.intact()) {
    return fmt::format("{}: {} records missing, {} damaged bytes",
                       agrees ? "damaged in the flash (two downloads agree)" : "damaged, and two downloads differ",
                       flight.missing_records, flight.damaged_bytes);
  }
  if (flight.cut_off_bytes == 0) {
    return "intact";
  }
  return agrees ? fmt::format("intact (two downloads agree); its last record was cut off after {} bytes",
                              flight.cut_off_bytes)
                : "two downloads differ";
}

void say_file(LogVisit& visit, const FlightFile& file) {
  const link::RecordedFlight& flight = file.flight;
  const std::string path = (fs::path{visit.options.out} / file.name).string();
  if (flight.records == 0) {
    visit.tell("{}  {} bytes without an intact record\n", path, flight.end - flight.begin);
  } else {
    visit.tell("{}  {:.1f} s, {:.2f} MB, {}\n", path, flight.duration_s(),
               static_cast<double>(flight.end - flight.begin) / mega, integrity_words(flight, visit.check.agrees()));
  }
  const Json json{
      {"file", path},
      {"bytes", flight.end - flight.begin},
      {"duration_s", flight.duration_s()},
      {"vehicle", flight.vehicle},
      {"power_up", flight.power_up},
      {"records", flight.records},
      {"missing_records", flight.missing_records},
      {"damaged_bytes", flight.damaged_bytes},
      {"cut_off_bytes", flight.cut_off_bytes},
      {"intact", flight.records > 0 && flight.intact() && (flight.cut_off_bytes == 0 || visit.check.agrees())}};
  visit.json["files"].push_back(json);
}

template <typename Work>
auto keeping(const link::LogPart& part, const link::LogStretch& stretch, const Work& work) {
  const auto kept = [&](const char* why) {
    return fmt::format("{}; {} of {} bytes are kept in {}, and the same command resumes from there", why, part.size(),
                       stretch.size, part.path().string());
  };
  try {
    return work();
  } catch (const Interrupted&) {
    throw Interrupted{kept("interrupted")};
  } catch (const link::LinkError& error) {
    throw link::LinkError{kept(error.what())};
  }
}

std::uint32_t download(LogVisit& visit, const link::LogStretch& stretch, link::LogPart& part) {
  const std::uint32_t there = std::min(part.size(), stretch.size);
  // What was there already took no time now.
  Progress progress{"downloading the flight record",
                    {.unit = "bytes", .rate = " a second", .total = static_cast<double>(stretch.size - there)}};
  return link::download(visit.reader, stretch, part,
                        [&](std::uint32_t done) { progress.show(done > there ? done - there : done); });
}

link::LogCheck verify(LogVisit& visit, const link::LogStretch& stretch, link::LogPart& part, std::uint32_t resumed) {
  Progress progress{"downloading the flight record again to check it",
                    {.unit = "bytes", .rate = " a second", .total = static_cast<double>(stretch.size)}};
  return link::verify(visit.reader, stretch, part, resumed, [&](std::uint32_t done) { progress.show(done); });
}

void say_check(LogVisit& visit) {
  const link::LogCheck& check = visit.check;
  visit.json["mended_bytes"] = check.mended_bytes;
  visit.json["unsteady_bytes"] = check.unsteady_bytes;
  if (check.mended_bytes > 0) {
    visit.tell("{} bytes of the earlier download were damaged on this PC, and were downloaded again\n",
               check.mended_bytes);
  }
  if (check.unsteady_bytes > 0) {
    visit.tell("{} bytes were different in each download: download again before you trust them\n",
               check.unsteady_bytes);
  }
}

void fetch(LogVisit& visit) {
  const link::LogStretch stretch = stretch_of(visit);
  const fs::path folder{visit.options.out};
  link::LogPart part{folder / (visit.options.flight ? fmt::format("flight_{:03}.part", *visit.options.flight)
                                                    : std::string{"record.part"})};
  const std::uint32_t before = keeping(part, stretch, [&] {
    const std::uint32_t resumed = download(visit, stretch, part);
    visit.check = verify(visit, stretch, part, resumed);
    return resumed;
  });
  visit.tell("{} bytes downloaded and verified{}\n", stretch.size - before,
             before > 0 ? fmt::format(", {} were there already", before) : std::string{});
  visit.json["downloaded_bytes"] = stretch.size - before;
  visit.json["resumed_bytes"] = before;
  visit.json["repeated_chunks"] = visit.reader.repeated();
  say_check(visit);
  visit.json["files"] = Json::array();
  const auto first = static_cast<std::size_t>(visit.options.flight.value_or(1));
  visit.record = part.read(0, stretch.size);
  for (const FlightFile& file : write_flights(folder, visit.record, first)) {
    say_file(visit, file);
  }
  part.remove();
}

void log(const BenchLogOptions& options) {
  LogVisit visit{options};
  const bool empty = visit.info.used_bytes == 0;
  if (empty) {
    visit.tell("nothing is recorded; {:.2f} MB are free\n", visit.info.free_bytes / mega);
  } else if (options.list) {
    list(visit);
  } else if (!options.discard) {
    fetch(visit);
  }
  if (options.erase && !empty) {
    erase_record(visit);
  }
  if (options.bench.json) {
    visit.json["erased"] = options.erase;
    result::put_answer(visit.json, result::Answer::none,
                       empty           ? "Nothing is recorded."
                       : options.list  ? "The recorded flights are listed."
                       : options.erase ? "The record is erased."
                                       : "The recorded flights are downloaded.",
                       made_with({}));
    fmt::print("{}\n", visit.json.dump());
  }
}

}  // namespace

void add_bench_log(const Verb& bench) {
  auto verb = bench.verb("log", "Download the recorded flights, and erase them if asked to");
  auto options = std::make_shared<BenchLogOptions>();
  add_bench_options(verb, options->bench, "Print one JSON object; the question goes to standard error");
  verb.option("--out", options->out, "Folder for flight_001.ftl and so on [out/bench_log]")
      .offers(folders)
      .value_name("DIR");
  auto flight = verb.option("--flight", options->flight, "Only this flight, numbered as in --list")
                    .range(1, 9999)
                    .value_name("N");
  auto list_flag = verb.flag("--list", options->list, "List the recorded flights, and download nothing");
  auto erase_flag = verb.flag("--erase", options->erase, "Erase the record after all of it is downloaded and verified");
  verb.flag("--discard", options->discard, "Erase without downloading").needs(erase_flag);
  verb.flag("--yes", options->yes, "Do not ask before erasing an intact record; for scripts").needs(erase_flag);
  erase_flag.excludes(flight).excludes(list_flag);
  flight.excludes(list_flag);
  verb.examples(
      "An interrupted download resumes when the same command is given again.\n"
      "Examples:\n"
      "  fantail bench log --can can0 --out launch_day    every flight into its own file\n"
      "  fantail bench log --can can0 --list              the flights that the rocket holds\n"
      "  fantail bench log --can can0 --erase             download everything, ask, make room for the next flight");
  verb.action([options] { log(*options); });
}

}  // namespace fantail::tool
