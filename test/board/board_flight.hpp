// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "board_in_world.hpp"
#include "hal/console.hpp"
#include "sim/scenario.hpp"
#include "sim/world.hpp"

namespace fantail::board {

[[nodiscard]] const char* name(ResetKind kind);

/// A flight of the flashed image in a simulated world, to which something may happen at any instant.
class BoardFlight {
 public:
  /// Both outlive it.
  BoardFlight(const Image& image, const sim::Scenario& scenario, const Pace& pace = {});
  /// The same from its power-up on, before anything has run: a board that `spoil` has seen need not come to its first
  /// rate.
  BoardFlight(const Image& image, const sim::Scenario& scenario, const std::function<void(Board&)>& spoil);

  /// Until the avionics is in this phase, at most so long. False when it never was.
  [[nodiscard]] bool fly_to(core::Phase phase, double at_most_s);
  /// A millisecond of world and board.
  void step();
  void fly_for(double time_s);

  [[nodiscard]] Board& board() { return in_world_->board(); }
  [[nodiscard]] const sim::World& world() const { return *world_; }
  /// Of the last tick.
  [[nodiscard]] const core::TickRecord& record() const { return *record_; }

  /// The avionics had a tick of its own in it.
  [[nodiscard]] bool had_tick() const { return in_world_->had_tick(); }
  /// The faults that the board tells on its bus, by their names.
  [[nodiscard]] std::string faults() const;
  /// All that its console has said in the world.
  [[nodiscard]] const std::string& said() const { return console_.said; }

  /// Where four servos stand that hear every pulse at the pins, cut ones too: 20 ms of lag, 600 degrees a second, a
  /// stop at 25 degrees, 10 us a degree. Without pulses they stay. The farthest from trim, and from where they would
  /// stand had they heard the whole pulses alone.
  [[nodiscard]] double servo_deg(std::size_t line) const { return servos_[line].is_deg; }
  [[nodiscard]] double most_servo_deg() const { return most_servo_deg_; }
  [[nodiscard]] double most_astray_deg() const { return most_astray_deg_; }
  void forget_most_servo() { most_servo_deg_ = most_astray_deg_ = 0.0; }

 private:
  struct Console final : hal::Console {
    std::string said;
    void write(std::string_view text) override { said += text; }
  };
  using Make = std::function<std::unique_ptr<BoardInWorld>(const core::FlightPlan& plan, const sim::BoardPorts& ports)>;
  BoardFlight(const sim::Scenario& scenario, const Make& make);
  void move_servos();

  Console console_;
  BoardInWorld* in_world_ = nullptr;  ///< of world_
  std::unique_ptr<sim::World> world_;
  const core::TickRecord* record_ = nullptr;
  std::size_t heard_ = 0;
  struct Servo {
    double told_deg = 0.0;
    double is_deg = 0.0;
    void pass_tick();
  };
  std::array<Servo, hal::canards> servos_{};
  std::array<Servo, hal::canards> deaf_to_cut_{};
  double most_servo_deg_ = 0.0;
  double most_astray_deg_ = 0.0;
};

/// What happened to it, and what it did then.
struct Aftermath {
  bool is_there = false;  ///< false: the process that found out came to no end
  std::array<char, 24> event{};
  double at_ms = 0.0;              ///< within the frame of the servos
  std::array<char, 24> restart{};  ///< kind of the last reset that followed; empty: none
  int restarts = 0;
  double boot_ms = 0.0;  ///< from the last reset to the first pulse behind it
  int cut_pulses = 0;
  double silence_ms = 0.0;    ///< the longest without a pulse on line 1
  double narrowest_us = 0.0;  ///< of whole pulses
  double widest_us = 0.0;
  double most_servo_deg = 0.0;
  double most_astray_deg = 0.0;
  double control_after_ms = -1.0;  ///< from the event to the first tick under control behind a reset; below 0: none
  int phase = 0;                   ///< at the end
  int command_status = 0;
  std::array<char, 160> named{};  ///< the faults that the board tells at the end
};

/// In a process of its own, which has the flight as it is now: lets `event` happen after `delay_s`, flies on for
/// `time_s`, and tells. The flight of this process stays as it is.
[[nodiscard]] Aftermath what_if(BoardFlight& flight, const std::string& name, double delay_s, double time_s,
                                const std::function<void(Board&)>& event);

}  // namespace fantail::board
