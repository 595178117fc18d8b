// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/flown_run.hpp"

namespace fantail::campaign {

/// Runs that are flown and stored together; which run is in which chunk depends on nothing but its number.
inline constexpr std::uint64_t runs_of_a_chunk = 64;

/// What makes a campaign this one and no other, in the order of their names: "seed", "7".
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The runs of one campaign in a folder, while it is flown: a chunk is written under another name, brought to the disk
/// and then renamed, so that whoever begins again finds it whole or not at all. One process at a time.
class RunsFolder {
 public:
  /// Makes the folder, or goes on in it. Throws text::Error (bad_configuration) when it holds another campaign, naming
  /// what differs, or when another process is at work in it; text::OutputError when it cannot be written.
  RunsFolder(std::filesystem::path folder, const Identity& identity, std::vector<Spread> spreads);
  ~RunsFolder();
  RunsFolder(const RunsFolder&) = delete;
  RunsFolder& operator=(const RunsFolder&) = delete;

  /// A chunk that has been stored; empty when it has not, or is damaged, or does not hold these runs and seeds.
  [[nodiscard]] std::optional<std::vector<FlownRun>> stored(std::uint64_t chunk, std::uint64_t first_run,
                                                            std::uint64_t count, std::uint64_t master_seed) const;
  /// Throws text::OutputError; the chunks before it stay.
  void store(std::uint64_t chunk, const std::vector<FlownRun>& runs) const;

  /// Puts the stored chunks from 0 to `chunks` - 1 behind a header into runs.csv.gz, and removes them.
  void finish(std::uint64_t chunks) const;

 private:
  [[nodiscard]] std::filesystem::path chunk_file(std::uint64_t chunk) const;

  std::filesystem::path folder_;
  std::vector<Spread> spreads_;
  int lock_;  ///< a file descriptor; the lock goes with the process, however that ends
};

}  // namespace fantail::campaign
