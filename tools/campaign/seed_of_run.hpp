// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace fantail::campaign {

/// The seed of a run: another for every run, the same for the same number however many there are.
[[nodiscard]] std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run);

}  // namespace fantail::campaign
