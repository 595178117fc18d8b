// SPDX-License-Identifier: MIT
#include "hal/stm32f4/memory_protection.hpp"

#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

/// Of Armv7-M B3.5, as far as one looks at single addresses: the region with the highest number counts.
class FakeMpu {
 public:
  registers::Mpu mpu{};

  explicit FakeMpu(test::RegisterWorld& world) {
    world.on_write(mpu.rnr, [this](std::uint32_t value) { number_ = value; });
    world.on_write(mpu.rbar, [this](std::uint32_t value) { base_[number_] = value & ~31U; });
    world.on_write(mpu.rasr, [this](std::uint32_t value) { attributes_[number_] = value; });
    world.on_write(mpu.ctrl, [this](std::uint32_t value) { control_ = value; });
  }

  /// What RASR says of this address; empty: the processor's own map.
  [[nodiscard]] std::optional<std::uint32_t> at(std::uint32_t address) const {
    std::optional<std::uint32_t> found;
    for (const auto& [number, attributes] : attributes_) {
      const std::uint64_t size = 1ULL << ((attributes >> 1U & 31U) + 1);
      const std::uint64_t base = base_.at(number);
      EXPECT_EQ(base % size, 0U) << "a region begins at a multiple of its size";
      if ((attributes & 1U) != 0 && address >= base && address < base + size) {
        found = attributes;
      }
    }
    return found;
  }
  [[nodiscard]] std::uint32_t control() const { return control_; }

 private:
  std::uint32_t number_ = 0;
  std::uint32_t control_ = 0;
  std::map<std::uint32_t, std::uint32_t> base_{};
  std::map<std::uint32_t, std::uint32_t> attributes_{};
};

struct ProtectMemory : testing::Test {
  test::RegisterWorld world{};
  FakeMpu fake{world};
  ProtectMemory() { protect_memory(fake.mpu); }
};

std::uint32_t access(std::uint32_t attributes) { return attributes >> 24U & 7U; }

TEST_F(ProtectMemory, NothingCanBeReadOrWrittenBelowTheFlash) {
  for (const std::uint32_t address : {0U, 4U, 0x07FFFFFFU}) {
    ASSERT_TRUE(fake.at(address).has_value());
    EXPECT_EQ(access(*fake.at(address)), 0U);
  }
}

TEST_F(ProtectMemory, AStackThatOverflowsMeetsMemoryThatNobodyMayUse) {
  for (const std::uint32_t address : {0x1FFFE000U, 0x1FFFFFFCU, 0x1FFFFFFFU}) {
    ASSERT_TRUE(fake.at(address).has_value());
    EXPECT_EQ(access(*fake.at(address)), 0U);
  }
}

TEST_F(ProtectMemory, TheBackupMemoryIsOrdinaryMemoryThatNothingIsRunFrom) {
  for (const std::uint32_t address : {0x40024000U, 0x40024FFFU}) {
    ASSERT_TRUE(fake.at(address).has_value());
    EXPECT_EQ(access(*fake.at(address)), 3U);
    EXPECT_EQ(*fake.at(address) >> 16U & 0x3BU, 0x08U) << "TEX 001, C 0, B 0: normal memory, not cached";
    EXPECT_EQ(*fake.at(address) >> 28U & 1U, 1U);
  }
}

TEST_F(ProtectMemory, EverythingElseIsAsWithoutIt) {
  for (const std::uint32_t address :
       {0x08000000U, 0x1FFF7A10U, 0x1FFFC000U, 0x20000000U, 0x40023FFFU, 0x40025000U, 0xE000E010U}) {
    EXPECT_FALSE(fake.at(address).has_value()) << std::hex << address;
  }
  EXPECT_EQ(fake.control(), 5U) << "on, with the processor's own map behind it, and off in a hard fault";
}

}  // namespace
}  // namespace fantail::hal::stm32f4
