// SPDX-License-Identifier: MIT
// Compiled for every x86-64, as nothing else is: an older processor would end the program with an illegal instruction.
#include <string_view>

#include <unistd.h>

#include "fantail/run.hpp"

namespace {

constexpr std::string_view refusal =
    "fantail: this processor lacks instructions that Fantail is compiled for: x86-64-v2, with SSE 4.2 and POPCNT, "
    "as PCs have had since about 2009\n";

/// Before every other constructor of this program, because any other code may have such instructions.
__attribute__((constructor(101))) void refuse_older_processor() {
  __builtin_cpu_init();  // otherwise a later constructor does it
  if (__builtin_cpu_supports("x86-64-v2") == 0) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, refusal.data(), refusal.size());
    _exit(static_cast<int>(fantail::tool::ExitCode::not_installed));
  }
}

}  // namespace
