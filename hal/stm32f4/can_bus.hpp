// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <span>

#include "hal/board.hpp"
#include "hal/can_bus.hpp"
#include "hal/stm32f4/interrupt_line.hpp"
#include "hal/stm32f4/interrupt_queue.hpp"
#include "hal/stm32f4/pin.hpp"
#include "hal/stm32f4/registers/can.hpp"

namespace fantail::hal::stm32f4 {

/// The bxCAN controller at 1 Mbit/s, behind a transceiver with a silent pin.
///
/// Frames leave in the order in which they were sent (TXFP): two of one identifier never overtake each other, which
/// they could by priority, because of equal identifiers the lower mailbox goes first. The price is that a frame waits
/// for what this node has sent before it, at most 66 frames or 9 ms; against other nodes its identifier counts.
///
/// A frame that nobody acknowledges is repeated by the controller until it is. Alone on the bus the controller is soon
/// error passive, and the mailboxes and the queue fill. When the queue is full then, all of it is thrown away and
/// counted as unsent: whoever appears on the bus hears nothing that is older than one queue. So it goes when the
/// controller leaves the bus (bus-off); it comes back by itself after 128 times 11 recessive bits (ABOM).
///
/// send() and receive() belong to the control loop, the three on_...() to the interrupts CAN1_TX, CAN1_RX0 and
/// CAN1_SCE, which must have one and the same priority. None of them waits.
class CanBus final : public hal::CanBus {
 public:
  static constexpr std::uint32_t transmit_queue = 64;
  static constexpr std::uint32_t receive_queue = 32;
  static constexpr std::size_t most_identifiers = 56;  ///< 14 filters of four, the half that CAN1 has after a reset

  /// `silent`: high keeps the transceiver off the bus. `transmit_interrupt`: CAN1_TX. Clock and pins are on already.
  CanBus(registers::Can& can, Pin silent, InterruptLine transmit_interrupt)
      : can_{can}, silent_{silent}, transmit_interrupt_{transmit_interrupt} {}
  CanBus(const CanBus&) = delete;  // the handlers know it
  CanBus& operator=(const CanBus&) = delete;

  /// Joins the bus; waits, within a bound. From then on only data frames with these 11-bit identifiers are heard (none:
  /// nothing is). A fault: 1 Mbit/s cannot be made of this clock, or the controller does not answer, or it found no 11
  /// recessive bits in a row, which a bus that is stuck does not have. In the last case it goes on looking for them.
  [[nodiscard, gnu::cold]] std::optional<BoardFault> start(std::uint32_t apb1_hz,
                                                           std::span<const std::uint16_t> identifiers);

  bool send(const CanFrame& frame) override;
  std::optional<CanFrame> receive() override;
  [[nodiscard]] CanState state() const override;
  /// `sent` are the frames that another node has acknowledged. `overrun` counts a loss in the controller as one frame,
  /// however many it was; `errors` one for each call of receive() when there are more.
  [[nodiscard]] CanCounters counters() const override;
  /// How often the controller has left the bus since power-up.
  [[nodiscard]] std::uint32_t times_bus_off() const { return times_bus_off_.load(std::memory_order_relaxed); }

  void on_transmit_interrupt();
  void on_receive_interrupt();
  void on_error_interrupt();

 private:
  using Count = std::atomic<std::uint32_t>;

  [[gnu::cold]] void set_filters(std::span<const std::uint16_t> identifiers);
  void count_finished_mailboxes(std::uint32_t status);
  void give_up();
  void fill_mailboxes(std::uint32_t status);

  registers::Can& can_;
  Pin silent_;
  InterruptLine transmit_interrupt_;
  bool answers_ = false;
  InterruptQueue<CanFrame, transmit_queue> to_send_;
  InterruptQueue<CanFrame, receive_queue> received_;
  std::atomic<bool> nobody_hears_{false};  ///< the loop asks the transmit handler to give up

  bool off_ = false;  ///< the handlers': bus-off, and counted

  // Each is written by one side only.
  std::uint32_t handed_out_ = 0;
  std::uint32_t refused_ = 0;
  Count sent_{0};
  Count given_up_{0};
  Count overrun_{0};
  Count errors_{0};
  Count times_bus_off_{0};
};
static_assert(sizeof(CanBus) <= 2048);

}  // namespace fantail::hal::stm32f4
