// SPDX-License-Identifier: MIT
#include <iostream>

#include "avionics/board_rig.hpp"
#include "avionics/can_frame.hpp"
#include "random_stream.hpp"
#include "seed.hpp"
#include "test.hpp"

namespace fantail::avionics {
namespace {

using core::Phase;

// The soak test asks for more.
std::uint64_t how_many_frames() { return test::how_many("FANTAIL_FRAMES", 1'000'000); }

constexpr std::uint32_t usual_seed = 20'261'121;

// Random frames, and good ones with something wrong in them: those come further.
class FrameMutator {
 public:
  explicit FrameMutator(std::uint32_t seed) : random_{seed} {}

  hal::CanFrame frame() {
    hal::CanFrame frame = below(2) == 0 ? anything() : sensible();
    if (below(4) == 0) {
      frame.data[below(8)] ^= static_cast<std::uint8_t>(1U << below(8));
    }
    if (below(16) == 0) {
      frame.length = static_cast<std::uint8_t>(below(9));
    }
    if (below(64) == 0) {
      frame.id ^= 1U << below(11);
    }
    frame.extended = below(128) == 0;
    frame.remote = below(128) == 0;
    return frame;
  }

 private:
  std::uint32_t below(int limit) { return static_cast<std::uint32_t>(random_.whole(0, limit - 1)); }

  hal::CanFrame anything() {
    hal::CanFrame frame{.id = below(8) == 0 ? below(0x800) : below(0x42), .length = 8};
    for (std::uint8_t& byte : frame.data) {
      // NaN-like patterns are bytes of ones.
      byte = below(4) == 0 ? 0xFF : static_cast<std::uint8_t>(below(256));
    }
    return frame;
  }

  std::uint16_t session() { return static_cast<std::uint16_t>(below(4)); }
  core::Angle angle() { return core::Angle::from_degrees((static_cast<float>(below(4095)) - 2047.0F) * 0.01F); }

  hal::CanFrame sensible() {
    const auto counter = static_cast<std::uint8_t>(below(4) == 0 ? below(16) : counter_++ & 0xFU);
    protocol::BusFrame frame;
    switch (below(6)) {
      case 0:
      case 1: frame = encode(protocol::BenchRequest{{angle(), angle(), angle(), angle()}}, counter, session()); break;
      case 2:
        frame = encode(
            protocol::BenchSession{.action = static_cast<protocol::SessionAction>(below(3)), .session = session()},
            counter);
        break;
      case 3:
        frame = encode(
            protocol::ArmRequest{.action = static_cast<protocol::ArmAction>(below(4)), .nonce = below(0x7FFFFFFF)},
            counter);
        break;
      case 4:
        frame =
            encode(protocol::PlanBegin{.size = static_cast<std::uint16_t>(below(1200)), .block_crc = below(0x7FFFFFFF)},
                   counter);
        break;
      default: {
        protocol::PlanData data{.index = static_cast<std::uint8_t>(below(256))};
        std::ranges::generate(data.bytes, [this] { return static_cast<std::byte>(below(256)); });
        frame = encode(data);
      }
    }
    return can_frame(frame);
  }

