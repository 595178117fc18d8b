// SPDX-License-Identifier: MIT
#include "detection/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <iterator>
#include <mutex>

#include <fmt/core.h>

#include "detection/rehearsal.hpp"
#include "runs/runner.hpp"

namespace fantail::detection {
namespace {

Tally played(const Campaign& campaign, Kind kind, const runs::Stretch& turns, const std::function<void()>& played_one) {
  Rehearsal rehearsal{campaign.rules};
  Tally tally{campaign.rules.size()};
  for (std::uint64_t turn = turns.first; turn < turns.first + turns.count; ++turn) {
    const std::uint64_t event = campaign.event(kind, turn);
    const std::vector<Answer>& answers = rehearsal.play(campaign.seed, kind, event);
    tally.count(kind, event, campaign.rules, answers, truth_of(rehearsal.motion()));
    played_one();
  }
  return tally;
}

runs::Identity identity_of(const Campaign& campaign, const std::string& program) {
  std::string names;
  std::string texts;
  for (const Rule& rule : campaign.rules) {
    names += (names.empty() ? "" : "; ") + rule.name();
    texts += identity_of(rule) + '\n';
  }
  return {{"kind", "campaign detection"},
          {"seed", fmt::format("{}", campaign.seed)},
          {"both_well", campaign.both_well ? "yes" : "no"},
          {"plans", names},
          {"rules", runs::short_digest(texts)},
          {"program", program},
          {"events", runs::short_digest(fingerprint(campaign.rules))}};
}

/// Of this thread, so that a busy machine does not look slow.
double thread_time_s() {
  timespec now{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::uint64_t Campaign::total() const {
  std::uint64_t sum = 0;
  for (const Kind kind : kinds) {
    sum += number_of(kind);
  }
  return sum;
}

void Campaign::drop_empty_kinds() {
  std::erase_if(kinds, [this](Kind kind) { return number_of(kind) == 0; });
}

Results play(const Campaign& campaign, const std::optional<std::filesystem::path>& folder, const std::string& program,
             unsigned threads, const std::function<void(std::uint64_t done)>& look) {
  std::optional<runs::Folder> kept;
  if (folder) {
    kept.emplace(
        runs::Place{.folder = *folder, .identity = identity_of(campaign, program), .not_beside = "campaign.json"});
  }
  Results results;
  runs::Flights flights;
  std::vector<Kind> kind_of;  // a part
  for (const Kind kind : campaign.kinds) {
    results.of_kind[index(kind)].emplace(campaign.rules.size());
    std::ranges::move(runs::parts_of({.first = 0, .count = campaign.number_of(kind)}, events_of_a_chunk(kind),
                                     fmt::format("{}.", info(kind).name)),
                      std::back_inserter(flights.parts));
    kind_of.resize(flights.parts.size(), kind);
  }
  std::atomic<std::uint64_t> microseconds{0};
  std::mutex adding;
  flights.fly = [&](std::size_t i, const std::function<void()>& played_one) {
    const double begin_s = thread_time_s();
    Tally tally = played(campaign, kind_of[i], flights.parts[i].flights, played_one);
    microseconds += static_cast<std::uint64_t>(1e6 * (thread_time_s() - begin_s));
    runs::RowText text;
    text(flights.parts[i].flights.count, tally);
    return text.text();
  };
  flights.take = [&](std::size_t i, const std::string& text) {
    std::uint64_t events = 0;
    Tally tally{0};
    runs::RowText reader{text};
    reader(events, tally);
    if (!reader.is_read() || events != flights.parts[i].flights.count ||
        tally.of_rule.size() != campaign.rules.size()) {
      return false;
    }
    const std::lock_guard lock{adding};  // in any order: the sum is the same
    results.of_kind[index(kind_of[i])]->add(tally);
    return true;
  };
  const runs::Summary summary = runs::run(flights, kept ? &*kept : nullptr, threads, look);
  results.played = summary.flown;
  results.damaged = summary.damaged;
  results.processor_s = 1e-6 * static_cast<double>(microseconds);
  return results;
}

}  // namespace fantail::detection
