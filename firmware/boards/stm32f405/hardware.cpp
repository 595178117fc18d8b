// SPDX-License-Identifier: MIT
#include "boards/stm32f405/hardware.hpp"

#include <array>

#include "boards/stm32f405/pin_map.hpp"
#include "hal/stm32f4/as5047p.hpp"
#include "hal/stm32f4/icm42688.hpp"
#include "hal/stm32f4/ism330dhcx.hpp"
#include "hal/stm32f4/kx134.hpp"
#include "hal/stm32f4/memory_protection.hpp"
#include "hal/stm32f4/ms5611.hpp"
#include "hal/stm32f4/pin.hpp"
#include "hal/stm32f4/pin_setup.hpp"
#include "hal/stm32f4/registers/processor.hpp"
#include "hal/stm32f4/reset_cause.hpp"
#include "hal/stm32f4/slow_oscillator.hpp"
#include "hal/stm32f4/w25q.hpp"
#include "protocol/bus_catalogue.hpp"

namespace fantail::boards::stm32f405 {
namespace {

using namespace hal::stm32f4;  // NOLINT(google-build-using-namespace): this file is where they all come together

constexpr Battery::Wiring battery_wiring{.channel = 12, .reference_mv = 3'300, .divider = 11};
constexpr std::uint32_t buzzer_hz = 2'700;  // where a small piezo is loudest

/// In a tick: behind its commands, as long as an instruction takes at most 3.5 cycles (board_timing).
constexpr hal::Microseconds frame_begins{500};

enum Interrupt : std::uint8_t { can1_tx = 19, can1_rx0 = 20, can1_sce = 22, usart1_all = 37 };

Hardware* running = nullptr;

Pin pin(char name, std::uint8_t number) { return {port(name), number}; }

ClockTree start_clocks_and_pins() {
  registers::mask_interrupts();  // until all that they call is there
  protect_memory(mpu());
  const ClockTree tree = start_clocks(rcc(), flash_interface(), pwr());
  enable_peripherals(rcc());
  for (const PinSetup& setup : pin_map) {
    set_up(port(setup.port), setup);
  }
  return tree;
}

InterruptLine line(Interrupt number) { return {nvic().ispr[number / 32U], number}; }

void let_in(Interrupt number) { nvic().iser[number / 32U].write(1U << (number % 32U)); }

SpiDevice encoder_on(SpiBus& bus, char name, std::uint8_t number) { return {bus, pin(name, number), as5047p::spi}; }

}  // namespace

Hardware* running_hardware() { return running; }

Hardware::Hardware()
    : reset_cause_{take_reset_cause(rcc())},
      tree_{start_clocks_and_pins()},
      watchdog_{iwdg()},
      clock_{systick(), scb(), tree_.frequencies.core_hz},
      console_{usart1(), line(usart1_all), tree_.frequencies.apb2_hz},
      backup_memory_{rcc(), pwr(), rtc(), backup_cells()},
      supply_{pwr(), exti()},
      entropy_{rng()},
      battery_{adc1(), adc_common(), battery_wiring},
      buzzer_{tim1(), tree_.frequencies.apb2_timers_hz, buzzer_hz},
      cycles_{dwt(), core_debug()},
      board_{{.light = pin('B', 2), .buzzer = buzzer_, .battery = battery_, .entropy = entropy_, .cycles = cycles_},
             reset_cause_},
      arm_switch_{pin('C', 3), ClosedLevel::high},
      abort_contact_{pin('C', 1), ClosedLevel::low},
      servo_{tim8(), tree_.frequencies.apb2_timers_hz},
      imu_bus_{spi1(), tree_.frequencies.apb2_hz},
      encoder_bus_{spi2(), tree_.frequencies.apb1_hz},
      shared_bus_{spi3(), tree_.frequencies.apb1_hz},
      imu_{{imu_bus_, pin('A', 4), icm42688::spi}, clock_, {tim2(), tree_.frequencies.apb1_timers_hz}},
      second_imu_{{shared_bus_, pin('B', 11), ism330dhcx::spi}, clock_},
      accelerometer_{{shared_bus_, pin('C', 4), kx134::spi}, clock_},
      barometer_{{shared_bus_, pin('B', 10), ms5611::spi}, clock_},
      encoder_{{encoder_on(encoder_bus_, 'B', 12), encoder_on(encoder_bus_, 'B', 0), encoder_on(encoder_bus_, 'B', 1),
                encoder_on(encoder_bus_, 'C', 5)},
               clock_},
      flash_{{shared_bus_, pin('A', 15), w25q::spi}, clock_},
      can_bus_{can1(), pin('C', 0), line(can1_tx)} {
  board_.add(tree_.faults);
  running = this;
}

avionics::Devices Hardware::devices() {
  return {.clock = clock_,
          .imu = imu_,
          .accelerometer = accelerometer_,
          .servo = servo_,
          .encoder = encoder_,
          .arm_switch = arm_switch_,
          .abort_contact = abort_contact_,
          .can_bus = can_bus_,
          .flash = flash_,
          .console = console_,
          .watchdog = watchdog_,
          .entropy = entropy_,
          .board = board_,
          .backup_memory = backup_memory_,
          .second_imu = &second_imu_,
          .barometer = &barometer_};
}

void Hardware::start(SensorStart how) {
  const auto oscillator_hz = measure_slow_oscillator(rcc(), tim5(), tree_.frequencies.apb1_timers_hz);
  if (!watchdog_.start(oscillator_hz) || !oscillator_hz) {
    board_.add(hal::BoardFault::clock_failed);
  }
  imu_.start(how);
  second_imu_.start(how);
  accelerometer_.start(how);
  barometer_.start(how);
  flash_.start();

  if (const auto fault = can_bus_.start(tree_.frequencies.apb1_hz, protocol::bench_frame_ids())) {
    board_.add(*fault);
  }
  for (const Interrupt interrupt : {can1_tx, can1_rx0, can1_sce, usart1_all}) {
    let_in(interrupt);
  }
  registers::unmask_interrupts();
  // Whatever of the millisecond is left now, at every boot the same of it is left when a frame begins.
  servo_.begin_frame_in((frame_begins - clock_.since_tick() + hal::Microseconds{1'000}) % hal::Microseconds{1'000});
}

void Hardware::wait_for_tick() {
  cycles_.end();
  board_.add_overruns(clock_.wait_for_tick());
  cycles_.begin();
  arm_switch_.update();
  abort_contact_.update();
  backup_memory_.update();
  battery_.update();
  supply_.update();
  hal::BoardFaults sensors = imu_.faults();
  sensors.add(accelerometer_.faults());
  sensors.add(encoder_.faults());
  sensors.add(flash_.faults());
  sensors.add(supply_.faults());
  board_.set_now(sensors);
}

}  // namespace fantail::boards::stm32f405
