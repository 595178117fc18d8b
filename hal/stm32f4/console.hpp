// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/console.hpp"
#include "hal/stm32f4/interrupt_line.hpp"
#include "hal/stm32f4/interrupt_queue.hpp"
#include "hal/stm32f4/registers/usart.hpp"

namespace fantail::hal::stm32f4 {

/// A serial port, 8 bits, no parity, one stop bit. Both directions go through queues that the interrupt handler fills
/// and empties; nothing waits.
class Console final : public hal::Console {
 public:
  static constexpr std::uint32_t default_baud = 115'200;

  /// `interrupt`: the port's own, by which a write asks its handler to begin. It has to be enabled in the NVIC.
  Console(registers::Usart& port, InterruptLine interrupt, std::uint32_t bus_hz, std::uint32_t baud = default_baud);

  void write(std::string_view text) override { send(std::as_bytes(std::span{text})); }
  /// What does not fit is dropped and counted.
  void send(std::span<const std::byte> bytes);
  /// The oldest byte that has arrived and has not been taken.
  [[nodiscard]] std::optional<std::byte> take() { return arrived_.pop(); }

  /// Called only by the interrupt handler.
  void on_interrupt();

  /// Bytes that were not sent because the queue was full, since power-up.
  [[nodiscard]] std::uint32_t dropped() const { return dropped_; }
  /// Losses of one byte or more on arrival, since power-up: the handler came too late, or they were not taken in time.
  [[nodiscard]] std::uint32_t overruns() const { return overruns_; }

 private:
  void receive();
  void transmit();

  registers::Usart* port_;
  InterruptLine interrupt_;
  InterruptQueue<std::byte, 1024> to_send_;
  InterruptQueue<std::byte, 512> arrived_;
  std::uint32_t dropped_ = 0;
  volatile std::uint32_t overruns_ = 0;  ///< written by the handler alone
};

}  // namespace fantail::hal::stm32f4
