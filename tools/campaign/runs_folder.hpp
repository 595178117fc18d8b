// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/flown_run.hpp"
#include "text/input_file.hpp"

namespace fantail::campaign {

/// Runs that are flown and stored together; which run is in which chunk depends on nothing but its number.
inline constexpr std::uint64_t runs_of_a_chunk = 64;

/// Runs that follow each other.
struct Stretch {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// What makes a campaign this one and no other, in the order of their names: "seed", "7". "file" does not: the same
/// scenario may lie elsewhere on another machine.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// All names that an identity may have.
inline constexpr std::array<std::string_view, 13> identity_names{"version", "file",    "seed",     "runs", "sampling",
                                                                 "stop",    "changes", "scenario", "plan", "vehicle",
                                                                 "motor",   "tables",  "shard"};

/// The first that `one` says otherwise than `other`, with where they are: "seed is 7 there and 8 here". Empty when they
/// are of the same campaign.
[[nodiscard]] std::string difference(const Identity& one, std::string_view where, const Identity& other,
                                     std::string_view where_other);

/// Throws text::Error (bad_configuration) when `folder` holds another campaign, naming what differs.
void require_no_other(const std::filesystem::path& folder, const Identity& identity);

[[nodiscard]] std::string identity_json(const Identity& identity);
/// Of a folder. Throws text::Error: no_such_input without one, bad_data for one that cannot be read.
[[nodiscard]] Identity read_identity(const std::filesystem::path& folder);
/// Empty where there is no file. Throws as text::read_input() does for one with more than `most` bytes.
[[nodiscard]] std::string file_content(const std::filesystem::path& file,
                                       std::size_t most = text::most_bytes(text::InputKind::data));
/// The rows of so many runs do not have more, packed or not.
[[nodiscard]] std::size_t most_bytes(const Stretch& runs);

/// Of several that begin in one folder at once the only one, while it lives: else each would find the folder empty.
/// Makes the folder. Throws text::OutputError.
class Beginning {
 public:
  explicit Beginning(const std::filesystem::path& folder);
  ~Beginning();
  Beginning(const Beginning&) = delete;
  Beginning& operator=(const Beginning&) = delete;

 private:
  int lock_ = -1;
};

/// The runs of one campaign in a folder, while it is flown: a chunk is written under another name, brought to the disk
/// and then renamed, so that whoever begins again finds it whole or not at all. One process at a time.
class RunsFolder {
 public:
  /// What a finished campaign's file and chunks are called.
  static constexpr const char* runs_name = "runs.csv.gz";
  static constexpr const char* identity_name = "campaign.json";

  /// Makes the folder, or goes on in it. Throws text::Error (bad_configuration) when it holds another campaign, naming
  /// what differs, or when another process is at work in it; text::OutputError when it cannot be written.
  RunsFolder(std::filesystem::path folder, const Identity& identity, std::vector<Spread> spreads);
  ~RunsFolder();
  RunsFolder(const RunsFolder&) = delete;
  RunsFolder& operator=(const RunsFolder&) = delete;

  struct Finished {
    std::optional<std::vector<FlownRun>> runs{};  ///< empty when there are none, or not these
    std::string remark{};                         ///< why not, or what could not be checked; a sentence without its end
  };
  /// The runs of a campaign that was finished here. `may_be_fewer`: whole chunks from the first on are enough.
  [[nodiscard]] Finished finished(const Stretch& stretch, std::uint64_t master_seed, bool may_be_fewer) const;
  /// A chunk that has been stored; empty when it has not, or is damaged or edited, or does not hold these runs and
  /// seeds.
  [[nodiscard]] std::optional<std::vector<FlownRun>> stored(std::uint64_t chunk, const Stretch& stretch,
                                                            std::uint64_t master_seed) const;
  /// Throws text::OutputError; the chunks before it stay.
  void store(std::uint64_t chunk, const std::vector<FlownRun>& runs) const;

  /// Puts these stored chunks behind a header into runs.csv.gz, and removes all chunks.
  void finish(std::uint64_t first_chunk, std::uint64_t end_chunk) const;

  void remove_chunks() const;

 private:
  [[nodiscard]] std::optional<std::vector<FlownRun>> whole(const std::string& rows, const std::string& name,
                                                           const Stretch& stretch, std::uint64_t master_seed,
                                                           bool may_be_fewer, Rows kind) const;
  [[nodiscard]] std::filesystem::path chunk_file(std::uint64_t chunk) const;

  std::filesystem::path folder_;
  std::vector<Spread> spreads_;
  int lock_;  ///< a file descriptor; the lock goes with the process, however that ends
};

}  // namespace fantail::campaign
