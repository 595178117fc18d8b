// SPDX-License-Identifier: MIT
// What a bit that flips does to the flashed image, on a board that has just been switched on.
#include <array>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "flip_trial.hpp"
#include "in_fork.hpp"
#include "input/scenario_file.hpp"

namespace fantail::board {
namespace {

constexpr double looked_s = 0.15;

/// What happens to the board, and what it showed then.
struct Shown {
  Pins pins{};
  std::size_t pulses = 0;
  std::array<double, 400> widths_us{};
  std::size_t restarts = 0;
  ResetKind last{};
  std::array<char, 200> complaint{};
  std::array<char, 1000> said{};
};

/// All cases leave it as it is: each has a process of its own.
class Upsets : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::filesystem::path file{FANTAIL_TEST_SOURCE "/build/arm/fantail-stm32f405.elf"};
    if (!std::filesystem::exists(file)) {
      return;  // nobody has built it
    }
    image_ = std::make_unique<Image>(file);
    scenario_ = std::make_unique<sim::Scenario>(input::load_scenario("tasha3_launch2", {}));
    flight_ = std::make_unique<BoardFlight>(*image_, *scenario_);
    flight_->fly_for(0.1);
  }
  static void TearDownTestSuite() {
    flight_.reset();
    scenario_.reset();
    image_.reset();
  }
  void SetUp() override {
    if (!flight_) {
      GTEST_SKIP() << "build/arm/fantail-stm32f405.elf is not built";
    }
  }

  static Shown shown_after(const std::function<void(Board&)>& event, const core::FlightPlan& plan = scenario_->plan) {
    const auto shown = in_fork<Shown>(20, [&] {
      Board& board = flight_->board();
      const std::size_t before = board.chip.pulses().size();
      const std::size_t said = flight_->said().size();
      PinWatch watch{*flight_, plan, board.now_s()};
      board.timeline.schedule(board.timeline.add([&] { event(board); }), board.now_s() + 1e-3);
      Shown found;
      for (double flown_s = 0.0; flown_s < looked_s; flown_s += 1e-3) {
        flight_->step();
        watch.follow();
      }
      found.pins = watch.pins();
      for (std::size_t i = before; i < board.chip.pulses().size() && found.pulses < found.widths_us.size(); ++i) {
        found.widths_us[found.pulses++] = board.chip.pulses()[i].width_us;
      }
      found.restarts = board.restarts.size();
      found.last = board.restarts.back().kind;
      if (!board.processor.complaints.empty()) {
        std::strncpy(found.complaint.data(), board.processor.complaints.back().what.c_str(),
                     found.complaint.size() - 1);
      }
      std::strncpy(found.said.data(), flight_->said().c_str() + said, found.said.size() - 1);
      return found;
    });
    EXPECT_TRUE(shown) << "it came to no end";
    return shown.value_or(Shown{});
  }

  static std::unique_ptr<Image> image_;
  static std::unique_ptr<sim::Scenario> scenario_;
  static std::unique_ptr<BoardFlight> flight_;
};
std::unique_ptr<Image> Upsets::image_;
std::unique_ptr<sim::Scenario> Upsets::scenario_;
std::unique_ptr<BoardFlight> Upsets::flight_;

bool says(const Shown& shown, const std::string& text) {
  return std::string{shown.complaint.data()}.find(text) != std::string::npos;
}

TEST_F(Upsets, ABitThatFlipsInAnUnusedWordOfTheMemoryChangesNoPulse) {
  const Shown plain = shown_after([](Board&) {});
  const Shown flipped = shown_after([](Board& board) {
    std::byte value{};
    const std::uint32_t unused = *image_->address_of("bss_end") + 0x1000;
    board.processor.read_memory(unused, std::span{&value, 1});
    value ^= std::byte{1};
    board.processor.write_memory(unused, std::span{&value, 1});
  });
  EXPECT_GT(plain.pulses, 150U);  // four canards, a frame of 3 ms
  EXPECT_EQ(flipped.pulses, plain.pulses);
  EXPECT_EQ(flipped.widths_us, plain.widths_us);
  EXPECT_EQ(flipped.restarts, 1U);
}

TEST_F(Upsets, AProgramCounterThatIsSentToNowhereIsNamedAndTheFirmwareResetsItself) {
  const Shown shown = shown_after([](Board& board) { board.processor.jump(0x3000'0000, false); });
  EXPECT_TRUE(says(shown, "an access to 0x30000000, where nothing is, by 0x30000000")) << shown.complaint.data();
  EXPECT_EQ(shown.restarts, 2U);
  EXPECT_EQ(shown.last, ResetKind::software);
  EXPECT_NE(std::string{shown.said.data()}.find("crash: exception 0x00000003 at 0x30000000"), std::string::npos)
      << shown.said.data();
  EXPECT_EQ(shown.pins.cut, 0);
}

// Of the stack pointer bit 28 is clear in all of the memory: 0x20000000 becomes 0x30000000.
TEST_F(Upsets, AStackPointerOutsideOfTheMemoryEndsInAReset) {
  const Shown shown = shown_after([](Board& board) { board.processor.flip_register(13, 28); });
  EXPECT_GE(shown.restarts, 2U);
  EXPECT_NE(shown.complaint[0], '\0');
}

// Between two ticks, when nobody computes.
TEST_F(Upsets, ABitOfTheFloatingPointUnitTurnsOverAlone) {
  for (const unsigned number : {0U, 17U, Processor::float_status}) {
    const auto changed = in_fork<std::uint32_t>(20, [number] {
      Board& board = flight_->board();
      const std::uint32_t before = board.processor.float_register(number);
      board.timeline.schedule(board.timeline.add([&] { board.processor.flip_float_register(number, 23); }),
                              board.now_s() + 50e-6);
      board.run_until(board.now_s() + 100e-6);
      return before ^ board.processor.float_register(number);
    });
    EXPECT_EQ(changed, 1U << 23U) << number;
  }
}

// 9 deg of 10 us each is what this plan allows a canard, and 20 deg what is compiled in.
TEST_F(Upsets, APulseBeyondThePlanAndBeyondTheHardLimitIsFound) {
  core::FlightPlan plan = scenario_->plan;
  const auto beside = [&plan](float us) {
    for (core::CanardPlan& canard : plan.canards.each) {
      canard.pulse_centre_us = 1500.0F - us;
    }
    return shown_after([](Board&) {}, plan).pins;
  };
  const Pins right = beside(0.0F);
  EXPECT_EQ(right.beyond_plan, 0);
  const Pins beyond_plan = beside(150.0F);
  EXPECT_GT(beyond_plan.beyond_plan, 150);
  EXPECT_EQ(beyond_plan.beyond_hard, 0);
  EXPECT_GT(beside(250.0F).beyond_hard, 150);
}

TEST_F(Upsets, TheSameSeedAndNumberAreTheSameFlip) {
  const MemoryMap map{*image_, flight_->board()};
  const auto what = [&](std::uint64_t seed, int number) {
    Board& board = flight_->board();
    const Flip flip{seed, number};
    return in_fork<std::array<char, 40>>(20,
                                         [&] {
                                           std::array<char, 40> text{};
                                           std::strncpy(text.data(), flip.happen(board, map).c_str(), text.size() - 1);
                                           return text;
                                         })
        .value_or(std::array<char, 40>{});
  };
  EXPECT_EQ(what(1, 7), what(1, 7));
  EXPECT_NE(what(1, 7), what(1, 8));
  EXPECT_NE(what(1, 7), what(2, 7));
}

}  // namespace
}  // namespace fantail::board
