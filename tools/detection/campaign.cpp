// SPDX-License-Identifier: MIT
#include "detection/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <ctime>
#include <memory>
#include <mutex>

#include "campaign/parallel_for.hpp"
#include "detection/parts_file.hpp"
#include "detection/rehearsal.hpp"

namespace fantail::detection {
namespace {

struct Chunk {
  Kind kind;
  std::uint64_t number;
  std::uint64_t first;
  std::uint64_t events;
};

std::vector<Chunk> chunks_of(const Campaign& campaign) {
  std::vector<Chunk> chunks;
  for (const Kind kind : campaign.kinds) {
    const std::uint64_t size = events_of_a_chunk(kind);
    const std::uint64_t total = campaign.number_of(kind);
    for (std::uint64_t number = 0; number * size < total; ++number) {
      chunks.push_back(
          {.kind = kind, .number = number, .first = number * size, .events = std::min(size, total - number * size)});
    }
  }
  return chunks;
}

/// What the threads that play and the one that looks have in common.
struct Shared {
  std::atomic<std::uint64_t> done;
  std::atomic<bool> stop{false};
};

/// Empty: stopped.
std::optional<Tally> played(const Campaign& campaign, const Chunk& chunk, Shared& shared) {
  Rehearsal rehearsal{campaign.rules};
  Tally tally{campaign.rules.size()};
  for (std::uint64_t turn = chunk.first; turn < chunk.first + chunk.events; ++turn) {
    if (shared.stop) {
      return std::nullopt;
    }
    const std::uint64_t event = campaign.event(chunk.kind, turn);
    const std::vector<Answer>& answers = rehearsal.play(campaign.seed, chunk.kind, event);
    tally.count(chunk.kind, event, campaign.rules, answers, truth_of(rehearsal.motion()));
    ++shared.done;
  }
  return tally;
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
  std::unique_ptr<PartsFile> parts;
  if (folder) {
    parts = std::make_unique<PartsFile>(*folder, campaign, program);
  }
  const std::vector<Chunk> chunks = chunks_of(campaign);
  Results results;
  for (const Kind kind : campaign.kinds) {
    results.of_kind[index(kind)].emplace(campaign.rules.size());
  }
  std::vector<std::size_t> to_play;
  std::uint64_t stored = 0;
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    const Tally* const there = parts ? parts->find(chunks[i].kind, chunks[i].number, chunks[i].events) : nullptr;
    if (there != nullptr) {
      results.of_kind[index(chunks[i].kind)]->add(*there);
      stored += chunks[i].events;
    } else {
      to_play.push_back(i);
    }
  }
  Shared shared{.done = stored};
  std::atomic<std::uint64_t> microseconds{0};
  std::mutex adding;
  campaign::parallel_for(
      to_play.size(), threads,
      [&](std::size_t i) {
        const Chunk& chunk = chunks[to_play[i]];
        const double begin_s = thread_time_s();
        const std::optional<Tally> tally = played(campaign, chunk, shared);
        microseconds += static_cast<std::uint64_t>(1e6 * (thread_time_s() - begin_s));
        if (!tally) {
          return;
        }
        if (parts) {
          parts->store(chunk.kind, chunk.number, chunk.events, *tally);
        }
        const std::lock_guard lock{adding};  // in any order: the sum is the same
        results.of_kind[index(chunk.kind)]->add(*tally);
      },
      [&](std::size_t) {
        try {
          look(shared.done);
        } catch (...) {
          shared.stop = true;
          throw;
        }
      });

  results.played = shared.done - stored;
  results.damaged = parts ? parts->damaged() : 0;
  results.processor_s = 1e-6 * static_cast<double>(microseconds);
  return results;
}

}  // namespace fantail::detection
