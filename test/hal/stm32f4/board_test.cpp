// SPDX-License-Identifier: MIT
#include "hal/stm32f4/board.hpp"

#include "fake_timer.hpp"
#include "hal/signal_pattern.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeTimer;
using test::RegisterWorld;

constexpr std::array all_signals{Signal::safe,    Signal::faulty,          Signal::self_test,
                                 Signal::armed,   Signal::armed_not_ready, Signal::flying,
                                 Signal::finished};

struct TheBoard : testing::Test {
  RegisterWorld world{};
  FakeTimer timer{world};
  registers::Gpio port{};
  registers::Adc converter{};
  registers::AdcCommon common{};
  registers::Rng rng{};
  std::uint32_t random = 1;
  Battery battery{converter, common, {.channel = 12, .reference_mv = 3300, .divider = 11}};
  Buzzer buzzer{timer.registers, 168'000'000, 2'700};
  registers::Dwt dwt{};
  registers::CoreDebug debug{};
  CycleCounter cycles{dwt, debug};
  std::optional<Entropy> entropy;
  std::optional<Board> board;

  TheBoard() {
    world.on_read(rng.sr, [] { return 1U; });
    world.on_read(rng.dr, [this] { return ++random; });
    entropy.emplace(rng);
    board.emplace(
        Board::Parts{
            .light = Pin{port, 2}, .buzzer = buzzer, .battery = battery, .entropy = *entropy, .cycles = cycles},
        ResetCause::pin);
  }

  [[nodiscard]] bool light() const { return RegisterWorld::peek(port.bsrr) == 1U << 2U; }
  /// What a person sees and hears in two seconds: one character for each eighth.
  std::pair<std::string, std::string> shown(Signal signal) {
    std::pair<std::string, std::string> result;
    for (int eighth = 0; eighth < 16; ++eighth) {
      for (int tick = 0; tick < 125; ++tick) {
        board->show(signal);
        timer.pass(1'000);
        if (tick == 62) {
          result.first += light() ? '#' : '.';
          result.second += timer.next_frame().high[0] > 0 ? '#' : '.';
        }
      }
    }
    return result;
  }
};

TEST_F(TheBoard, BeginsWithoutFaultsAndKeepsEachThatIsFound) {
  EXPECT_TRUE(board->status().faults.none());
  board->add(BoardFault::imu_silent);
  BoardFaults several;
  several.add(BoardFault::crystal_failed);
  several.add(BoardFault::crashed);
  board->add(several);
  several.add(BoardFault::imu_silent);
  EXPECT_EQ(board->status().faults, several);
}

TEST_F(TheBoard, SaysWhyItBeganAnewAndWhichTicksDidNotCome) {
  EXPECT_EQ(board->status().reset_cause, ResetCause::pin);
  EXPECT_EQ(board->status().overruns, 0U);
  board->add_overruns(2);
  board->add_overruns(3);
  EXPECT_EQ(board->status().overruns, 5U);
}

TEST_F(TheBoard, ABatteryThatIsNotMeasuredIsAFaultWhileItLasts) {
  for (int tick = 0; tick < 10; ++tick) {
    battery.update();
  }
  EXPECT_TRUE(board->status().faults.has(BoardFault::battery_unmeasured));
  EXPECT_FALSE(board->status().battery_mv);
  RegisterWorld::poke(converter.sr, 2);
  RegisterWorld::poke(converter.dr, 4095);
  battery.update();
  EXPECT_TRUE(board->status().faults.none());
  EXPECT_EQ(board->status().battery_mv, 36'300);
}

TEST_F(TheBoard, AGeneratorThatFailedIsAFaultForGood) {
  EXPECT_FALSE(board->status().faults.has(BoardFault::entropy_failed));
  random = 0xFFFF'FFFF;
  static_cast<void>(entropy->draw());
  random -= 1;
  static_cast<void>(entropy->draw());
  EXPECT_TRUE(board->status().faults.has(BoardFault::entropy_failed));
}

TEST_F(TheBoard, EachSignalIsSeenAndHeardAsItsPatternSays) {
  for (const Signal signal : all_signals) {
    const auto [light, sound] = shown(signal);
    EXPECT_EQ(light, pattern(signal).light);
    EXPECT_EQ(sound, pattern(signal).sound);
  }
}

TEST_F(TheBoard, NoTwoSignalsLookTheSameAndEachHasTwoSeconds) {
  std::vector<std::string_view> lights;
  for (const Signal signal : all_signals) {
    EXPECT_EQ(pattern(signal).light.size(), pattern_steps);
    EXPECT_EQ(pattern(signal).sound.size(), pattern_steps);
    lights.push_back(pattern(signal).light);
  }
  std::ranges::sort(lights);
  EXPECT_EQ(std::ranges::adjacent_find(lights), lights.end());
}

TEST_F(TheBoard, AnArmedRocketIsHeardAtLeastOnceASecondAndASafeOneIsSilent) {
  for (const Signal signal : {Signal::armed, Signal::armed_not_ready}) {
    EXPECT_NE(pattern(signal).sound.substr(0, 8).find('#'), std::string_view::npos);
    EXPECT_NE(pattern(signal).sound.substr(8).find('#'), std::string_view::npos);
  }
  EXPECT_EQ(pattern(Signal::safe).sound.find('#'), std::string_view::npos);
  EXPECT_EQ(pattern(Signal::flying).sound.find('#'), std::string_view::npos);
}

TEST_F(TheBoard, ANewSignalBeginsItsPatternAtOnce) {
  for (int tick = 0; tick < 300; ++tick) {
    board->show(Signal::safe);
  }
  ASSERT_FALSE(light());
  board->show(Signal::armed);
  EXPECT_TRUE(light());
}

TEST_F(TheBoard, TheToneIsTwoThousandSevenHundredHertzAndHalfOfEachWaveIsHigh) {
  EXPECT_EQ(timer.next_frame().high[0], 0U) << "silent at power-up";
  buzzer.sound(true);
  const FakeTimer::Frame wave = timer.next_frame();
  const double wave_s = static_cast<double>(timer.counts_per_frame() * timer.divider()) / 168e6;
  EXPECT_NEAR(1 / wave_s, 2'700, 5);
  EXPECT_NEAR(wave.high[0], static_cast<double>(timer.counts_per_frame()) / 2, 1);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
