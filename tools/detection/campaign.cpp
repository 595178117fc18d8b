// SPDX-License-Identifier: MIT
#include "detection/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <mutex>

#include <fmt/core.h>

#include "detection/fingerprint.hpp"
#include "detection/rehearsal.hpp"
#include "runs/runner.hpp"

namespace fantail::detection {
namespace {

/// The events of one kind that are played together.
struct Chunk {
  Kind kind;
  std::uint64_t first;
  std::uint64_t events;
};

std::vector<Chunk> chunks_of(const Campaign& campaign) {
  std::vector<Chunk> chunks;
  for (const Kind kind : campaign.kinds) {
    const std::uint64_t size = events_of_a_chunk(kind);
    const std::uint64_t total = campaign.number_of(kind);
    for (std::uint64_t first = 0; first < total; first += size) {
      chunks.push_back({.kind = kind, .first = first, .events = std::min(size, total - first)});
    }
  }
  return chunks;
}

Tally played(const Campaign& campaign, const Chunk& chunk, const std::function<void()>& played_one) {
  Rehearsal rehearsal{campaign.rules};
  Tally tally{campaign.rules.size()};
  for (std::uint64_t turn = chunk.first; turn < chunk.first + chunk.events; ++turn) {
    const std::uint64_t event = campaign.event(chunk.kind, turn);
    const std::vector<Answer>& answers = rehearsal.play(campaign.seed, chunk.kind, event);
    tally.count(chunk.kind, event, campaign.rules, answers, truth_of(rehearsal.motion()));
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
  std::vector<Chunk> chunks = chunks_of(campaign);
  Results results;
  for (const Kind kind : campaign.kinds) {
    results.of_kind[index(kind)].emplace(campaign.rules.size());
  }
  std::atomic<std::uint64_t> microseconds{0};
  std::mutex adding;
  runs::Flights flights;
  for (const Chunk& chunk : chunks) {
    flights.parts.push_back({.name = fmt::format("{}.{:010}", info(chunk.kind).name, chunk.first),
                             .flights = {.first = chunk.first, .count = chunk.events}});
  }
  flights.fly = [&](std::size_t i, const std::function<void()>& played_one) {
    const double begin_s = thread_time_s();
    Tally tally = played(campaign, chunks[i], played_one);
    microseconds += static_cast<std::uint64_t>(1e6 * (thread_time_s() - begin_s));
    runs::RowText text;
    text(chunks[i].events, tally);
    return text.text();
  };
  flights.take = [&](std::size_t i, const std::string& text) {
    std::uint64_t events = 0;
    Tally tally{0};
    runs::RowReader reader{text};
    reader(events, tally);
    if (!reader.is_done() || events != chunks[i].events || tally.of_rule.size() != campaign.rules.size()) {
      return false;
    }
    const std::lock_guard lock{adding};  // in any order: the sum is the same
    results.of_kind[index(chunks[i].kind)]->add(tally);
    return true;
  };
  const runs::Summary summary = runs::run(flights, kept ? &*kept : nullptr, threads, look);
  results.played = summary.flown;
  results.damaged = summary.damaged;
  results.processor_s = 1e-6 * static_cast<double>(microseconds);
  return results;
}

}  // namespace fantail::detection
