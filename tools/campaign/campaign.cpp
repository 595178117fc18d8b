// SPDX-License-Identifier: MIT
#include "campaign/campaign.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "campaign/setup.hpp"
#include "text/deflate.hpp"
#include "text/error.hpp"
#include "text/output_folder.hpp"

namespace fantail::campaign {
namespace {

void check(const Campaign& campaign) {
  const auto refuse = [](const std::string& complaint) {
    throw text::Error{text::ErrorKind::bad_configuration, complaint};
  };
  if (campaign.runs == 0) {
    refuse("0 runs; allowed: 1 or more");
  }
  const Shard& shard = campaign.shard;
  const std::uint64_t parts = (campaign.runs + runs_of_a_part - 1) / runs_of_a_part;
  if (shard.number < 1 || shard.number > shard.of || shard.of > parts) {
    refuse(
        fmt::format("shard {} of {}; allowed: 1 to the number of shards, and of at most {}, because {} runs are flown "
                    "in groups of {}",
                    shard.number, shard.of, parts, campaign.runs, runs_of_a_part));
  }
  if (campaign.stop && shard.of > 1) {
    refuse("a campaign can stop early only as a whole: its stopping bounds hold for the runs in their order");
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
      throw text::OutputError{spread.table.string() + ": these results are made from it; choose another folder"};
    }
  }
}

}  // namespace

FlownCampaign fly_campaign(const Campaign& campaign, const std::filesystem::path& folder, const std::string& version,
                           unsigned threads, const std::function<void(std::uint64_t)>& look) {
  check(campaign);
  const input::ScenarioFiles files = files_of(campaign);
  const sim::Scenario middle = files.read();  // what is drawn about must fly itself
  const std::vector<Spread> spreads = spreads_of(campaign, files);
  spare_tables(spreads, folder);
  const Drawer drawer = drawer_of(campaign, spreads);
  const Stretch own_runs = runs_of_shard(campaign.runs, campaign.shard);
  for (std::uint64_t i = 0; i < own_runs.count; ++i) {
    (void)drawer.draw(own_runs.first + i);
  }
  FlownCampaign flown{.scenario = middle.name,
                      .vehicle = middle.vehicle.name,
                      .plan = middle.plan_name,
                      .quantities = quantity_names(spreads),
                      .runs = {}};
  Identity identity = identity_of(campaign, files, spreads, version);
  if (campaign.stop) {
    std::ranges::find(identity, "stop", &Identity::value_type::first)->second = campaign.stop->text();
  }
  runs::Place place{.folder = folder, .identity = identity};
  place.identity.insert(place.identity.begin(), {"kind", "campaign"});
  require_no_other(folder, identity);
  const runs::Folder store{place};
  require_no_other(folder, identity);  // since the first look, by another process
  if (!std::filesystem::exists(folder / identity_name)) {
    text::OutputFolder{folder}.write(
        std::array{text::NamedFile{.name = identity_name, .content = runs::identity_json(identity)}});
  }
  Finished before = finished_runs(folder, own_runs, campaign.seed, spreads, campaign.stop.has_value());
  if (before.runs && (!campaign.stop || stops_at(*campaign.stop, *before.runs) == before.runs->size())) {
    store.remove();  // of which the process that finished it may have left some
    flown.runs = *std::move(before.runs);
    flown.remark = std::move(before.remark);
    return flown;
  }
  if (const auto file = folder / runs_name; std::filesystem::exists(file)) {
    flown.remark =
        (before.runs ? file.string() + ": does not have the runs that its stop rule requires" : before.remark) +
        "; its runs have been flown again";
  }
  flown.runs.resize(own_runs.count);
  const auto rows_of = [&](const runs::Part& part) {
    return std::span{flown.runs}.subspan(part.flights.first - own_runs.first, part.flights.count);
  };
  runs::Flights flights{.parts = runs::parts_of(own_runs, runs_of_a_part)};
  flights.fly = [&](std::size_t i, const std::function<void()>& flew_one) {
    input::ScenarioFiles own = files_of(campaign);
    std::vector<FlownRun> rows;
    const Stretch& stretch = flights.parts[i].flights;
    for (std::uint64_t run = stretch.first; run < stretch.first + stretch.count; ++run) {
      rows.push_back(fly_run(own, drawer, campaign.seed, run));
      flew_one();
    }
    return packed_rows(rows);
  };
  flights.take = [&](std::size_t i, const std::string& packed) {
    auto rows = unpacked_rows(packed, flights.parts[i].flights, campaign.seed, spreads);
    if (rows) {
      std::ranges::move(*rows, rows_of(flights.parts[i]).begin());
    }
    return rows.has_value();
  };
  if (campaign.stop) {
    flights.is_enough = [&, stopping = Stopping{*campaign.stop}](std::size_t i) mutable {
      return stopping.take(rows_of(flights.parts[i]));
    };
  }
  const runs::Summary summary = runs::run(flights, &store, threads, look);
  flights.parts.resize(summary.parts);
  std::string all = text::gzip(header_row(spreads));
  for (const runs::Part& part : flights.parts) {
    all += store.stored(part.name).value();
  }
  text::OutputFolder{folder}.write(std::array{text::NamedFile{.name = runs_name, .content = std::move(all)}});
  store.remove();
  flown.runs.resize(std::min<std::uint64_t>(summary.parts * runs_of_a_part, own_runs.count));
  if (summary.damaged > 0 && flown.remark.empty()) {
    flown.remark =
        fmt::format("{} stored parts in {} were damaged, and have been flown again", summary.damaged, folder.string());
  }
  return flown;
}

}  // namespace fantail::campaign
