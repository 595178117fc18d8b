// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "campaign/flown_run.hpp"
#include "runs/runner.hpp"

namespace fantail::campaign {

using runs::Stretch;

/// Runs that are flown and stored together; which run is in which part depends on nothing but its number.
inline constexpr std::uint64_t runs_of_a_part = 64;

/// What a finished campaign's runs are called.
inline constexpr const char* runs_name = "runs.csv.gz";

/// The rows of so many runs do not have more, packed or not.
[[nodiscard]] std::size_t most_bytes(const Stretch& runs);

/// Packed rows, as they are stored in a part and follow each other in runs.csv.gz behind its header.
[[nodiscard]] std::string packed_rows(std::span<const FlownRun> runs);
/// Empty when they are not those of these runs and seeds.
[[nodiscard]] std::optional<std::vector<FlownRun>> unpacked_rows(const std::string& packed, const Stretch& stretch,
                                                                 std::uint64_t master_seed,
                                                                 const std::vector<Spread>& spreads);

struct Finished {
  std::optional<std::vector<FlownRun>> runs{};  ///< empty when there are none, or not these
  std::string remark{};                         ///< why not, or what could not be checked; a sentence without its end
};
/// The runs of a campaign that was finished in a folder. `may_be_fewer`: whole parts from the first on are enough.
[[nodiscard]] Finished finished_runs(const std::filesystem::path& folder, const Stretch& stretch,
                                     std::uint64_t master_seed, const std::vector<Spread>& spreads, bool may_be_fewer);

}  // namespace fantail::campaign
