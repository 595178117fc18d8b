// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace fantail::campaign {

/// Puts the runs of all shards of one campaign into the folder `out`: the bytes of runs.csv.gz and of campaign.json are
/// those of the campaign flown as one. `shards`: their folders, in any order. Returns how many runs there are.
///
/// Throws text::Error, and writes nothing: no_such_input for a folder in which no shard was finished; bad_configuration
/// for shards of different campaigns (naming what differs), one that is there twice or missing, by its number; bad_data
/// for runs that are damaged, or not those of the shard.
std::uint64_t merge(std::span<const std::filesystem::path> shards, const std::filesystem::path& out);

}  // namespace fantail::campaign
