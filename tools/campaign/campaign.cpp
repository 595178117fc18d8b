// SPDX-License-Identifier: MIT
#include "campaign/campaign.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <sha256.h>

#include "campaign/parallel_for.hpp"
#include "campaign/runs_folder.hpp"
#include "input/vehicle_file.hpp"
#include "text/error.hpp"

namespace fantail::campaign {
namespace {

input::ScenarioFiles files_of(const Campaign& campaign) {
  input::ScenarioFiles files = input::ScenarioFiles::load(campaign.scenario);
  for (const input::Override& change : campaign.changes) {
    files.apply(change);
  }
  return files;
}

Drawer drawer_of(const Campaign& campaign, const std::vector<Spread>& spreads) {
  return {spreads, campaign.sampling, campaign.seed, campaign.runs};
}

std::string sha256(const std::string& text) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> digits{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), digits.data());
  return digits.data();
}

std::string hash_of(const std::filesystem::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return sha256({std::istreambuf_iterator<char>{stream}, {}});
}

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
          {"scenario", hash_of(files.scenario().file())},
          {"plan", hash_of(files.plan().file())},
          {"vehicle", hash_of(files.vehicle().file())},
          {"motor", hash_of(input::motor_file(files.vehicle()))},
          {"tables", sha256(tables)}};
}

/// Of one chunk.
struct Stretch {
  std::uint64_t first;
  std::uint64_t count;
};

Stretch stretch_of(std::uint64_t chunk, std::uint64_t runs) {
  const std::uint64_t first = chunk * runs_of_a_chunk;
  return {.first = first, .count = std::min(runs_of_a_chunk, runs - first)};
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

std::vector<FlownRun> fly_campaign(const Campaign& campaign, const std::filesystem::path& folder,
                                   const std::string& version, unsigned threads,
                                   const std::function<void(std::uint64_t)>& look) {
  if (campaign.runs == 0) {
    throw text::Error{text::ErrorKind::bad_configuration, "0 runs; allowed: 1 or more"};
  }
  const input::ScenarioFiles files = files_of(campaign);
  (void)files.read();  // what is wrong with it without any draw is wrong with every run
  const std::vector<Spread> spreads = spreads_of(files);
  const Drawer drawer = drawer_of(campaign, spreads);
  for (std::uint64_t run = 0; run < campaign.runs; ++run) {
    (void)drawer.draw(run);
  }
  const RunsFolder store{folder, identity_of(campaign, files, spreads, version), spreads};
  const std::uint64_t chunks = (campaign.runs + runs_of_a_chunk - 1) / runs_of_a_chunk;
  std::vector<FlownRun> all(campaign.runs);
  std::atomic<std::uint64_t> done{0};
  parallel_for(
      chunks, threads,
      [&](std::size_t chunk) {
        const auto [first, count] = stretch_of(chunk, campaign.runs);
        auto runs = store.stored(chunk, first, count, campaign.seed);
        if (!runs) {
          input::ScenarioFiles own = files_of(campaign);
          runs.emplace();
          for (std::uint64_t i = 0; i < count; ++i) {
            runs->push_back(fly_run(own, drawer, campaign.seed, first + i));
            ++done;
          }
          store.store(chunk, *runs);
        } else {
          done += count;
        }
        std::ranges::move(*runs, all.begin() + static_cast<std::ptrdiff_t>(first));
      },
      [&](std::size_t) { look(done); });
  store.finish(chunks);
  return all;
}

FlownRun fly_run_alone(const Campaign& campaign, std::uint64_t run) {
  input::ScenarioFiles files = files_of(campaign);
  return fly_run(files, drawer_of(campaign, spreads_of(files)), campaign.seed, run);
}

}  // namespace fantail::campaign
