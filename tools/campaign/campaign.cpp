// SPDX-License-Identifier: MIT
#include "campaign/campaign.hpp"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <span>

#include <fmt/format.h>

#include "campaign/parallel_for.hpp"
#include "campaign/setup.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::campaign {
namespace {

constexpr std::uint64_t chunks_of(std::uint64_t runs) { return (runs + runs_of_a_chunk - 1) / runs_of_a_chunk; }

constexpr std::uint64_t first_chunk_of(const Shard& shard, std::uint64_t chunks) {
  return chunks * (shard.number - 1) / shard.of;
}

/// From the first run of one chunk to the last before another.
Stretch stretch_of(std::uint64_t first_chunk, std::uint64_t end_chunk, std::uint64_t runs) {
  const std::uint64_t first = std::min(first_chunk * runs_of_a_chunk, runs);
  return {.first = first, .count = std::min(end_chunk * runs_of_a_chunk, runs) - first};
}

/// The chunks that are finished without a gap before them, and how many of all are enough.
class InOrder {
 public:
  InOrder(std::uint64_t chunks, const std::optional<StopRule>& rule) : finished_(chunks, false), end_{chunks} {
    if (rule) {
      stopping_.emplace(*rule);
    }
  }

  [[nodiscard]] std::uint64_t end() const { return end_; }

  void finished(std::size_t chunk, std::span<const FlownRun> all) {
    const std::lock_guard lock{mutex_};
    finished_[chunk] = true;
    for (; stopping_ && next_ < end_ && finished_[next_]; ++next_) {
      const std::uint64_t first = next_ * runs_of_a_chunk;
      if (stopping_->take(all.subspan(first, std::min(runs_of_a_chunk, all.size() - first)))) {
        end_ = next_ + 1;
      }
    }
  }

 private:
  std::mutex mutex_;
  std::vector<bool> finished_;
  std::uint64_t next_ = 0;
  std::atomic<std::uint64_t> end_;
  std::optional<Stopping> stopping_{};
};

void check(const Campaign& campaign) {
  const auto refuse = [](const std::string& complaint) {
    throw text::Error{text::ErrorKind::bad_configuration, complaint};
  };
  if (campaign.runs == 0) {
    refuse("0 runs; allowed: 1 or more");
  }
  const Shard& shard = campaign.shard;
  const std::uint64_t chunks = chunks_of(campaign.runs);
  if (shard.number < 1 || shard.number > shard.of || shard.of > chunks) {
    refuse(
        fmt::format("shard {} of {}; allowed: 1 to as many as there are, and of at most {}, because {} "
                    "runs are flown by {} together",
                    shard.number, shard.of, chunks, campaign.runs, runs_of_a_chunk));
  }
  if (campaign.stop && shard.of > 1) {
    refuse("a campaign can stop early only as a whole: the bounds that it stops by hold for its runs in their order");
  }
}

/// Of what else a campaign is made from the results have another name, or are refused when they are written.
void spare_tables(const std::vector<Spread>& spreads, const std::filesystem::path& folder) {
  for (const Spread& spread : spreads) {
    if (spread.table.empty()) {
      continue;
    }
    const std::filesystem::path beside = std::filesystem::absolute(spread.table).parent_path();
    if (std::error_code not_there; std::filesystem::equivalent(beside, folder, not_there)) {
      throw text::OutputError{spread.table.string() + ": is what these results are made from; choose another folder"};
    }
  }
}

}  // namespace

Stretch runs_of_shard(std::uint64_t runs, const Shard& shard) {
  const std::uint64_t chunks = chunks_of(runs);
  return stretch_of(first_chunk_of(shard, chunks), first_chunk_of({shard.number + 1, shard.of}, chunks), runs);
}

FlownCampaign fly_campaign(const Campaign& campaign, const std::filesystem::path& folder, const std::string& version,
                           unsigned threads, const std::function<void(std::uint64_t)>& look) {
  check(campaign);
  const input::ScenarioFiles files = files_of(campaign);
  const sim::Scenario middle = files.read();  // what is drawn about must fly itself
  const std::vector<Spread> spreads = spreads_of(campaign, files);
  spare_tables(spreads, folder);
  const Drawer drawer = drawer_of(campaign, spreads);
  const std::uint64_t chunks = chunks_of(campaign.runs);
  const std::uint64_t first_chunk = first_chunk_of(campaign.shard, chunks);
  const std::uint64_t end_chunk = first_chunk_of({campaign.shard.number + 1, campaign.shard.of}, chunks);
  const Stretch own_runs = runs_of_shard(campaign.runs, campaign.shard);
  for (std::uint64_t i = 0; i < own_runs.count; ++i) {
    (void)drawer.draw(own_runs.first + i);
  }
  FlownCampaign flown{.scenario = middle.name,
                      .vehicle = middle.vehicle.name,
                      .plan = middle.plan_name,
                      .quantities = quantity_names(spreads),
                      .runs = {}};
  const RunsFolder store{folder, identity_of(campaign, files, spreads, version), spreads};
  RunsFolder::Finished before = store.finished(own_runs, campaign.seed, campaign.stop.has_value());
  if (before.runs && (!campaign.stop || stops_at(*campaign.stop, *before.runs) == before.runs->size())) {
    store.remove_chunks();  // of which the process that finished it may have left some
    flown.runs = *std::move(before.runs);
    flown.remark = std::move(before.remark);
    return flown;
  }
  if (const auto file = folder / RunsFolder::runs_name; std::filesystem::exists(file)) {
    flown.remark = (before.runs ? file.string() + ": has not the runs that its stop rule asks for" : before.remark) +
                   "; its runs have been flown again";
  }
  flown.runs.resize(own_runs.count);
  InOrder order{end_chunk - first_chunk, campaign.stop};
  std::atomic<std::uint64_t> done{0};
  parallel_for(
      end_chunk - first_chunk, threads,
      [&](std::size_t i) {
        if (i >= order.end()) {
          return;  // the chunks before it are enough
        }
        const std::uint64_t chunk = first_chunk + i;
        const Stretch stretch = stretch_of(chunk, chunk + 1, campaign.runs);
        auto runs = store.stored(chunk, stretch, campaign.seed);
        if (runs) {
          done += stretch.count;
        } else {
          input::ScenarioFiles own = files_of(campaign);
          runs.emplace();
          for (std::uint64_t k = 0; k < stretch.count; ++k) {
            runs->push_back(fly_run(own, drawer, campaign.seed, stretch.first + k));
            ++done;
          }
          store.store(chunk, *runs);
        }
        std::ranges::move(*runs, flown.runs.begin() + static_cast<std::ptrdiff_t>(stretch.first - own_runs.first));
        order.finished(i, flown.runs);
      },
      [&](std::size_t) { look(done); });
  flown.runs.resize(std::min<std::uint64_t>(order.end() * runs_of_a_chunk, own_runs.count));
  store.finish(first_chunk, first_chunk + order.end());
  return flown;
}

}  // namespace fantail::campaign
