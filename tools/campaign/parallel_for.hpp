// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>

namespace fantail::campaign {

/// Calls `work` once for each index below `count`, on several threads at once (0: as many as the machine has, and never
/// more than four times that). `look` is called on the caller's thread, a few times a second and at the end, with how
/// many are done. What either throws ends the others after their present piece of work and comes out of here.
void parallel_for(std::size_t count, unsigned threads, const std::function<void(std::size_t index)>& work,
                  const std::function<void(std::size_t done)>& look);

}  // namespace fantail::campaign
