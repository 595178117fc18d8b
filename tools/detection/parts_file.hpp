// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "campaign/stored_parts.hpp"
#include "detection/campaign.hpp"

namespace fantail::detection {

/// The finished chunks of a campaign, a sealed line of JSON each behind a first one that says whose they are. A line
/// that was cut or changed, or that another campaign has sealed, is left out, and its chunk is played again. Two
/// processes in one folder do each other's work twice and no harm: a chunk has one content.
class PartsFile {
 public:
  static constexpr const char* name = "parts.jsonl";

  /// Throws as play() does.
  PartsFile(const std::filesystem::path& folder, const Campaign& campaign, const std::string& program);

  /// Null when this chunk is not there, or with another number of events.
  [[nodiscard]] const Tally* find(Kind kind, std::uint64_t chunk, std::uint64_t events) const;
  /// From any thread. Throws text::OutputError.
  void store(Kind kind, std::uint64_t chunk, std::uint64_t events, const Tally& tally);

  /// Lines that were left out.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  struct Part {
    std::uint64_t events;
    Tally tally;
  };
  using Name = std::pair<Kind, std::uint64_t>;

  /// False when there is nothing that could be read.
  [[nodiscard]] bool read(std::size_t rules);
  void begin_anew() const;
  [[nodiscard]] std::string line_of(const Name& chunk, std::uint64_t events, const Tally& tally) const;

  std::filesystem::path folder_;
  std::filesystem::path file_;
  campaign::Identity identity_;
  std::map<Name, Part> parts_;
  std::uint64_t damaged_ = 0;
  std::ofstream out_;
  std::mutex mutex_;
};

}  // namespace fantail::detection
