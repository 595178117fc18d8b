// SPDX-License-Identifier: MIT
#include "hal/stm32f4/encoder.hpp"

#include "fake_as5047p.hpp"
#include "fake_clock.hpp"
#include "hal/stm32f4/as5047p.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using test::FakeAs5047p;
using test::FakeClock;
using test::FakePort;
using test::FakeSpi;
using test::RegisterWorld;

constexpr std::uint32_t bus_hz = 42'000'000;
constexpr Microseconds tick{1'000};

class EncoderTest : public testing::Test {
 protected:
  RegisterWorld world;
  FakeClock clock;
  FakePort port{world};
  FakeSpi spi{world, bus_hz};
  std::array<FakeAs5047p, canards> devices{};
  SpiBus bus{spi.block(), bus_hz};

  void SetUp() override {
    for (std::uint8_t i = 0; i < canards; ++i) {
      spi.attach(port, i, devices[i]);
      devices[i].angle = static_cast<std::uint16_t>(1000 * (i + 1));
    }
  }
  void TearDown() override {
    for (const std::string& violation : spi.violations) {
      ADD_FAILURE() << violation;
    }
  }

  Encoder make(const Encoder::Reversed& reversed = {}) {
    const auto device = [this](std::uint8_t pin) { return SpiDevice{bus, Pin{port.block(), pin}, as5047p::spi}; };
    return Encoder{{device(0), device(1), device(2), device(3)}, clock, reversed};
  }
  EncoderReading next(Encoder& encoder) {
    clock.time += tick;
    return encoder.read();
  }
  /// How many reads until encoder 0 is well again, at most so many.
  int reads_until_ok(Encoder& encoder, int most) {
    for (int i = 1; i <= most; ++i) {
      if (next(encoder).each[0].status == Status::ok) {
        return i;
      }
    }
    return most + 1;
  }
};

TEST_F(EncoderTest, TheFirstReadKnowsNothingAndTheSecondAnswersIt) {
  Encoder encoder = make();
  for (const EncoderSample& sample : next(encoder).each) {
    EXPECT_EQ(sample.status, Status::no_reading);
  }
  const Microseconds asked = clock.time;
  const EncoderReading reading = next(encoder);
  EXPECT_EQ(reading.time, asked);
  for (std::size_t i = 0; i < canards; ++i) {
    EXPECT_EQ(reading.each[i].status, Status::ok);
    EXPECT_EQ(reading.each[i].counts, 1000 * (i + 1));
  }
  EXPECT_EQ(spi.clock_hz(), 5'250'000U);
}

TEST_F(EncoderTest, ATickCostsOneFramePerEncoder) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  spi.forget_traffic();
  static_cast<void>(next(encoder));
  EXPECT_EQ(spi.bytes(), 8U);
}

TEST_F(EncoderTest, AShaftThatTurnsTheOtherWayIsCountedTheOtherWay) {
  Encoder encoder = make({true, false, false, true});
  devices[3].angle = 0x3FFF;
  static_cast<void>(next(encoder));
  const EncoderReading reading = next(encoder);
  EXPECT_EQ(reading.each[0].counts, 16384 - 1000);
  EXPECT_EQ(reading.each[1].counts, 2000);
  EXPECT_EQ(reading.each[3].counts, 1);
}

TEST_F(EncoderTest, AParityErrorIsAnErrorAndTheOthersAreStillRead) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  for (unsigned bit = 0; bit < 16; ++bit) {
    devices[0].spoil_answers = static_cast<std::uint16_t>(1U << bit);
    const EncoderReading reading = next(encoder);
    EXPECT_EQ(reading.each[0].status, Status::error) << bit;
    EXPECT_EQ(reading.each[1].status, Status::ok);
    EXPECT_EQ(reading.each[1].counts, 2000);
  }
  devices[0].spoil_answers = 0;
  EXPECT_LE(reads_until_ok(encoder, 10), 2);  // the answer may have been its diagnosis
}

TEST_F(EncoderTest, ACommandThatArrivedSpoiltIsAnErrorUntilTheFlagsHaveBeenReadAndCleared) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  static_cast<void>(next(encoder));
  devices[0].spoil_next_command = 0x0010;
  EXPECT_EQ(next(encoder).each[0].status, Status::ok);  // the answer to the one before
  EXPECT_EQ(next(encoder).each[0].status, Status::error);
  EXPECT_EQ(devices[0].error_reads, 0);
  EXPECT_EQ(next(encoder).each[0].status, Status::error);
  EXPECT_EQ(devices[0].error_reads, 1);
  EXPECT_EQ(next(encoder).each[0].status, Status::error);  // what ERRFL held
  devices[0].angle = 1234;
  static_cast<void>(next(encoder));
  const EncoderReading reading = next(encoder);
  EXPECT_EQ(reading.each[0].status, Status::ok);
  EXPECT_EQ(reading.each[0].counts, 1234);
  EXPECT_EQ(devices[0].error_reads, 1);
}

