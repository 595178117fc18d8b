// SPDX-License-Identifier: MIT
#include "hal/stm32f4/registers/register.hpp"

namespace fantail::hal::stm32f4::registers {

std::uint32_t load(const volatile std::uint32_t& place) { return place; }

void store(volatile std::uint32_t& place, std::uint32_t value) { place = value; }

}  // namespace fantail::hal::stm32f4::registers
