// SPDX-License-Identifier: MIT
#include "fantail/campaign_detection.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "detection/campaign.hpp"
#include "detection/report.hpp"
#include "detection/shown_event.hpp"
#include "fantail/interrupt.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::tool {
namespace {

namespace files = std::filesystem;

struct DetectionOptions {
  std::vector<std::string> plans;
  std::vector<std::string> kinds;
  std::size_t events = 10'000;
  std::size_t launches = 1'000;
  std::string seed;
  std::string event;
  bool both_well = false;
  std::optional<double> at_most_percent;
  double false_at_most_percent = 0.0;
  unsigned threads = 0;
  std::string out;
  bool json = false;
};

std::string objection_to_kind(const std::string& text) {
  if (detection::kind_of(text)) {
    return "";
  }
  std::vector<std::string_view> names;
  for (const detection::KindInfo& kind : detection::kind_table) {
    names.push_back(kind.name);
  }
  return fmt::format("\"{}\" is no kind of event; there are: {}", text, fmt::join(names, ", "));
}

std::string objection_to_whole_number(const std::string& text) {
  return text::whole_number(text) ? "" : '"' + text + "\" is no whole number from 0 to 18446744073709551615";
}

detection::Campaign asked_for(const DetectionOptions& options) {
  detection::Campaign campaign{
      .rules = detection::rules_of(options.plans), .kinds = {}, .events = options.events, .launches = options.launches};
  campaign.both_well = options.both_well;
  if (!options.seed.empty()) {
    campaign.seed = *text::whole_number(options.seed);
  }
  for (std::size_t i = 0; i < detection::kinds; ++i) {
    const auto kind = static_cast<detection::Kind>(i);
    const bool asked = std::ranges::find(options.kinds, detection::info(kind).name) != options.kinds.end();
    const bool usual = options.kinds.empty() && !(options.both_well && kind == detection::Kind::launch_one_bad);
    if (asked || usual) {
      campaign.kinds.push_back(kind);
    }
  }
  return campaign;
}

files::path folder_of(const DetectionOptions& options) {
  return options.out.empty() ? files::path{"out"} / "campaign" / "detection" : files::path{options.out};
}

void show_one(const DetectionOptions& options) {
  if (options.kinds.size() != 1) {
    throw UsageError{"--event needs one --kind"};
  }
  const detection::Campaign campaign = asked_for(options);
  const detection::Kind kind = campaign.kinds.front();
  const std::uint64_t event = *text::whole_number(options.event);
  const detection::ShownEvent shown = detection::show_event(campaign, kind, event);
  const std::array<text::NamedFile, 1> page{{{fmt::format("{}_{}.html", detection::info(kind).name, event),
                                              detection::event_html(campaign, kind, event, shown)}}};
  text::OutputFolder{folder_of(options)}.write(page);
  fmt::print("{}  page  {}\n", shown.text, (folder_of(options) / page[0].name).string());
}

detection::Results play(const detection::Campaign& campaign, const files::path& folder, unsigned threads) {
  Progress progress{"detection",
                    {.unit = "events", .rate = " a second", .total = static_cast<double>(campaign.total())}};
  return detection::play(campaign, folder, FANTAIL_VERSION, threads, [&](std::uint64_t done) {
    if (take_interrupt()) {
      throw Interrupted{
          fmt::format("interrupted after {} of {} events; they are kept in {}, and the same command goes on from there",
                      done, campaign.total(), folder.string())};
    }
    progress.show(static_cast<double>(done));
  });
}

void detect(const DetectionOptions& options) {
  if (!options.event.empty()) {
    show_one(options);
    return;
  }
  const files::path folder = folder_of(options);
  detection::Report report{.campaign = asked_for(options), .results = {}, .version = FANTAIL_VERSION, .at_most = {}};
  if (options.at_most_percent) {
    report.at_most = *options.at_most_percent / 100.0;
  }
  report.false_at_most = options.false_at_most_percent / 100.0;
  report.results = play(report.campaign, folder, options.threads);
  const std::string summary = detection::report_json(report);
  const std::array<text::NamedFile, 2> results{
      {{"summary.json", summary}, {"detection.html", detection::report_html(report)}}};
  text::OutputFolder{folder}.write(results);
  if (options.json) {
    fmt::print("{}", summary);
  } else {
    fmt::print("{}  page  {}\n", detection::report_text(report), (folder / "detection.html").string());
  }
  if (!detection::failures(report).empty()) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

void fill_detection(const Verb& verb) {
  auto options = std::make_shared<DetectionOptions>();
  verb.option(
          "--plan", options->plans,
          "A shipped plan, a plan file, or published_launch2; may be given again [all shipped launch plans, and the "
          "second launch's rule as printed, which is shown and not judged]")
      .one_word_each_time();
  verb.option("--kind", options->kinds, "Only this kind of event; may be given again [all]")
      .one_word_each_time()
      .check(objection_to_kind);
  verb.option("--events", options->events, "How many of each kind that is no launch").range(0.0, 1e9).show_default();
  verb.option("--launches", options->launches, "How many of each kind that is a launch").range(0.0, 1e9).show_default();
  verb.flag("--both-well", options->both_well,
            "Only events in which both accelerometers are well; else in every second one of two is bad");
  verb.option("--seed", options->seed, "Of all that is drawn [1]").check(objection_to_whole_number);
  verb.option("--event", options->event, "Show this one event of --kind again, instead of a campaign")
      .check(objection_to_whole_number)
      .value_name("NUMBER");
  verb.option("--at-most", options->at_most_percent,
              "Ask that no more launches are missed than so many per cent, both accelerometers well; else exit code 1")
      .range(0.0, 100.0)
      .value_name("PERCENT");
  verb.option("--false-at-most", options->false_at_most_percent,
              "Let so many per cent of the events that are no launch move a canard [none]")
      .range(0.0, 100.0)
      .value_name("PERCENT");
  verb.option("--threads", options->threads, "How many at once [as many as the machine can]").range(1, 1024);
  verb.option("--out", options->out, "Folder for detection.html, summary.json and parts.jsonl [out/campaign/detection]")
      .check(objection_to_folder);
  verb.flag("--json", options->json, "Print summary.json instead of the text");
  verb.examples(
      "Armed, and in hands, dropped, on the road, shaken, beside another launch: how often does it believe that it "
      "flies, "
      "and how often do its canards move? Of launches: how many are missed, how late, how high?\n"
      "A campaign that was interrupted goes on when the same command is given again, also with more events.\n"
      "Exit code 0: no judged plan moved a canard in an event that was no launch, and what was asked for is met; else "
      "1.\n"
      "Examples:\n"
      "  fantail campaign detection --plan tasha3_launch2 --events 100000\n"
      "  fantail campaign detection --kind launch --launches 100000 --at-most 0.1\n"
      "  fantail campaign detection --kind shaking --event 1234        what happened in it, with a picture");
  verb.action([options] { detect(*options); });
}

}  // namespace fantail::tool
