// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "detection/campaign.hpp"

namespace fantail::detection {

/// The finished chunks of a campaign, a line of JSON each behind a first one that says whose they are. A line that was
/// cut is left out and played again. Two processes in one folder do each other's work twice and no harm: a chunk has
/// one content.
class PartsFile {
 public:
  static constexpr const char* name = "parts.jsonl";

  /// Throws as play() does.
  PartsFile(const std::filesystem::path& folder, const Campaign& campaign, const std::string& version);

  /// Null when this chunk is not there, or with another number of events.
  [[nodiscard]] const Tally* find(Kind kind, std::uint64_t chunk, std::uint64_t events) const;
  /// From any thread. Throws text::OutputError.
  void store(Kind kind, std::uint64_t chunk, std::uint64_t events, const Tally& tally);

 private:
  struct Part {
    std::uint64_t events;
    Tally tally;
  };
  void read(const std::string& identity, std::size_t rules);

  std::filesystem::path file_;
  std::map<std::pair<Kind, std::uint64_t>, Part> parts_;
  std::ofstream out_;
  std::mutex mutex_;
};

}  // namespace fantail::detection
