// SPDX-License-Identifier: MIT
// Each kind of value that a law may remember: where its bytes lie, and which values are refused.
#include <bit>

#include "core/flight_phase.hpp"
#include "protocol/state_block.hpp"
#include "test.hpp"

namespace fantail::protocol {
namespace {

constexpr std::byte unwritten{0x5A};

/// Stands for a law that remembers one value of each kind.
struct OneOfEach {
  core::Vector3 vector{.x = 1.0F, .y = -2.0F, .z = 0.5F};
  core::Angle angle = core::Angle::from_radians(-1.0F);
  std::uint32_t count = 0x01020304;
  core::Microseconds time{0x0102030405060708};
  bool flag = true;
  std::optional<float> there{2.0F};
  std::optional<float> not_there{};
  core::Phase phase = core::Phase::finished;
  float number = 4.0F;

  template <typename Visitor>
  void visit_state(Visitor& visit) {
    visit(vector, angle, count, time, flag, there, not_there);
    visit.below(core::phases, phase);
    visit.on_pad(number);
  }
};

constexpr std::array<std::uint8_t, 44> bytes_of_each{
    0x00, 0x00, 0x80, 0x3F, 0x00, 0x00, 0x00, 0xC0, 0x00, 0x00, 0x00, 0x3F,  // vector
    0x00, 0x00, 0x80, 0xBF, 0x04, 0x03, 0x02, 0x01,                          // angle, count
    0x08, 0x07, 0x06, 0x05, 0x04, 0x03, 0x02, 0x01,                          // time
    0x01, 0x01, 0x00, 0x00, 0x00, 0x40, 0x00, 0x00, 0x00, 0x00, 0x00, 0x04,  // flag, optionals, phase
    0x00, 0x00, 0x80, 0x40};                                                 // number

std::vector<std::byte> known_state() {
  std::vector<std::byte> bytes(bytes_of_each.size());
  std::ranges::transform(bytes_of_each, bytes.begin(), [](std::uint8_t byte) { return std::byte{byte}; });
  return bytes;
}

TEST(StateBlockValues, EachLiesThereAsTheDocumentationSaysAndNothingBehindItIsWritten) {
  for (const auto& [extent, size] :
       {std::pair{StateExtent::whole, std::size_t{44}}, std::pair{StateExtent::in_flight, std::size_t{40}}}) {
    OneOfEach law;
    std::array<std::byte, 60> room{};
    room.fill(unwritten);
    StateWriter writer{room, extent};
    law.visit_state(writer);
    EXPECT_EQ(writer.size(), size);
    for (std::size_t i = 0; i < room.size(); ++i) {
      EXPECT_EQ(room.at(i), i < size ? std::byte{bytes_of_each.at(i)} : unwritten) << i;
    }
  }
}

TEST(StateBlockValues, EachComesBack) {
  OneOfEach law{.vector = {},
                .angle = {},
                .count = 0,
                .time = {},
                .flag = false,
                .there = {},
                .not_there = 3.0F,
                .phase = core::Phase::safe,
                .number = 0.0F};
  const std::vector<std::byte> state = known_state();
  StateReader reader{state};
  law.visit_state(reader);
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(law.vector.x, 1.0F);
  EXPECT_EQ(law.vector.y, -2.0F);
  EXPECT_EQ(law.vector.z, 0.5F);
  EXPECT_EQ(law.angle, core::Angle::from_radians(-1.0F));
  EXPECT_EQ(law.count, 0x01020304U);
  EXPECT_EQ(law.time, core::Microseconds{0x0102030405060708});
  EXPECT_TRUE(law.flag);
  EXPECT_EQ(law.there, 2.0F);
  EXPECT_EQ(law.not_there, std::nullopt);
  EXPECT_EQ(law.phase, core::Phase::finished);
  EXPECT_EQ(law.number, 4.0F);
}

// However much room there is: a value finds room whole or is left out, and the vector is one value.
TEST(StateBlockValues, AValueIsWrittenWholeOrNotAtAll) {
  constexpr std::array<std::size_t, 12> ends{12, 16, 20, 28, 29, 30, 34, 35, 39, 40, 44, 45};
  for (std::size_t size = 0; size <= 44; ++size) {
    OneOfEach law;
    std::array<std::byte, 60> room{};
    room.fill(unwritten);
    StateWriter writer{std::span{room}.first(size)};
    law.visit_state(writer);
    EXPECT_EQ(writer.size(), 44U);
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      for (std::size_t i = begin; i < end && i < 44; ++i) {
        EXPECT_EQ(room.at(i), end <= size ? std::byte{bytes_of_each.at(i)} : unwritten) << i << " of " << size;
      }
      begin = end;
    }
  }
}

TEST(StateBlockValues, APartHasTheValuesThatBeginInItAndNoOther) {
  OneOfEach law;
  std::array<std::byte, 44> room{};
  room.fill(unwritten);
  StateWriter writer{room, StateExtent::whole, {.begin = 12, .size = 8}};
  law.visit_state(writer);
  for (std::size_t i = 0; i < room.size(); ++i) {
    EXPECT_EQ(room.at(i), i >= 12 && i < 20 ? std::byte{bytes_of_each.at(i)} : unwritten) << i;
  }
}

template <typename T>
bool takes(T value) {
  std::array<std::byte, sizeof(T)> bytes{};
  put<sizeof(T)>(bytes, 0, std::bit_cast<std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>(value));
  StateReader reader{bytes};
  if constexpr (std::is_floating_point_v<T>) {
    reader(value);
  } else {
    core::Microseconds time{value};
    reader(time);
  }
  return reader.ok();
}

// A number converts to an integer, and two times can be added or subtracted.
TEST(StateBlockValues, ANumberIsAtMostABillionAndATimeBelowTwoToThe62) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  for (const float sign : {1.0F, -1.0F}) {
    EXPECT_TRUE(takes(sign * 1e9F));
    EXPECT_FALSE(takes(sign * std::nextafterf(1e9F, infinity)));
    EXPECT_FALSE(takes(sign * infinity));
  }
  EXPECT_FALSE(takes(std::numeric_limits<float>::quiet_NaN()));
  for (const std::int64_t sign : {1, -1}) {
    EXPECT_TRUE(takes(sign * 4'611'686'018'427'387'903));
    EXPECT_FALSE(takes(sign * 4'611'686'018'427'387'904));
    EXPECT_FALSE(takes(sign * std::numeric_limits<std::int64_t>::max()));
  }
  EXPECT_FALSE(takes(std::numeric_limits<std::int64_t>::min()));
}

