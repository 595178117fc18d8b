// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/runs_folder.hpp"
#include "faults/campaign.hpp"

namespace fantail::faults {

/// The runs of a campaign of faults in a folder, by parts. Two processes at work in one folder write the same bytes.
class PartsFolder {
 public:
  static constexpr const char* identity_name = "faults.json";

  /// Makes the folder, or goes on in it. Throws text::Error (bad_configuration) when it holds another campaign, naming
  /// what differs; text::OutputError when it cannot be written.
  PartsFolder(std::filesystem::path folder, const campaign::Identity& identity);

  /// Empty: not there, or damaged.
  [[nodiscard]] std::optional<std::vector<Run>> stored(const std::string& part) const;
  /// Throws text::OutputError.
  void store(const std::string& part, const std::vector<Run>& runs) const;

 private:
  std::filesystem::path parts_;
};

}  // namespace fantail::faults