TEST_F(EncoderTest, ALineThatIsHeldUpOrDownIsNoReadingAndTheOthersAreStillRead) {
  for (const std::uint8_t level : std::array<std::uint8_t, 2>{0x00, 0xFF}) {
    Encoder encoder = make();
    static_cast<void>(next(encoder));
    devices[0].stuck_at = level;
    for (int i = 0; i < 300; ++i) {
      const EncoderReading reading = next(encoder);
      ASSERT_EQ(reading.each[0].status, Status::no_reading) << i;
      ASSERT_EQ(reading.each[2].status, Status::ok);
    }
    EXPECT_TRUE(encoder.faults().has(BoardFault::encoder_silent));
    devices[0].stuck_at.reset();
    EXPECT_LE(reads_until_ok(encoder, 20), 4);
    EXPECT_TRUE(encoder.faults().none());
  }
}

TEST_F(EncoderTest, TheAngleZeroIsAnAngleWhereAShaftComesBy) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  for (const std::uint16_t angle : std::array<std::uint16_t, 6>{30, 3, 0, 0, 16383, 16350}) {
    devices[0].angle = angle;
    static_cast<void>(next(encoder));
    const EncoderReading reading = next(encoder);
    EXPECT_EQ(reading.each[0].status, Status::ok) << angle;
    EXPECT_EQ(reading.each[0].counts, angle);
  }
}

TEST_F(EncoderTest, ALineThatIsHeldDownAtTheAngleZeroIsFoundOutAfterTenReads) {
  Encoder encoder = make();
  devices[0].angle = 3;
  static_cast<void>(next(encoder));
  static_cast<void>(next(encoder));
  devices[0].stuck_at = 0x00;
  int taken_for_zero = 0;
  while (next(encoder).each[0].status == Status::ok && taken_for_zero < 100) {
    ++taken_for_zero;
  }
  EXPECT_EQ(taken_for_zero, 10);
  for (int i = 0; i < 300; ++i) {
    ASSERT_EQ(next(encoder).each[0].status, Status::no_reading);
  }
}

TEST_F(EncoderTest, AMagnetThatIsGoneIsAnErrorWithinOneRoundOfDiagnoses) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  for (const std::uint16_t diagnosis :
       std::array<std::uint16_t, 4>{0x0980, 0x0500, 0x0380, 0x0080}) {  // too weak, too strong, overflow, not ready
    devices[0].diagnosis = diagnosis;
    for (int i = 0; i < Encoder::diagnosis_period + 1; ++i) {
      static_cast<void>(next(encoder));
    }
    for (int i = 0; i < 2 * Encoder::diagnosis_period; ++i) {
      const EncoderReading reading = next(encoder);
      ASSERT_EQ(reading.each[0].status, Status::error);
      ASSERT_EQ(reading.each[1].status, Status::ok);
    }
  }
  devices[0].diagnosis = 0x0180;
  EXPECT_LE(reads_until_ok(encoder, 200), Encoder::diagnosis_period + 2);
}

TEST_F(EncoderTest, ADiagnosisCostsOneAngleOfOneEncoderAndNoStatus) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  int old_angles = 0;
  for (int i = 0; i < 2 * Encoder::diagnosis_period; ++i) {
    for (FakeAs5047p& device : devices) {
      device.angle = static_cast<std::uint16_t>(5000 + i);
    }
    const EncoderReading reading = next(encoder);
    int old_now = 0;
    for (const EncoderSample& sample : reading.each) {
      ASSERT_EQ(sample.status, Status::ok);
      old_now += i > 1 && sample.counts != 5000 + i - 1 ? 1 : 0;
    }
    ASSERT_LE(old_now, 1);
    old_angles += old_now;
  }
  EXPECT_EQ(old_angles, 8);  // four encoders, two rounds
}

TEST_F(EncoderTest, ABusThatStopsIsNoReadingFromAnyOfThem) {
  Encoder encoder = make();
  static_cast<void>(next(encoder));
  static_cast<void>(next(encoder));
  spi.stop();
  for (const EncoderSample& sample : next(encoder).each) {
    EXPECT_EQ(sample.status, Status::no_reading);
  }
  spi.violations.clear();
  spi.go_on();
  EXPECT_LE(reads_until_ok(encoder, 20), 5);
}

}  // namespace
}  // namespace fantail::hal::stm32f4
