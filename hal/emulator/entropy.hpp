// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hal/entropy.hpp"

namespace fantail::hal::emulator {

/// The world's: one number comes with every tick.
class Entropy final : public hal::Entropy {
 public:
  void set(std::uint32_t number) { number_ = number; }
  std::uint32_t draw() override { return number_; }

 private:
  std::uint32_t number_ = 0;
};

}  // namespace fantail::hal::emulator
