// SPDX-License-Identifier: MIT
#include "register_world.hpp"

namespace fantail::hal::stm32f4 {
namespace {

test::RegisterWorld* world = nullptr;

}  // namespace

namespace test {

RegisterWorld::RegisterWorld() { world = this; }
RegisterWorld::~RegisterWorld() { world = nullptr; }

// A Register is nothing but its bits.
std::uint32_t RegisterWorld::peek(const registers::Register& place) {
  return *reinterpret_cast<const volatile std::uint32_t*>(&place);
}
void RegisterWorld::poke(registers::Register& place, std::uint32_t value) {
  *reinterpret_cast<volatile std::uint32_t*>(&place) = value;
}

}  // namespace test

namespace registers {

std::uint32_t load(const volatile std::uint32_t& place) {
  if (world != nullptr) {
    world->accesses_ += 1;
    if (const auto device = world->reads_.find(&place); device != world->reads_.end()) {
      return device->second();
    }
  }
  return place;
}

void store(volatile std::uint32_t& place, std::uint32_t value) {
  if (world != nullptr) {
    world->accesses_ += 1;
    if (const auto device = world->writes_.find(&place); device != world->writes_.end()) {
      device->second(value);
      return;
    }
  }
  place = value;
}

}  // namespace registers
}  // namespace fantail::hal::stm32f4
