// SPDX-License-Identifier: MIT
#include "world_link/link.hpp"

#include "core/tick_record_fields.hpp"
#include "protocol/hil_codec.hpp"
#include "protocol/hil_frame.hpp"
#include "test.hpp"
#include "world_link/exchange.hpp"

namespace fantail::test {
namespace {

using protocol::HilFrameIn;
using protocol::HilFrameOut;
using protocol::HilReader;
using protocol::HilType;
using protocol::HilWriter;
using world_link::Link;

using Bytes = std::vector<std::byte>;

Bytes frame(HilType type, std::uint32_t sequence, std::size_t payload_size = 20) {
  HilFrameOut out;
  std::ranges::fill(out.payload().first(payload_size), std::byte{0x5A});
  const auto sealed = out.seal(type, sequence, payload_size);
  return {sealed.begin(), sealed.end()};
}

std::vector<std::uint32_t> sequences(HilFrameIn& in, const Bytes& bytes, std::size_t piece) {
  std::vector<std::uint32_t> found;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto room = in.room();
    const auto part = std::span{bytes}.subspan(at, std::min({piece, bytes.size() - at, room.size()}));
    std::ranges::copy(part, room.begin());
    in.arrived(part.size());
    at += part.size();
    while (const auto frame = in.next()) {
      found.push_back(frame->head.sequence);
    }
  }
  return found;
}

Bytes operator+(Bytes first, const Bytes& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(HilFrame, FramesAreFoundInPiecesOfEverySize) {
  const Bytes bytes = frame(HilType::tick, 7) + frame(HilType::tick, 8, 0) + frame(HilType::tick, 9, 600);
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
    HilFrameIn in;
    ASSERT_EQ(sequences(in, bytes, piece), (std::vector<std::uint32_t>{7, 8, 9})) << piece;
    EXPECT_EQ(in.damaged(), 0U);
  }
}

TEST(HilFrame, OneWrongBitAnywhereLosesThatFrameAndNoOther) {
  const Bytes before = frame(HilType::tick, 1);
  // What follows is long enough to end the wait for a frame whose length was made longer.
  const Bytes after = frame(HilType::tick, 3, protocol::largest_hil_payload) + frame(HilType::tick, 4);
  const std::size_t size = frame(HilType::tick, 2).size();
  for (std::size_t bit = 0; bit < 8 * size; ++bit) {
    Bytes damaged = frame(HilType::tick, 2);
    damaged[bit / 8] ^= std::byte{1} << (bit % 8);
    HilFrameIn in;
    ASSERT_EQ(sequences(in, before + damaged + after, 512), (std::vector<std::uint32_t>{1, 3, 4})) << bit;
    ASSERT_GE(in.damaged() + (bit < 8 ? 1 : 0), 1U) << bit;  // without its first byte it is no frame at all
  }
}

TEST(HilCodec, ARecordComesBackWithEveryBitAndAnotherLengthIsRefused) {
  core::TickRecord record;
  record.time = core::Microseconds{0x0123'4567'89AB};
  record.phase = core::Phase::controlling;
  record.motion.roll_rate_rad_s = -1.0e-38F;
  record.encoders[2] = core::Angle::from_radians(0.25F);
  record.canards[3].driven = true;
  record.saturated = true;
  std::array<std::byte, 512> bytes{};
  HilWriter writer{bytes};
  core::visit_signals(record, writer);
  ASSERT_TRUE(writer.ok());

  core::TickRecord copy;
  copy.encoders[0] = core::Angle::from_radians(1.0F);  // of an earlier tick
  HilReader reader{std::span{bytes}.first(writer.size())};
  core::visit_signals(copy, reader);
  EXPECT_TRUE(reader.ok());
  std::array<std::byte, 512> again{};
  HilWriter second{again};
  core::visit_signals(copy, second);
  EXPECT_EQ(bytes, again);
  EXPECT_EQ(copy.time, record.time);
  EXPECT_FALSE(copy.encoders[0]);
  EXPECT_EQ(copy.encoders[2], record.encoders[2]);

  HilReader shorter{std::span{bytes}.first(writer.size() - 1)};
  core::visit_signals(copy, shorter);
  EXPECT_FALSE(shorter.ok());
  HilReader longer{std::span{bytes}.first(writer.size() + 1)};
  core::visit_signals(copy, longer);
  EXPECT_FALSE(longer.ok());
}

TEST(HilCodec, WhatFindsNoRoomIsSaid) {
  std::array<std::byte, 3> bytes{};
  HilWriter writer{bytes};
  writer(std::uint16_t{1});
  EXPECT_TRUE(writer.ok());
  writer(std::uint16_t{1});
  EXPECT_FALSE(writer.ok());
}

/// The world's end of a channel, in this thread: what the link reads was put there before.
class Script final : public hal::emulator::Channel {
 public:
  void says(const Bytes& bytes) { questions_.push_back(bytes); }
  [[nodiscard]] std::size_t read(std::span<std::byte> out) override {
    EXPECT_FALSE(questions_.empty()) << "it would wait for ever";
    const Bytes bytes = questions_.front();
    questions_.pop_front();
    std::ranges::copy(bytes, out.begin());
    return bytes.size();
  }
  void write(std::span<const std::byte> bytes) override { answers.emplace_back(bytes.begin(), bytes.end()); }

