// SPDX-License-Identifier: MIT
#include "avionics/memory_sum.hpp"
#include "avionics/memory_sum_words.hpp"

namespace fantail::avionics {

// Called, not written in. Eight words are one load, which the compiler does not make of eight, and each is turned and
// added by one instruction.
[[gnu::noinline]] std::uint32_t memory_sum(std::span<const std::byte> memory) {
  std::uint32_t sum = 0;
  const std::byte* at = memory.data();
  const std::byte* const end = at + memory.size() / 4 * 4;
  constexpr std::ptrdiff_t at_once = 32;
  while (end - at >= at_once) {
    asm("ldmia %[at]!, {r4, r5, r6, r8, r9, r10, r12, lr}\n\t"
        "eor %[sum], r4, %[sum], ror #31\n\t"
        "eor %[sum], r5, %[sum], ror #31\n\t"
        "eor %[sum], r6, %[sum], ror #31\n\t"
        "eor %[sum], r8, %[sum], ror #31\n\t"
        "eor %[sum], r9, %[sum], ror #31\n\t"
        "eor %[sum], r10, %[sum], ror #31\n\t"
        "eor %[sum], r12, %[sum], ror #31\n\t"
        "eor %[sum], lr, %[sum], ror #31"
        : [at] "+r"(at), [sum] "+r"(sum)
        :
        : "r4", "r5", "r6", "r8", "r9", "r10", "r12", "lr", "memory");
  }
  return add_words(sum, at, end);
}

}  // namespace fantail::avionics
