// SPDX-License-Identifier: MIT
#include "campaign/seed_of_run.hpp"

#include "sim/random.hpp"

namespace fantail::campaign {

std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run) { return sim::Random{master_seed, run}.bits(); }

}  // namespace fantail::campaign
