// SPDX-License-Identifier: MIT
#pragma once

#include "fake_clock.hpp"
#include "fake_spi.hpp"
#include "hal/sample.hpp"
#include "hal/stm32f4/spi_bus.hpp"
#include "register_world.hpp"
#include "test.hpp"

namespace fantail::hal::stm32f4::test {

/// One sensor on a bus of its own, and a clock that goes a millisecond a read. Nothing may be done that the device or
/// the bus forbids.
template <typename Device, std::uint32_t bus_hz>
class SensorTest : public testing::Test {
 protected:
  static constexpr Microseconds tick{1'000};

  RegisterWorld world;
  FakeClock clock;
  FakePort port{world};
  FakeSpi spi{world, bus_hz};
  Device device{clock};
  SpiBus bus{spi.block(), bus_hz};

  void SetUp() override { spi.attach(port, 4, device); }
  void TearDown() override {
    for (const auto& violations : {spi.violations, device.violations}) {
      for (const std::string& violation : violations) {
        ADD_FAILURE() << violation;
      }
    }
  }

  SpiDevice place(const SpiSettings& settings) { return {bus, Pin{port.block(), 4}, settings}; }
  /// As on the board: a byte takes time, and of two ticks one is later than its millisecond by as little as `late`. How
  /// many of the readings were good.
  template <typename Driver>
  int read_while_time_passes(Driver& driver, int ticks, Microseconds late) {
    spi.on_byte = [this] { clock.time += Microseconds{2}; };
    int good = 0;
    for (int i = 0; i < ticks; ++i) {
      const Microseconds begun = clock.time;
      good += driver.read().status == Status::ok ? 1 : 0;
      clock.time = begun + tick + (i % 2 == 0 ? Microseconds{0} : late);
    }
    spi.on_byte = nullptr;
    return good;
  }
  template <typename Driver>
  auto next(Driver& driver) {
    clock.time += tick;
    return driver.read();
  }
  /// Ticks until a sample comes, at most so many.
  template <typename Driver>
  int ticks_to_sample(Driver& driver, int most) {
    for (int i = 1; i <= most; ++i) {
      if (next(driver).status == Status::ok) {
        return i;
      }
    }
    return most + 1;
  }
};

}  // namespace fantail::hal::stm32f4::test
