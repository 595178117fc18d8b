// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::campaign {

/// What belongs to a run alone, of all 64 bits: another for every run, the same for the same number however many there
/// are. Nobody reads it.
[[nodiscard]] std::uint64_t key_of_run(std::uint64_t master_seed, std::uint64_t run);

/// The seed of a run, which is printed and typed again: the upper 53 bits of its key. A double holds all of them, and
/// programs that read JSON often have no other numbers.
[[nodiscard]] std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run);

/// The seed that a stored row has: that of a run, or all of its key in rows of earlier versions, which have no check.
[[nodiscard]] std::uint64_t seed_in_rows(bool are_checked, std::uint64_t master_seed, std::uint64_t run);

}  // namespace fantail::campaign
