// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "avionics/identity.hpp"
#include "hil/emulator.hpp"
#include "hil/target.hpp"

namespace fantail::test {

/// An image that the ARM build made.
inline std::filesystem::path image(const std::string& name) { return std::filesystem::path{FANTAIL_IMAGES} / name; }

/// Why the images cannot be flown here, where that is no fault: they are not there, or were built from other sources,
/// so that at least the hash in the header of the flight log differs. Empty when they can.
inline std::string objection_to_images() {
  if (!std::filesystem::exists(image("fantail-emulator.elf"))) {
    return "the images have not been built: cmake --preset emulator && cmake --build --preset emulator";
  }
  try {
    const hil::Target target{
        std::make_unique<hil::Emulator>(hil::EmulatorOptions{.image = image("fantail-emulator.elf")})};
    if (target.identity().git_hash != avionics::git_hash()) {
      return "the images are those of " + target.identity().git_hash + " and this program is of " +
             std::string{avionics::git_hash()} + ": cmake --build --preset emulator";
    }
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace fantail::test
