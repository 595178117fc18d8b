// SPDX-License-Identifier: MIT
#include "hal/stm32f4/memory_protection.hpp"

#include <array>
#include <cstdint>

#include "hal/stm32f4/registers/processor.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

struct Region {
  std::uint32_t begin;
  std::uint32_t size_log2;
  std::uint32_t attributes;
};

constexpr std::array regions{
    Region{0x00000000, 27, mpu_rasr_never_execute},  // up to the flash at 0x08000000
    Region{0x1FFFE000, 13, mpu_rasr_never_execute},  // up to the stack, which begins with the RAM at 0x20000000
    Region{0x40024000, 12,
           mpu_rasr_read_write | mpu_rasr_normal_uncached | mpu_rasr_shareable | mpu_rasr_never_execute}};

}  // namespace

void protect_memory(Mpu& mpu) {
  for (std::uint32_t i = 0; i < regions.size(); ++i) {
    mpu.rnr.write(i);
    mpu.rbar.write(regions[i].begin);
    mpu.rasr.write(regions[i].attributes | (regions[i].size_log2 - 1) << mpu_rasr_size_shift | mpu_rasr_enable);
  }
  mpu.ctrl.write(mpu_ctrl_privdefena | mpu_ctrl_enable);
  synchronize();
}

}  // namespace fantail::hal::stm32f4
