// SPDX-License-Identifier: MIT
#include "protocol/plan_block.hpp"

#include "core/flight_plan_fields.hpp"
#include "plan_generator.hpp"
#include "properties.hpp"
#include "protocol/crc32c.hpp"

namespace fantail::protocol {
namespace {

using core::FlightPlan;
using core::PlanField;
using Block = std::vector<std::byte>;

constexpr std::size_t header = 12;

Block written(const FlightPlan& plan) {
  std::array<std::byte, largest_plan_block> out{};
  const std::size_t size = write_plan_block(plan, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

std::uint32_t word(const Block& block, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8U | static_cast<std::uint32_t>(block[at + i]);
  }
  return value;
}

void set_word(Block& block, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) {
    block[at + i] = static_cast<std::byte>(value >> (8U * i));
  }
}

// A block changed on purpose, by somebody who knows about the checksum.
Block sealed(Block block) {
  const std::size_t body = block.size() - 4;
  set_word(block, body, crc32c(std::span{block}.first(body)));
  return block;
}

PlanBlockFault fault_of(const Block& block) {
  const PlanBlockReading reading = read_plan_block(block);
  EXPECT_FALSE(reading.plan.has_value());
  return reading.fault;
}

// Where the first slot of a field stands in the block; a list's length stands before it.
std::size_t place_of(std::string_view key) {
  std::size_t at = header;
  for (const PlanField& field : core::flight_plan_fields()) {
    at += field.is_list() ? 4 : 0;
    if (field.key == key) {
      return at;
    }
    at += 4 * field.slots;
  }
  ADD_FAILURE() << key;
  return at;
}

bool same_bits(const FlightPlan& a, const FlightPlan& b) {
  return std::ranges::all_of(core::flight_plan_fields(), [&](const PlanField& field) {
    for (std::size_t slot = 0; slot < field.used_slots(a); ++slot) {
      if (field.get_bits(a, slot) != field.get_bits(b, slot)) {
        return false;
      }
    }
    return field.used_slots(a) == field.used_slots(b);
  });
}

RC_GTEST_PROP(PlanBlock, AnyPlanThatFliesComesBackToTheLastBit, ()) {
  const FlightPlan plan = core::arbitrary_plan();
  const Block block = written(plan);
  const PlanBlockReading reading = read_plan_block(block);
  RC_ASSERT(reading.plan.has_value());
  RC_ASSERT(same_bits(*reading.plan, plan));
  RC_ASSERT(written(*reading.plan) == block);
}

TEST(PlanBlock, BeginsAsItsHeaderSays) {
  const Block block = written(core::default_plan());
  EXPECT_EQ(std::memcmp(block.data(), "FTPL", 4), 0);
  EXPECT_EQ(word(block, 4) & 0xFFFFU, 3U);
  EXPECT_EQ(word(block, 4) >> 16U, block.size() - header - 4);
  EXPECT_EQ(word(block, 8), plan_schema_hash());
  EXPECT_EQ(word(block, block.size() - 4), crc32c(std::span{block}.first(block.size() - 4)));
  EXPECT_EQ(word(block, place_of("control_time_s")), 30'000'000U);
  EXPECT_EQ(word(block, place_of("proportional_gain")), 0x3F000000U);  // 0.5
  EXPECT_LE(block.size(), largest_plan_block);
}

// As docs/can.md says, whatever the field's default is.
TEST(PlanBlock, WordsOfAListThatAreNotUsedAreZero) {
  FlightPlan plan = core::default_plan();
  plan.gain_schedule.factors_count = 1;
  plan.gain_schedule.factors = {2.0F, 3.0F, 4.0F};
  const Block block = written(plan);
  EXPECT_EQ(word(block, place_of("factors")), 0x40000000U);
  EXPECT_EQ(word(block, place_of("factors") + 4), 0U);
  EXPECT_EQ(word(block, place_of("factors") + 20), 0U);
}

// The CRC-32C of anything with its own CRC-32C behind it is that of four zero bytes.
TEST(PlanBlock, IsKnownByTheChecksumAtItsEndBecauseThatOfAllItsBytesIsTheSameForEveryPlan) {
  FlightPlan other = core::default_plan();
  other.run.control_time += core::Microseconds{1};
  const Block one = written(core::default_plan());
  const Block two = written(other);
  EXPECT_EQ(crc32c(one), 0x48674BC7U);
  EXPECT_EQ(crc32c(two), 0x48674BC7U);
  EXPECT_EQ(plan_block_crc(one), word(one, one.size() - 4));
  EXPECT_EQ(plan_block_crc(two), word(two, two.size() - 4));
  EXPECT_NE(plan_block_crc(one), plan_block_crc(two));
  EXPECT_EQ(plan_block_crc({}), 0U);
  EXPECT_EQ(plan_block_crc(std::span{one}.first(3)), 0U);
}

TEST(PlanBlock, ThePlansChecksumIsThatOfItsBlock) {
  const Block block = written(core::default_plan());
  EXPECT_EQ(plan_crc(core::default_plan()), word(block, block.size() - 4));
  EXPECT_EQ(plan_block_checksum(block), word(block, block.size() - 4));
}

TEST(PlanBlock, SchemaHashIsFnv1aOverEveryNameUnitKindCapacityAndChoice) {
  std::string text;
  for (const PlanField& field : core::flight_plan_fields()) {
    for (const std::string_view part : {field.section, field.key, field.unit}) {
      text.append(part).push_back('\xFF');
    }
    text.push_back(static_cast<char>(field.kind));
    text.push_back(static_cast<char>(field.slots));
    for (const std::string_view choice : field.choices) {
      text.append(choice).push_back('\xFF');
    }
  }
  std::uint64_t expected = 0x811C9DC5U;
  for (const char c : text) {
    expected = ((expected ^ static_cast<unsigned char>(c)) * 0x01000193U) % 0x100000000U;
  }
  EXPECT_EQ(plan_schema_hash(), expected);
}

// What a board can say about a plan that it cannot read, that it is from newer firmware, it says by the version alone.
TEST(PlanBlock, ATableOfFieldsThatHasChangedTakesANewVersion) {
  struct Known {
    std::uint16_t version;
    std::uint32_t schema_hash;
  };
  constexpr Known newest{3, 0xC4492C99U};
  EXPECT_EQ(plan_block_version, newest.version);
  EXPECT_EQ(plan_schema_hash(), newest.schema_hash)
      << "raise plan_block_version, unless no release has had this one yet, and write the new hash here";
}

// As newer firmware would write it: another table of fields, another length.
TEST(PlanBlock, APlanFromANewerVersionIsCalledThatWhateverElseDiffers) {
  Block newer = written(core::default_plan());
  newer.resize(newer.size() + 40);
  const std::size_t payload = newer.size() - header - 4;
  set_word(newer, 4, static_cast<std::uint32_t>(payload << 16U) | (plan_block_version + 1U));
  set_word(newer, 8, ~plan_schema_hash());
  EXPECT_EQ(fault_of(sealed(newer)), PlanBlockFault::newer_version);
}

TEST(PlanBlock, EverySingleBitThatFlipsIsNoticed) {
  Block block = written(core::default_plan());
  for (std::size_t bit = 0; bit < 8 * block.size(); ++bit) {
    const std::byte mask = std::byte{1} << (bit % 8);
    block[bit / 8] ^= mask;
    ASSERT_FALSE(read_plan_block(block).plan.has_value()) << "bit " << bit;
    block[bit / 8] ^= mask;
  }
  EXPECT_TRUE(read_plan_block(block).plan.has_value());
}

TEST(PlanBlock, EveryBurstOfUpToFourWrongBytesIsNoticed) {
  const Block block = written(core::default_plan());
  for (std::size_t at = 0; at + 4 <= block.size(); ++at) {
    for (std::size_t length = 1; length <= 4; ++length) {
      Block spoilt = block;
      for (std::size_t i = 0; i < length; ++i) {
        spoilt[at + i] = ~spoilt[at + i];
      }
      ASSERT_FALSE(read_plan_block(spoilt).plan.has_value()) << at << " " << length;
    }
  }
}

TEST(PlanBlock, WhateverIsWrongIsCalledByItsName) {
  const Block block = written(core::default_plan());
  EXPECT_EQ(fault_of({}), PlanBlockFault::too_short);
  EXPECT_EQ(fault_of(Block(15)), PlanBlockFault::too_short);
  EXPECT_EQ(fault_of(Block(1024, std::byte{0xFF})), PlanBlockFault::no_plan_block) << "erased flash";
  EXPECT_EQ(fault_of(Block(1024)), PlanBlockFault::no_plan_block);

  Block other = block;
  other[0] = std::byte{'X'};
  EXPECT_EQ(fault_of(sealed(other)), PlanBlockFault::no_plan_block);

  for (const unsigned version : {0U, 2U, 4U, 255U, 256U, 259U, 0xFFFFU}) {
    other = block;
    other[4] = static_cast<std::byte>(version);
    other[5] = static_cast<std::byte>(version >> 8U);
    EXPECT_EQ(fault_of(sealed(other)), version < 3 ? PlanBlockFault::older_version : PlanBlockFault::newer_version)
        << version;
  }

  other = block;
  other[8] ^= std::byte{1};
  EXPECT_EQ(fault_of(sealed(other)), PlanBlockFault::other_schema);

  other = block;
  other[block.size() - 5] ^= std::byte{1};
  EXPECT_EQ(fault_of(other), PlanBlockFault::wrong_checksum);
}

TEST(PlanBlock, AWrongLengthIsCalledThatBeforeItsChecksumIs) {
  const Block block = written(core::default_plan());
  EXPECT_EQ(fault_of({block.begin(), block.end() - 1}), PlanBlockFault::wrong_length);
  EXPECT_EQ(fault_of({block.begin(), block.begin() + 16}), PlanBlockFault::wrong_length);
  Block longer = block;
  longer.push_back(std::byte{0});
  EXPECT_EQ(fault_of(longer), PlanBlockFault::wrong_length);
  // And one whose header agrees with its size, but not with the table of fields.
  longer = block;
  longer.resize(block.size() + 4);
  longer[6] ^= std::byte{4};
  const std::size_t payload = longer.size() - header - 4;
  longer[6] = static_cast<std::byte>(payload);
  longer[7] = static_cast<std::byte>(payload >> 8U);
  EXPECT_EQ(fault_of(sealed(longer)), PlanBlockFault::wrong_length);
}

TEST(PlanBlock, AnIntactBlockWithAPlanThatMustNotFlyIsRefusedByField) {
  const Block block = written(core::default_plan());
  struct Case {
    std::string_view key;
    std::uint32_t bits;
  };
  for (const Case& bad : {Case{"canard_limit_deg", 0x42B40000U},   // 90 rad
                          Case{"proportional_gain", 0x7FC00000U},  // NaN
                          Case{"trim_deg", 0xFF800000U},           // -infinity
                          Case{"control_time_s", 0xFFFFFFFFU},     // 71 minutes
                          Case{"height_origin", 3U}, Case{"variation_seed", 16'777'216U}}) {
    Block other = block;
    set_word(other, place_of(bad.key), bad.bits);
    const PlanBlockReading reading = read_plan_block(sealed(other));
    EXPECT_FALSE(reading.plan.has_value()) << bad.key;
    EXPECT_EQ(reading.fault, PlanBlockFault::refused) << bad.key;
    ASSERT_TRUE(reading.plan_fault.has_value()) << bad.key;
    EXPECT_EQ(core::flight_plan_fields()[reading.plan_fault->field].key, bad.key);
  }
}

TEST(PlanBlock, BitsThatDoNotFitTheirFieldAreRefusedByField) {
  const Block block = written(core::default_plan());
  for (const std::string_view key : {"low_pass", "start", "direction"}) {
    for (const std::uint32_t bits : {2U, 256U, 0x80000000U}) {
      Block other = block;
      set_word(other, place_of(key), bits);
      const PlanBlockReading reading = read_plan_block(sealed(other));
      EXPECT_EQ(reading.fault, PlanBlockFault::refused) << key << " = " << bits;
      ASSERT_TRUE(reading.plan_fault.has_value()) << key << " = " << bits;
      EXPECT_EQ(core::flight_plan_fields()[reading.plan_fault->field].key, key);
    }
  }
  for (const std::uint32_t length : {9U, 256U, 0x01000002U, 0xFFFFFFFFU}) {
    Block other = block;
    set_word(other, place_of("step_times_s") - 4, length);
    const PlanBlockReading reading = read_plan_block(sealed(other));
    EXPECT_EQ(reading.fault, PlanBlockFault::refused) << length;
    ASSERT_TRUE(reading.plan_fault.has_value()) << length;
    EXPECT_EQ(core::flight_plan_fields()[reading.plan_fault->field].key, "step_times_s");
    EXPECT_EQ(reading.plan_fault->slot, 0U) << length;
    EXPECT_EQ(reading.plan_fault->rule, core::PlanRule::too_many_values) << length;
  }
}

RC_GTEST_PROP(PlanBlock, NoHeapOfBytesIsAPlan, (std::vector<std::uint8_t> noise)) {
  Block block(noise.size());
  std::ranges::transform(noise, block.begin(), [](std::uint8_t byte) { return std::byte{byte}; });
  RC_ASSERT(!read_plan_block(block).plan.has_value());
}

}  // namespace
}  // namespace fantail::protocol