  core::RandomStream random_;
  std::uint32_t counter_ = 0;
};

// Open, self_test and begin can come out of the mutations by chance, as they can on a real bus: what they may do is
// then allowed, and nothing else.
TEST(BusFrames, RandomAndMutatedOnesMoveNoCanardOutsideItsRightAndNeverBreakALimit) {
  const std::uint64_t frames = how_many_frames();
  std::cout << "frames: " << frames << "\n";
  FrameMutator mutator{test::seed(usual_seed)};
  BoardRig rig;
  rig.run(3 * second);
  constexpr double limit_deg = 9.0;  // of the default plan
  std::uint64_t moved_by_right = 0;
  for (std::uint64_t sent = 0; sent < frames;) {
    for (int i = 0; i < 20; ++i, ++sent) {
      (void)rig.pc.bus.send(mutator.frame());
    }
    rig.hardware.arm_switch_closed = sent % 100'000 >= 50'000;
    const core::TickRecord& record = rig.tick();
    ASSERT_EQ(record.phase, Phase::safe) << "after " << sent;
    const auto& status = rig.pc.heard<protocol::StatusReport>();
    const bool has_right = status->session_open || status->self_test_running;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(rig.servo.written[i]) << "after " << sent;
      const double angle_deg = rig.commanded_deg(i);
      ASSERT_LE(std::abs(angle_deg), limit_deg + 1e-3) << "after " << sent;
      // The status is up to ten milliseconds old, so its word counts for the time around it.
      if (std::abs(angle_deg) > 0.01) {
        moved_by_right += 1;
        if (!has_right) {
          for (int wait = 0; wait < 10; ++wait) {
            rig.tick();
          }
          ASSERT_TRUE(rig.pc.heard<protocol::StatusReport>()->session_open ||
                      rig.pc.heard<protocol::StatusReport>()->self_test_running ||
                      std::abs(rig.commanded_deg(i)) < 0.01)
              << "after " << sent;
        }
      }
    }
  }
  std::cout << "canard ticks in a session or self-test that chance had opened: " << moved_by_right << "\n";
  // All of them were looked at, and the causes were told apart.
  rig.run(second);
  const auto& rejected = rig.pc.heard<protocol::RejectionReport>();
  ASSERT_TRUE(rejected);
  for (std::size_t cause = 0; cause < protocol::rejection_count; ++cause) {
    std::cout << "refused, cause " << cause << ": " << int{rejected->count[cause]} << " (modulo 256)\n";
  }
}

// In the tunnel, because there a frame could even start control.
TEST(BusFrames, RandomAndMutatedOnesNeitherMoveACanardOfAnArmedRocketNorEndThePhase) {
  const std::uint64_t frames = how_many_frames() / 10;
  std::cout << "frames: " << frames << "\n";
  FrameMutator mutator{test::seed(usual_seed)};
  core::FlightPlan plan = core::default_plan();
  plan.run.start = core::Start::tunnel;
  BoardRig rig{plan};
  ASSERT_EQ(rig.arm().phase, Phase::armed);
  for (std::uint64_t sent = 0; sent < frames; sent += 20) {
    for (int i = 0; i < 20; ++i) {
      (void)rig.pc.bus.send(mutator.frame());
    }
    ASSERT_EQ(rig.tick().phase, Phase::armed) << "after " << sent;
    ASSERT_TRUE(rig.all_pulses_are(0.0)) << "after " << sent;
  }
}

// A bench that does its best while somebody else babbles: it may lose its session, and no canard its limit.
TEST(BusFrames, NoneBreaksALimitWhileABenchWorks) {
  const std::uint64_t frames = how_many_frames() / 10;
  std::cout << "frames: " << frames << "\n";
  FrameMutator mutator{test::seed(usual_seed)};
  BoardRig rig;
  rig.run(3 * second);
  std::uint64_t moved = 0;
  for (std::uint64_t sent = 0; sent < frames; sent += 2) {
    if (rig.hardware.time.count() % 20'000 == 0) {
      rig.pc.say(protocol::BenchSession{.action = protocol::SessionAction::open, .session = 7});
    }
    rig.pc.say(protocol::BenchRequest{{core::Angle::from_degrees(20.0F), core::Angle::from_degrees(-20.0F), {}, {}}});
    (void)rig.pc.bus.send(mutator.frame());
    (void)rig.pc.bus.send(mutator.frame());
    ASSERT_EQ(rig.tick().phase, Phase::safe) << "after " << sent;
    for (std::size_t i = 0; i < 4; ++i) {
      ASSERT_LE(std::abs(rig.commanded_deg(i)), 9.0 + 1e-3) << "after " << sent;
      moved += std::abs(rig.commanded_deg(i)) > 0.01 ? 1 : 0;
    }
  }
  EXPECT_GT(moved, 0U) << "the bench never got through, so nothing was tested";
}

}  // namespace
}  // namespace fantail::avionics
