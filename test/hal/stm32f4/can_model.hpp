// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "hal/can_bus.hpp"
#include "hal/stm32f4/registers/can.hpp"
#include "register_world.hpp"

namespace fantail::hal::stm32f4::test {

/// A bxCAN behind its registers, and the bus it is on (RM0090 sections 32.4 to 32.9). The tests say what happens on the
/// bus, slot by slot; the handlers are called when their interrupts are due, as the processor does.
class CanModel {
 public:
  CanModel(RegisterWorld& world, registers::Can& can);

  /// What the processor does at each of its three interrupts. Without them somebody asks for the lines.
  struct Handlers {
    std::function<void()> transmit{};
    std::function<void()> receive{};
    std::function<void()> error{};
  };
  /// They are called from now on, that of sending also when it is set pending.
  void connect(Handlers handlers, registers::Register& set_pending);

  // ---- the bus ----

  /// One frame's time on the bus: the controller sends what it has to send next. True when a frame went through.
  bool slot();
  /// Slots until there is nothing left to send, or this many.
  void run(int slots);
  /// Another node sends. True when it came into the FIFO or was lost there, false when no filter lets it through.
  bool arrive(const CanFrame& frame);
  /// An error frame that this controller saw but had no part in; `code` as in LEC.
  void disturb(std::uint32_t code);
  /// TEC has passed 255.
  void go_bus_off();
  /// So many times 11 recessive bits.
  void recessive(int sequences);
  void set_errors(std::uint32_t transmit, std::uint32_t receive);

  bool dead = false;             ///< never answers a request
  bool stuck_bus = false;        ///< never recessive
  bool heard = true;             ///< somebody acknowledges
  std::vector<CanFrame> wire{};  ///< what this controller has sent

  // ---- what the driver did ----

  /// Writes that a real controller ignores or that spoil something: each is a mistake of the driver.
  int mistakes = 0;
  int interrupts = 0;
  [[nodiscard]] std::uint32_t btr() const { return btr_; }
  [[nodiscard]] std::uint32_t mcr() const { return mcr_; }
  [[nodiscard]] int pending_mailboxes() const;

  /// Called at each read of a status register, in handlers too: what happens just then.
  std::function<void()> meanwhile{};
  /// While true no handler is called; they are when it has become false and serve() is called.
  bool masked = false;
  void serve();
  /// The levels of its three interrupt lines.
  [[nodiscard]] bool transmit_line() const;
  [[nodiscard]] bool receive_line() const;
  [[nodiscard]] bool error_line() const;

 private:
  struct Mailbox {
    bool pending = false;
    bool abort = false;
    std::uint64_t order = 0;
    std::uint32_t flags = 0;  ///< RQCP and TXOK
    std::uint32_t identifier = 0;
  };

  void install_control();
  void install_mailboxes();
  void install_fifo();
  void install_filters();
  [[nodiscard]] std::uint32_t tsr() const;
  void write_tsr(std::uint32_t value);
  void request(std::size_t mailbox, std::uint32_t identifier);
  void finish(std::size_t mailbox, bool sent);
  [[nodiscard]] std::optional<std::size_t> next_mailbox() const;
  [[nodiscard]] bool passes(const CanFrame& frame) const;
  [[nodiscard]] CanFrame frame_of(std::size_t mailbox) const;
  void show_oldest();
  [[nodiscard]] std::uint32_t esr() const;
  void happen();
  [[nodiscard]] bool on_bus() const { return !inak_ && !boff_; }

  RegisterWorld& world_;
  registers::Can& can_;
  std::optional<Handlers> handlers_;
  bool serving_ = false;
  bool happening_ = false;
  bool pended_ = false;

  std::uint32_t mcr_ = 0x0001'0002;
  std::uint32_t btr_ = 0x0123'0000;
  bool inak_ = false;
  int reads_to_inak_ = 0;
  bool erri_ = false;
  std::uint32_t ier_ = 0;
  bool boff_ = false;
  std::uint32_t lec_ = 0;
  std::uint32_t tec_ = 0;
  std::uint32_t rec_ = 0;
  int sequences_ = 0;
  std::array<Mailbox, 3> mailboxes_{};
  std::uint64_t requests_ = 0;
  std::deque<CanFrame> fifo_{};
  bool fovr_ = false;
  int reads_to_release_ = 0;
  bool finit_ = true;
  std::uint32_t active_ = 0;
};

}  // namespace fantail::hal::stm32f4::test
