// SPDX-License-Identifier: MIT
#include "boards/emulator/usart_channel.hpp"

#include <optional>

#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::boards::emulator {

std::size_t UsartChannel::read(std::span<std::byte> out) {
  namespace processor = hal::stm32f4::registers;
  std::size_t count = 0;
  for (;;) {
    // Masked, so that a byte that comes after the look is not slept over.
    processor::mask_interrupts();
    while (count < out.size()) {
      const std::optional<std::byte> byte = port_.take();
      if (!byte) {
        break;
      }
      out[count] = *byte;
      count += 1;
    }
    if (count == 0) {
      processor::wait_for_interrupt();
    }
    processor::unmask_interrupts();
    if (count != 0) {
      return count;
    }
  }
}

}  // namespace fantail::boards::emulator
