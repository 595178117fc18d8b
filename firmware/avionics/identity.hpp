// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace fantail::avionics {

/// What the header of a flight's record says of where it comes from. The texts outlive the avionics; of each, 32
/// characters are recorded.
struct Identity {
  std::string_view firmware_version{};
  std::string_view git_hash{};
  std::string_view vehicle{};
  std::string_view sensors{};
};

/// Of the sources that this program was built from: 12 digits, and "-dirty" when they had been changed since, or
/// "-archive" when they are from an archive of that commit, where nobody knows; "unknown" outside of both.
[[nodiscard]] std::string_view git_hash();

/// As the project has it.
[[nodiscard]] std::string_view firmware_version();

}  // namespace fantail::avionics
