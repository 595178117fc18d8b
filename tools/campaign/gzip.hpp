// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace fantail::campaign {

/// One member of a gzip file (RFC 1952), without name and time: the same text gives the same bytes. Members behind each
/// other are a gzip file of all their texts.
[[nodiscard]] std::string gzip(const std::string& text);

/// The text of all members. Empty for what is no gzip file, is damaged, or ends too early.
[[nodiscard]] std::optional<std::string> gunzip(const std::string& bytes);

}  // namespace fantail::campaign
