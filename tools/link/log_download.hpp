// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>

#include "link/log_part.hpp"
#include "link/log_reader.hpp"

namespace fantail::link {

/// A stretch of the record, from `offset` on.
struct LogStretch {
  std::uint32_t offset = 0;
  std::uint32_t size = 0;
};

/// Fills the part until it holds the stretch, and returns the bytes that were there already. It goes on with those when
/// their first and last 1792 bytes are still what the avionics has; otherwise they are of another record, and it starts
/// anew. `progress` is told the bytes done; it may throw to give up, and so may the place where the bench waits: then
/// the part stays.
std::uint32_t download(LogReader& reader, const LogStretch& stretch, LogPart& part,
                       const std::function<void(std::uint32_t)>& progress);

}  // namespace fantail::link
