// SPDX-License-Identifier: MIT
#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "hal/linux/can_bus.hpp"
#include "linux/shell.hpp"

namespace fantail::test {
namespace {

using hal::CanFrame;
using hal::on_linux::CanBus;
using hal::on_linux::CanFilter;

constexpr CanFrame last{.id = 0x7FF, .length = 1, .data = {0xEE}};

class LinuxCanFilter : public ::testing::Test {
 protected:
  void SetUp() override { restore_virtual_buses(); }
};

/// What a bus hears of a mixture, up to the frame that everybody lets through.
std::vector<std::uint32_t> heard(CanBus& bus) {
  CanBus other{"vcan0"};
  for (const std::uint32_t id : {0x010U, 0x100U, 0x101U, 0x10FU, 0x120U}) {
    EXPECT_TRUE(other.send({.id = id, .length = 1}));
    EXPECT_TRUE(other.send({.id = id, .extended = true, .length = 1}));
  }
  EXPECT_TRUE(other.send(last));
  std::vector<std::uint32_t> ids;
  for (auto frame = next_frame(bus); frame && *frame != last; frame = next_frame(bus)) {
    ids.push_back(frame->id | (frame->extended ? 0x80000000U : 0U));
  }
  return ids;
}

TEST_F(LinuxCanFilter, WithoutOneAllElevenBitFramesPassAndNoOthers) {
  CanBus bus{"vcan0"};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x010, 0x100, 0x101, 0x10F, 0x120}));
}

TEST_F(LinuxCanFilter, OnlyWhatAgreesWithOneOfThemPasses) {
  const std::array filters{CanFilter{.id = 0x100, .mask = 0x7F0}, CanFilter{.id = 0x7FF, .mask = 0x7FF}};
  CanBus bus{"vcan0", filters};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x100, 0x101, 0x10F}));
}

TEST_F(LinuxCanFilter, ExtendedFramesPassWhenAskedFor) {
  const std::array filters{CanFilter{.id = 0x101, .mask = 0x1FFFFFFF, .extended = true},
                           CanFilter{.id = 0x7FF, .mask = 0x7FF}};
  CanBus bus{"vcan0", filters};
  EXPECT_EQ(heard(bus), (std::vector<std::uint32_t>{0x80000101}));
}

}  // namespace
}  // namespace fantail::test
