// SPDX-License-Identifier: MIT
// What interrupts the loop. All have the priority of a reset, which is one and the same, so none interrupts another.
#include "boards/stm32f405/hardware.hpp"

using fantail::boards::stm32f405::running_hardware;

extern "C" {

void systick_handler() { running_hardware()->clock().tick(); }
void can1_tx_handler() { running_hardware()->can_bus().on_transmit_interrupt(); }
void can1_rx0_handler() { running_hardware()->can_bus().on_receive_interrupt(); }
void can1_sce_handler() { running_hardware()->can_bus().on_error_interrupt(); }
void usart1_handler() { running_hardware()->console().on_interrupt(); }

}  // extern "C"
