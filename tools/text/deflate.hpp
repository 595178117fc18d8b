// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace fantail::text {

/// One member of a gzip file (RFC 1952), without name and time: the same text gives the same bytes. Members behind each
/// other are a gzip file of all their texts.
[[nodiscard]] std::string gzip(const std::string& text);

/// The text of all members. Empty for what is no gzip file, is damaged, ends too early, or has more than `most` bytes
/// unpacked: a bomb has.
[[nodiscard]] std::optional<std::string> gunzip(std::string_view bytes, std::size_t most = std::size_t{512} << 20U);

/// The same text in zlib's own format (RFC 1950).
[[nodiscard]] std::string zlib_packed(const std::string& text);

}  // namespace fantail::text
