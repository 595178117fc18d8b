// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/stored_parts.hpp"
#include "faults/campaign.hpp"

namespace fantail::faults {

/// The runs of a campaign of faults in a folder, by parts, each with a seal over its campaign, its name and its
/// content. Two processes at work in one folder write the same bytes.
class PartsFolder {
 public:
  static constexpr const char* identity_name = "faults.json";

  /// Makes the folder, or goes on in it. Throws text::Error (bad_configuration) when it holds another campaign, naming
  /// what differs; text::OutputError when it cannot be written.
  PartsFolder(const std::filesystem::path& folder, campaign::Identity identity);

  /// Empty: not there, or damaged, or of another campaign or another part.
  [[nodiscard]] std::optional<std::vector<Run>> stored(const std::string& part) const;
  /// Throws text::OutputError.
  void store(const std::string& part, const std::vector<Run>& runs) const;

  /// How many were there and not taken.
  [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

 private:
  [[nodiscard]] std::optional<std::vector<Run>> read(const std::string& part, const std::string& content) const;

  std::filesystem::path parts_;
  campaign::Identity identity_;
  mutable std::atomic<std::uint64_t> damaged_{0};
};

}  // namespace fantail::faults
