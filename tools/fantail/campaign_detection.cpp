// SPDX-License-Identifier: MIT
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
#include "fantail/deliver.hpp"
#include "fantail/many_flights.hpp"
#include "fantail/offers.hpp"
#include "fantail/progress.hpp"
#include "fantail/run.hpp"
#include "fantail/scenario_options.hpp"
#include "fantail/standard_streams.hpp"
#include "fantail/terminal.hpp"
#include "input/shipped.hpp"
#include "text/number.hpp"

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
  std::optional<double> false_at_most_percent;
  unsigned threads = 0;
  std::string out;
  bool json = false;
  Asked asked;
};

std::string objection_to_kind(const std::string& text) {
  if (detection::kind_of(text)) {
    return "";
  }
  std::vector<std::string_view> names;
  names.reserve(detection::kind_table.size());
  for (const detection::KindInfo& kind : detection::kind_table) {
    names.push_back(kind.name);
  }
  return fmt::format("\"{}\" is not a kind of event; allowed: {}", text, fmt::join(names, ", "));
}

std::string objection_to_whole_number(const std::string& text) {
  return text::whole_number(text) ? "" : '"' + text + "\" is not a whole number from 0 to 18446744073709551615";
}

detection::Campaign asked_for(const DetectionOptions& options) {
  detection::Campaign campaign{
      .rules = detection::rules_of(options.plans), .kinds = {}, .events = options.events, .launches = options.launches};
  campaign.both_well = options.both_well;
  campaign.plans = options.plans;
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

/// Another folder for each campaign that cannot go on in one of the others, and for a page of some kinds alone.
files::path folder_of(const DetectionOptions& options) {
  std::vector<std::string> changes = options.asked.changes;
  if (!options.event.empty()) {  // the name of its page says the kind
    std::erase_if(changes, [](const std::string& change) { return change.starts_with("kind="); });
  }
  return results_folder(options.out, "campaign", "detection", changes);
}

void show_one(const DetectionOptions& options) {
  if (options.kinds.size() != 1) {
    throw UsageError{"--event needs one --kind"};
  }
  const detection::Campaign campaign = asked_for(options);
  const detection::Kind kind = campaign.kinds.front();
  const std::uint64_t event = *text::whole_number(options.event);
  if (options.both_well && !detection::is_launch(kind) && campaign.event(kind, event / 2) != event) {
    throw UsageError{
        fmt::format("--both-well leaves out {} {}: one accelerometer is bad in it", detection::info(kind).name, event)};
  }
  const result::Document shown = detection::event_answer(campaign, kind, event, made_with({}, campaign.seed));
  deliver(shown, {.folder = folder_of(options),
                  .name = fmt::format("{}_{}", detection::info(kind).name, event),
                  .json = options.json});
}

detection::Results play(const detection::Campaign& campaign, const files::path& folder, unsigned threads) {
  Progress progress{"playing events to launch detection",
                    {.unit = "events", .rate = " a second", .total = static_cast<double>(campaign.total())}};
  return detection::play(campaign, folder, program_that_flies(), threads, [&](std::uint64_t done) {
    leave_if_interrupted(folder);
    progress.show(static_cast<double>(done));
  });
}

void detect(const DetectionOptions& options) {
  if (!options.event.empty()) {
    show_one(options);
    return;
  }
  const files::path folder = folder_of(options);
  detection::Report report{.campaign = asked_for(options), .results = {}};
  report.campaign.drop_empty_kinds();
  if (report.campaign.kinds.empty()) {
    throw UsageError{
        "there is nothing to play; allowed: --events or --launches of 1 or more, for a --kind that was chosen"};
  }
  if (options.at_most_percent) {
    report.at_most = *options.at_most_percent / 100.0;
    if (!detection::judges_launches(report.campaign)) {
      throw UsageError{
          "--at-most needs launches with both accelerometers healthy and a plan that is judged. Allowed: --kind "
          "launch, launch_at_2_g or stirred_launch, --launches of 1 or more, and another plan than published_launch2"};
    }
  }
  if (options.false_at_most_percent) {
    report.false_at_most = *options.false_at_most_percent / 100.0;
    if (!detection::judges_events(report.campaign)) {
      throw UsageError{
          "--false-at-most needs events that are not launches and a plan that is judged; none would be played"};
    }
  }
  report.made = made_with({}, report.campaign.seed, options.asked.changes);
  report.results = play(report.campaign, folder, options.threads);
  if (report.results.damaged > 0) {
    say(fmt::format("fantail: {} stored parts in {} were damaged, and have been played again\n", report.results.damaged,
                    folder.string()));
  }
  const detection::Results& results = report.results;
  deliver(detection::answer(report),
          {.folder = folder,
           .name = "summary",
           .page = "detection",
           .json = options.json,
           .last_line = results.played == 0 || results.processor_s <= 0.0
                            ? ""
                            : fmt::format("  played   {} events now, {:.0f} a second and core", results.played,
                                          static_cast<double>(results.played) / results.processor_s)});
  if (detection::verdict(detection::requirements(report)) == detection::Verdict::not_met) {
    throw RequirementNotMet{""};
  }
}

}  // namespace