  std::vector<Bytes> answers;

 private:
  std::deque<Bytes> questions_;
};

TEST(HilLink, AQuestionAskedTwiceIsHeardOnceAndAnsweredTwiceWithTheSameBytes) {
  Script world;
  Link link{world};
  world.says(frame(HilType::hello, 1));
  EXPECT_EQ(link.receive().head.sequence, 1U);
  link.answer(HilType::ready, 5);
  world.says(frame(HilType::hello, 1));
  world.says(frame(HilType::tick, 2));
  EXPECT_EQ(link.receive().head.sequence, 2U);
  ASSERT_EQ(world.answers.size(), 2U);
  EXPECT_EQ(world.answers[0], world.answers[1]);
}

TEST(HilLink, WhoWasNotGreetedAndWhatIsOutOfSequenceIsNotHeard) {
  Script world;
  Link link{world};
  world.says(frame(HilType::tick, 5));
  world.says(frame(HilType::hello, 9));
  EXPECT_EQ(link.receive().head.sequence, 9U);
  link.answer(HilType::ready, 0);
  world.says(frame(HilType::tick, 11));
  world.says(frame(HilType::tick, 8));
  world.says(frame(HilType::tick, 10));
  EXPECT_EQ(link.receive().head.sequence, 10U);
  EXPECT_EQ(world.answers.size(), 1U);
}

TEST(HilLink, AnotherWorldInTheMiddleOfWorkEndsItAndIsGreetedNext) {
  Script world;
  Link link{world};
  world.says(frame(HilType::hello, 1));
  (void)link.receive();
  link.answer(HilType::ready, 0);
  world.says(frame(HilType::tick, 2));
  (void)link.receive();
  world.says(frame(HilType::hello, 1));  // instead of the answer of the flash
  EXPECT_FALSE(link.ask(HilType::flash_request, 10));
  link.answer(HilType::done, 10);  // for nobody
  const std::size_t answers = world.answers.size();
  EXPECT_EQ(link.receive().head.type, static_cast<std::uint8_t>(HilType::hello));
  link.answer(HilType::ready, 0);
  EXPECT_EQ(answers, 2U);
  EXPECT_EQ(world.answers.size(), 3U);
}

TEST(HilLayout, ChangesWithASignalsNameAndWidth) {
  const auto hash = [](std::string_view name, auto value) {
    protocol::HilLayout layout;  // NOLINT(misc-const-correctness): in a generic function the linter cannot know
    layout(core::SignalName{name, "rad"}, value);
    return layout.hash();
  };
  EXPECT_NE(hash("roll", 0.0F), hash("role", 0.0F));
  EXPECT_NE(hash("roll", 0.0F), hash("roll", true));
  EXPECT_NE(hash("roll", std::uint32_t{0}), hash("roll", std::optional<std::uint32_t>{}));
  EXPECT_EQ(world_link::layout(), world_link::layout());
}

}  // namespace
}  // namespace fantail::test
