// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "campaign/runs_folder.hpp"

// What campaigns that store finished parts have in common.
namespace fantail::campaign {

/// Of one part of one campaign: 16 digits, other ones when the campaign, the part's name or a byte of it is another.
[[nodiscard]] std::string seal(const Identity& identity, std::string_view part, std::string_view content);

/// So much of a digest as tells two apart, where a person may have to read it.
[[nodiscard]] std::string short_digest(std::string_view content);

/// An identity's text and back. Throws json::Error for what is none.
[[nodiscard]] Identity parse_identity(std::string_view json);

/// Throws text::Error (bad_configuration) for a folder that holds another campaign: what to do, and then what differs.
void require_same(const std::filesystem::path& folder, const Identity& there, const Identity& here);

/// The file that says which kind of campaign a folder holds is `own`. Throws text::Error (bad_configuration) when that
/// of another kind is there: it has files of the same names.
void require_no_other_kind(const std::filesystem::path& folder, std::string_view own);

}  // namespace fantail::campaign