TEST(StateBlockValues, AnAngleIsAnyNumber) {
  const auto takes_angle = [](float radians) {
    std::array<std::byte, 4> bytes{};
    put<4>(bytes, 0, std::bit_cast<std::uint32_t>(radians));
    StateReader reader{bytes};
    core::Angle angle;
    reader(angle);
    return reader.ok() && angle == core::Angle::from_radians(radians);
  };
  constexpr float largest = std::numeric_limits<float>::max();
  EXPECT_TRUE(takes_angle(largest) && takes_angle(-largest) && takes_angle(0.1F));
  EXPECT_FALSE(takes_angle(std::numeric_limits<float>::infinity()));
  EXPECT_FALSE(takes_angle(std::numeric_limits<float>::quiet_NaN()));
}

// It must not be used then; but an index of it would still lie within its array.
TEST(StateBlockValues, WhatIsMissingOrBeyondItsEndIsRefusedAndReadAsZero) {
  for (std::size_t size = 0; size < 44; ++size) {
    OneOfEach law;
    std::vector<std::byte> state = known_state();
    StateReader reader{std::span{state}.first(size)};
    law.visit_state(reader);
    EXPECT_FALSE(reader.ok()) << size;
    EXPECT_EQ(law.number, 0.0F) << size;
    EXPECT_EQ(law.phase, size < 40 ? core::Phase::safe : core::Phase::finished) << size;
    EXPECT_EQ(law.flag, size > 28) << size;
    EXPECT_EQ(law.there.has_value(), size > 29) << size;
    EXPECT_EQ(law.time.count() == 0, size < 28) << size;
    EXPECT_EQ(law.angle.radians() == 0.0F, size < 16) << size;
  }
  std::vector<std::byte> state = known_state();
  state[39] = std::byte{core::phases};
  state[27] = std::byte{0x40};
  state[43] = std::byte{0x7F};  // the number is infinite
  OneOfEach law;
  StateReader reader{state};
  law.visit_state(reader);
  EXPECT_FALSE(reader.ok());
  EXPECT_EQ(law.phase, core::Phase::safe);
  EXPECT_EQ(law.time, core::Microseconds{0});
  EXPECT_EQ(law.number, 0.0F);
}

// A log's header has it, and a reader of another version must come to the same: FNV-1a over the numbers of the kinds.
TEST(StateBlockValues, ALayoutIsKnownByTheFnvHashOfTheKindsOfItsValues) {
  const auto fnv = [](std::initializer_list<std::uint32_t> kinds) {
    std::uint64_t hash = 0x811C9DC5;
    for (const std::uint32_t kind : kinds) {
      hash = (hash ^ kind) * 0x01000193 % 0x100000000;
    }
    return hash;
  };
  enum Kind : std::uint8_t { number = 1, angle = 2, count = 3, time = 4, flag = 5, below = 6, optional = 7 };
  OneOfEach law;
  StateLayout layout;
  law.visit_state(layout);
  EXPECT_EQ(layout.hash(), fnv({number, number, number, angle, count, time, flag, flag, number, optional, flag, number,
                                optional, below, core::phases, number}));
  EXPECT_EQ(StateLayout{}.hash(), fnv({}));
}

}  // namespace
}  // namespace fantail::protocol
