// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/tick_record.hpp"

namespace fantail::protocol {

/// 32 bits that stand for every bit of every signal of a tick, those too that a log leaves out: a replay whose digest
/// is that of the log has made the same record. Changes whenever one signal changes; two records that differ in several
/// share one with a chance of 2^-32.
[[nodiscard]] std::uint32_t tick_digest(const core::TickRecord& record);

}  // namespace fantail::protocol
