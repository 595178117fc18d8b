// SPDX-License-Identifier: MIT
#include "bus_rig.hpp"
#include "properties.hpp"
#include "protocol/bus_catalogue.hpp"
#include "protocol/bus_codec.hpp"
#include "random_stream.hpp"

namespace fantail::protocol {
namespace {

std::vector<BusFrame> protected_frames() {
  BenchRequest request;
  request.angle = {core::Angle::from_degrees(1.0F), core::Angle::from_degrees(-20.0F), std::nullopt,
                   core::Angle::from_degrees(9.99F)};
  return {encode(request, 7, open_session),
          encode(BenchSession{.action = SessionAction::open, .session = 0xBEEF}, 15),
          encode(ArmRequest{.action = ArmAction::confirm, .nonce = 0x12345678}, 0),
          encode(PlanBegin{.size = 900, .block_crc = 0xE3069283}, 3),
          encode(LogRequest{.action = LogAction::erase, .tag = 9, .offset = 0x00FEDCBA, .size = 1792}, 6),
          encode(CommandReport{.angle = request.angle}, 1),
          encode(EncoderReport{.angle = request.angle}, 12)};
}

std::optional<Rejection> rejection_of(const BusFrame& frame) {
  const auto bench = decode_from_bench(frame, open_session);
  const auto avionics = decode_from_avionics(frame);
  EXPECT_FALSE(bench.message && avionics.message);
  if (bench.message || avionics.message) {
    return std::nullopt;
  }
  return bench.rejection == Rejection::unknown_id ? avionics.rejection : bench.rejection;
}

BusFrame flipped(BusFrame frame, unsigned bit) {
  frame.data[bit / 8U] = static_cast<std::uint8_t>(frame.data[bit / 8U] ^ (1U << (bit % 8U)));
  return frame;
}

TEST(BusCodecBadFrame, UpToThreeFlippedBitsOfAProtectedFrameAreAlwaysFound) {
  for (const BusFrame& frame : protected_frames()) {
    ASSERT_EQ(rejection_of(frame), std::nullopt);
    for (unsigned a = 0; a < 64; ++a) {
      ASSERT_EQ(rejection_of(flipped(frame, a)), Rejection::wrong_crc);
      for (unsigned b = a + 1; b < 64; ++b) {
        ASSERT_EQ(rejection_of(flipped(flipped(frame, a), b)), Rejection::wrong_crc);
        for (unsigned c = b + 1; c < 64; ++c) {
          ASSERT_EQ(rejection_of(flipped(flipped(flipped(frame, a), b), c)), Rejection::wrong_crc);
        }
      }
    }
  }
}

// In the order of the wire: the highest bit of a byte first.
TEST(BusCodecBadFrame, ABurstOfUpToEightBitsInAProtectedFrameIsAlwaysFound) {
  for (const BusFrame& frame : protected_frames()) {
    for (unsigned first = 0; first < 64; ++first) {
      for (unsigned pattern = 1; pattern < 256; pattern += 2) {
        BusFrame burst = frame;
        for (unsigned i = 0; i < 8 && first + i < 64; ++i) {
          if (((pattern >> i) & 1U) != 0U) {
            const unsigned place = first + i;
            burst = flipped(burst, place / 8U * 8U + (7U - place % 8U));
          }
        }
        ASSERT_EQ(rejection_of(burst), Rejection::wrong_crc);
      }
    }
  }
}

TEST(BusCodecBadFrame, AProtectedFrameUnderAnotherProtectedIdentifierIsRefused) {
  for (const BusFrame& frame : protected_frames()) {
    for (const BusFrame& other : protected_frames()) {
      if (other.id != frame.id) {
        BusFrame moved = frame;
        moved.id = other.id;
        EXPECT_EQ(rejection_of(moved), Rejection::wrong_crc);
      }
    }
  }
}

// By the number of the session itself where a frame has it, by the CRC-8 where it has not: of each pair that is told
// apart, no request is taken for one of the other session, and of the rest every one would be.
TEST(BusCodecBadFrame, ARequestForAnotherSessionIsFoundByItsChecksumUnlessTheTwoAreNotToldApart) {
  core::RandomStream random{20261123};
  BenchRequest request;
  request.angle.fill(core::Angle::from_degrees(-3.21F));
  unsigned alike = 0;
  for (unsigned other = 0; other <= 0xFFFF; ++other) {
    const auto session = static_cast<std::uint16_t>(random.whole(0, 0xFFFF));
    const BusFrame frame = encode(request, static_cast<std::uint8_t>(other % 16), static_cast<std::uint16_t>(other));
    const auto decoded = decode_from_bench(frame, session);
    ASSERT_EQ(!decoded.message, told_apart(static_cast<std::uint16_t>(other), session)) << other << " " << session;
    alike += decoded.message ? 1 : 0;
    ASSERT_TRUE(decode_from_bench(frame, static_cast<std::uint16_t>(other)).message);
    for (unsigned bit = 0; bit < 16; ++bit) {
      ASSERT_TRUE(told_apart(session, static_cast<std::uint16_t>(session ^ (1U << bit))));
    }
  }
  EXPECT_NEAR(alike, 256.0, 80.0);  // one of 256, five standard deviations
}

TEST(BusCodecBadFrame, WhileNoSessionIsOpenARequestIsStaleAndOfWrongLengthAllTheSame) {
  BusFrame frame = encode(BenchRequest{}, 0, 3);
  EXPECT_EQ(decode_from_bench(frame, std::nullopt).rejection, Rejection::stale);
  frame.length = 7;
  EXPECT_EQ(decode_from_bench(frame, std::nullopt).rejection, Rejection::wrong_length);
}

TEST(BusCodecBadFrame, EveryLengthButTheRightOneIsRefused) {
  for (const BusFrameKind& kind : bus_catalogue()) {
    for (unsigned length = 0; length < 256; ++length) {
      BusFrame frame = FrameBuilder{kind.id}.done();
      frame.length = static_cast<std::uint8_t>(length);
      EXPECT_EQ(rejection_of(frame), length == 8 ? std::nullopt : std::optional{Rejection::wrong_length});
    }
  }
}

TEST(BusCodecBadFrame, EveryIdentifierIsKnownToAtMostOneSide) {
  for (unsigned id = 0; id <= 0xFFFF; ++id) {
    const BusFrame frame = FrameBuilder{static_cast<std::uint16_t>(id)}.done();
    const BusFrameKind* kind = find_bus_frame(frame.id);
    const auto bench = decode_from_bench(frame, open_session);
    const auto avionics = decode_from_avionics(frame);
    ASSERT_EQ(bench.message.has_value(), kind != nullptr && kind->sender == BusNode::bench) << id;
    ASSERT_EQ(avionics.message.has_value(), kind != nullptr && kind->sender == BusNode::avionics) << id;
    if (!bench.message) {
      ASSERT_EQ(bench.rejection, Rejection::unknown_id);
    }
    if (!avionics.message) {
      ASSERT_EQ(avionics.rejection, Rejection::unknown_id);
    }
  }
}

TEST(BusCodecBadFrame, ACounterComesWithExactlyTheMessagesThatHaveOne) {
  for (const BusFrameKind& kind : bus_catalogue()) {
    for (unsigned counter = 0; counter < 16; ++counter) {
      FrameBuilder builder{kind.id};
      if (kind.has_counter) {
        builder.put(52, 4, counter);
      }
      const BusFrame frame = builder.done();
      const auto found = kind.sender == BusNode::bench ? decode_from_bench(frame, open_session).counter
                                                       : decode_from_avionics(frame).counter;
      EXPECT_EQ(found, kind.has_counter ? std::optional{counter} : std::nullopt);
    }
  }
}

// What is accepted from the bench has one meaning and one form: nothing of it was ignored.
RC_GTEST_PROP(BusCodecBadFrame, ARandomFrameFromTheBenchIsRefusedOrComesBackBitForBit, (std::uint32_t seed)) {
  core::RandomStream random{seed};
  constexpr std::uint16_t ids[] = {0x010, 0x020, 0x030, 0x040, 0x041, 0x050};
  for (int i = 0; i < 2000; ++i) {
    FrameBuilder builder{ids[random.whole(0, 5)]};
    const bool sparse = random.chance(0.5);
    for (unsigned bit = 0; bit < 64; ++bit) {
      builder.put(bit, 1, random.chance(sparse ? 0.05 : 0.5) ? 1 : 0);
    }
    const BusFrame frame = random.chance(0.9) ? builder.done() : builder.plain();
    const auto back = there_and_back(frame);
    const BusFrame* returned = std::get_if<BusFrame>(&back);
    const bool unchanged = returned == nullptr || *returned == frame;
    RC_ASSERT(unchanged);
  }
}

}  // namespace
}  // namespace fantail::protocol