void fill_detection(const Verb& verb) {
  auto options = std::make_shared<DetectionOptions>();
  verb.option("--plan", options->plans,
              "A shipped plan, a plan file, or published_launch2; repeatable [all shipped launch plans and "
              "published_launch2, the rule of the second launch as printed]. Without this option, only plans that use "
              "two accelerometers are judged. A named plan is always judged, except published_launch2")
      .offers(shipped(input::Shipped::plan))
      .one_word_each_time()
      .changes_result();
  verb.section("Events");
  verb.option("--kind", options->kinds, "Only this kind of event; repeatable [all]")
      .one_word_each_time()
      .check(objection_to_kind)
      .changes_result();
  auto events = verb.option("--events", options->events, "Number of events of each kind that is not a launch");
  events.range(0.0, 1e9).show_default();
  auto launches = verb.option("--launches", options->launches, "Number of events of each kind of launch");
  launches.range(0.0, 1e9).show_default();
  verb.flag("--both-well", options->both_well,
            "Only events with both accelerometers healthy; without it, every second event has one bad accelerometer")
      .changes_result();
  verb.option("--seed", options->seed, "Seed of everything that is drawn [1]")
      .check(objection_to_whole_number)
      .changes_result();
  auto event = verb.option("--event", options->event, "Show this one event of --kind again, instead of a campaign");
  event.check(objection_to_whole_number).value_name("NUMBER");
  event.excludes(events).excludes(launches);
  verb.option("--at-most", options->at_most_percent,
              "Require that at most this share of launches is missed, by the 95 % bound, with both accelerometers "
              "healthy; otherwise exit code 1")
      .range(0.0, 100.0)
      .value_name("PERCENT")
      .excludes(event);
  verb.section("Results");
  verb.option("--false-at-most", options->false_at_most_percent,
              "Permit this share of all events that are not launches to move a canard, with both accelerometers "
              "healthy. It is compared with the 95 % bound, which is never 0 [no played event may move a canard]")
      .range(0.0, 100.0)
      .value_name("PERCENT")
      .excludes(event);
  add_threads_option(verb, options->threads);
  verb.option("--out", options->out,
              "Folder for detection.html, summary.json and the parts [out/campaign/detection, with what was changed in "
              "the name]")
      .offers(folders);
  verb.flag("--json", options->json, "Print summary.json instead of the text; with --event, its result");
  verb.examples(
      "Plays events around an armed rocket: handling, drops, transport, shaking, a launch nearby, the recovery "
      "after an undetected flight. Shows how often it detects a false launch and how often its canards move. For "
      "launches: how many are missed, and the errors of time, height and tilt.\n"
      "To continue an interrupted campaign, repeat the command; --events may be larger.\n"
      "Exit code 1: with both accelerometers healthy, a judged plan moved canards without a launch, or missed "
      "launches, more often than permitted; else 0. Results with one bad accelerometer are shown but not judged.\n"
      "Examples:\n"
      "  fantail campaign detection --plan tasha3_launch2 --events 100000\n"
      "  fantail campaign detection --kind launch --launches 100000 --at-most 0.1\n"
      "  fantail campaign detection --kind shaking --event 1234        one event in detail, with a picture");
  verb.action([options, verb] {
    options->asked = verb.asked();
    detect(*options);
  });
}

}  // namespace fantail::tool
