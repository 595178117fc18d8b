// SPDX-License-Identifier: MIT
#include "hal/stm32f4/console.hpp"

namespace fantail::hal::stm32f4 {
namespace {

using namespace registers;

constexpr std::uint32_t receiving = usart_cr1_ue | usart_cr1_te | usart_cr1_re | usart_cr1_rxneie;
constexpr std::uint32_t receiving_and_sending = receiving | usart_cr1_txeie;

}  // namespace

Console::Console(Usart& port, InterruptLine interrupt, std::uint32_t bus_hz, std::uint32_t baud)
    : port_{&port}, interrupt_{interrupt} {
  // With sixteen samples a bit, BRR is the bit time in cycles of the bus: RM0090 section 30.3.4.
  port.brr.write((bus_hz + baud / 2) / baud);
  port.cr1.write(receiving);
}

void Console::send(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    if (!to_send_.push(byte)) {
      dropped_ += 1;
    }
  }
  // Not by enabling the interrupt of an empty transmitter: only the handler touches CR1, and in the emulator that
  // interrupt never comes.
  interrupt_.pend();
}

void Console::on_interrupt() {
  receive();
  transmit();
}

// Section 30.6.1: the read of DR after that of SR clears RXNE and ORE. An overrun may show without RXNE, and would
// interrupt for ever if DR was not read then too.
void Console::receive() {
  const std::uint32_t status = port_->sr.read();
  if ((status & (usart_sr_rxne | usart_sr_ore)) == 0) {
    return;
  }
  const auto byte = static_cast<std::byte>(port_->dr.read());
  const bool fits = (status & usart_sr_rxne) == 0 || arrived_.push(byte);
  if (!fits || (status & usart_sr_ore) != 0) {
    overruns_ = overruns_ + 1;
  }
}

void Console::transmit() {
  while (port_->sr.any(usart_sr_txe)) {
    const std::optional<std::byte> byte = to_send_.pop();
    if (!byte) {
      port_->cr1.write(receiving);
      return;
    }
    port_->dr.write(std::to_integer<std::uint32_t>(*byte));
  }
  port_->cr1.write(receiving_and_sending);
}

}  // namespace fantail::hal::stm32f4
