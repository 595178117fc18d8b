// SPDX-License-Identifier: MIT
// What interrupts the loop. All have the priority of a reset, which is one and the same, so none interrupts another.
// Each ends with its stores done: one that is still on its way when the handler returns may lead into the wrong handler
// (erratum 838869 of the Cortex-M4), and a flag that is cleared late into the same one again.
#include "boards/stm32f405/hardware.hpp"
#include "hal/stm32f4/registers/processor.hpp"

using fantail::boards::stm32f405::running_hardware;
using fantail::hal::stm32f4::registers::finish_stores;

extern "C" {

void systick_handler() {
  running_hardware()->clock().tick();
  finish_stores();
}
void can1_tx_handler() {
  running_hardware()->can_bus().on_transmit_interrupt();
  finish_stores();
}
void can1_rx0_handler() {
  running_hardware()->can_bus().on_receive_interrupt();
  finish_stores();
}
void can1_sce_handler() {
  running_hardware()->can_bus().on_error_interrupt();
  finish_stores();
}
void usart1_handler() {
  running_hardware()->console().on_interrupt();
  finish_stores();
}

}  // extern "C"
