// SPDX-License-Identifier: MIT
#include "address_space.hpp"

#include "hal/stm32f4/registers/register.hpp"

namespace fantail::board {

void AddressSpace::add(std::uint32_t address, std::uint32_t size, void* block) {
  ranges_.push_back({address, size, static_cast<volatile std::uint32_t*>(block)});
}

volatile std::uint32_t* AddressSpace::find(std::uint32_t address) const {
  for (const Range& range : ranges_) {
    if (address - range.address < range.size) {
      return range.block + (address - range.address) / 4;
    }
  }
  return nullptr;
}

std::uint32_t AddressSpace::load(std::uint32_t address) const {
  before(address);
  return hal::stm32f4::registers::load(*find(address));
}

void AddressSpace::store(std::uint32_t address, std::uint32_t value) const {
  before(address);
  hal::stm32f4::registers::store(*find(address), value);
  after_write(address);
}

}  // namespace fantail::board
