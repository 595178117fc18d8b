// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace fantail::airframe::openrocket {

/// More than this no design is; a zip bomb is.
inline constexpr std::size_t most_bytes = std::size_t{64} << 20U;

/// The XML of an OpenRocket file, which is a zip archive with the entry rocket.ork, XML packed with gzip, or plain XML.
/// Throws text::Error: no_such_input; bad_data for an archive that is encrypted, broken, without a design, or whose
/// design has more than most_bytes unpacked.
[[nodiscard]] std::string document_text(const std::filesystem::path& file);

}  // namespace fantail::airframe::openrocket
