// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "hal/entropy.hpp"

namespace fantail::hal::on_linux {

/// The kernel's.
class Entropy final : public hal::Entropy {
 public:
  std::uint32_t draw() override { return device_(); }

 private:
  std::random_device device_;
};

}  // namespace fantail::hal::on_linux
