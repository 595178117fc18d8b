// SPDX-License-Identifier: MIT
#include "campaign/seed_of_run.hpp"

#include "sim/random.hpp"

namespace fantail::campaign {

std::uint64_t key_of_run(std::uint64_t master_seed, std::uint64_t run) { return sim::Random{master_seed, run}.bits(); }

std::uint64_t seed_of_run(std::uint64_t master_seed, std::uint64_t run) { return key_of_run(master_seed, run) >> 11U; }

std::uint64_t seed_in_rows(bool are_checked, std::uint64_t master_seed, std::uint64_t run) {
  return are_checked ? seed_of_run(master_seed, run) : key_of_run(master_seed, run);
}

}  // namespace fantail::campaign
