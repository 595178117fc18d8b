// SPDX-License-Identifier: MIT
#include "campaign/campaign.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include <fmt/format.h>

#include "campaign/parallel_for.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"
#include "text/sha256.hpp"

namespace fantail::campaign {
namespace {

input::ScenarioFiles files_of(const Campaign& campaign) {
  input::ScenarioFiles files = input::ScenarioFiles::load(campaign.scenario, spread_word);
  for (const input::Override& change : campaign.changes) {
    files.apply(change);
  }
  return files;
}

Drawer drawer_of(const Campaign& campaign, const std::vector<Spread>& spreads) {
  return {spreads, campaign.sampling, campaign.seed, campaign.runs};
}

std::string hash_of(const std::string& text) { return text::sha256(std::as_bytes(std::span{text})); }

std::string words_of(const Campaign& campaign) {
  std::string words;
  for (const input::Override& change : campaign.changes) {
    words += words.empty() ? "" : " ";
    words += change.text();
  }
  return words.empty() ? "none" : words;
}

Identity identity_of(const Campaign& campaign, const input::ScenarioFiles& files, const std::vector<Spread>& spreads,
                     const std::string& version) {
  constexpr std::array<const char*, 3> sampling{"independent", "latin_hypercube", "sobol"};
  std::string tables;
  for (const Spread& spread : spreads) {
    for (const auto& row : spread.rows) {
      tables += fmt::format("{}\n", fmt::join(row, ","));
    }
  }
  return {{"version", version},
          {"seed", fmt::format("{}", campaign.seed)},
          {"runs", fmt::format("{}", campaign.runs)},
          {"sampling", sampling[static_cast<std::size_t>(campaign.sampling)]},
          {"changes", words_of(campaign)},
          {"scenario", hash_of(file_content(files.scenario().file()))},
          {"plan", hash_of(file_content(files.plan().file()))},
          {"vehicle", hash_of(file_content(files.vehicle().file()))},
          {"motor", hash_of(file_content(input::motor_file(files.vehicle())))},
          {"tables", hash_of(tables)},
          {"shard", fmt::format("{} of {}", campaign.shard.number, campaign.shard.of)}};
}

constexpr std::uint64_t chunks_of(std::uint64_t runs) { return (runs + runs_of_a_chunk - 1) / runs_of_a_chunk; }

constexpr std::uint64_t first_chunk_of(const Shard& shard, std::uint64_t chunks) {
  return chunks * (shard.number - 1) / shard.of;
}

/// From the first run of one chunk to the last before another.
Stretch stretch_of(std::uint64_t first_chunk, std::uint64_t end_chunk, std::uint64_t runs) {
  const std::uint64_t first = std::min(first_chunk * runs_of_a_chunk, runs);
  return {.first = first, .count = std::min(end_chunk * runs_of_a_chunk, runs) - first};
}

std::vector<Spread> spreads_of(const input::ScenarioFiles& files) {
  std::vector<Spread> spreads = read_spreads(files);
  if (spreads.empty()) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      files.scenario().file() + ": says of nothing how it is spread; allowed: one [[spread]] or more"};
  }
  return spreads;
}

}  // namespace

Stretch runs_of_shard(std::uint64_t runs, const Shard& shard) {
  const std::uint64_t chunks = chunks_of(runs);
  return stretch_of(first_chunk_of(shard, chunks), first_chunk_of({shard.number + 1, shard.of}, chunks), runs);
}

std::vector<FlownRun> fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                   const std::string& version, unsigned threads,
                                   const std::function<void(std::uint64_t)>& look) {
  if (campaign.runs == 0) {
    throw text::Error{text::ErrorKind::bad_configuration, "0 runs; allowed: 1 or more"};
  }
  const Shard& shard = campaign.shard;
  const std::uint64_t chunks = chunks_of(campaign.runs);
  if (shard.number < 1 || shard.number > shard.of || shard.of > chunks) {
    throw text::Error{text::ErrorKind::bad_configuration,
                      fmt::format("shard {} of {}; allowed: 1 to as many as there are, and of at most {}, because {} "
                                  "runs are flown by {} together",
                                  shard.number, shard.of, chunks, campaign.runs, runs_of_a_chunk)};
  }
  const input::ScenarioFiles files = files_of(campaign);
  (void)files.read();  // what is drawn about must fly itself
  const std::vector<Spread> spreads = spreads_of(files);
  const Drawer drawer = drawer_of(campaign, spreads);
  const std::uint64_t first_chunk = first_chunk_of(shard, chunks);
  const std::uint64_t end_chunk = first_chunk_of({shard.number + 1, shard.of}, chunks);
  const Stretch own_runs = runs_of_shard(campaign.runs, shard);
  for (std::uint64_t i = 0; i < own_runs.count; ++i) {
    (void)drawer.draw(own_runs.first + i);
  }
  const RunsFolder store{folder, identity_of(campaign, files, spreads, version), spreads};
  if (auto runs = store.finished(own_runs, campaign.seed)) {
    store.remove_chunks();  // of which the process that finished it may have left some
    return *std::move(runs);
  }
  std::vector<FlownRun> all(own_runs.count);
  std::atomic<std::uint64_t> done{0};
  parallel_for(
      end_chunk - first_chunk, threads,
      [&](std::size_t i) {
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
        std::ranges::move(*runs, all.begin() + static_cast<std::ptrdiff_t>(stretch.first - own_runs.first));
      },
      [&](std::size_t) { look(done); });
  store.finish(first_chunk, end_chunk);
  return all;
}

FlownRun fly_run_alone(const Campaign& campaign, std::uint64_t run) {
  input::ScenarioFiles files = files_of(campaign);
  return fly_run(files, drawer_of(campaign, spreads_of(files)), campaign.seed, run);
}

}  // namespace fantail::campaign
