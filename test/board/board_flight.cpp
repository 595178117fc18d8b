// SPDX-License-Identifier: MIT
#include "board_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "in_fork.hpp"

namespace fantail::board {
namespace {

constexpr double tick_s = 1e-3;
constexpr double centre_us = 1500.0;
constexpr double us_per_deg = 10.0;
constexpr double lag_s = 0.020;
constexpr double rate_deg_s = 600.0;
constexpr double stop_deg = 25.0;

template <std::size_t n>
void put(const std::string& text, std::array<char, n>& place) {
  std::strncpy(place.data(), text.c_str(), n - 1);
}

}  // namespace

const char* name(ResetKind kind) {
  switch (kind) {
    case ResetKind::power_on: return "power on";
    case ResetKind::brown_out: return "brown-out";
    case ResetKind::pin: return "pin";
    case ResetKind::software: return "software";
    case ResetKind::watchdog: return "watchdog";
  }
  return "?";
}

BoardFlight::BoardFlight(const Image& image, const sim::Scenario& scenario, const Pace& pace)
    : BoardFlight{scenario, [&](const core::FlightPlan& plan, const sim::BoardPorts& ports) {
                    return std::make_unique<BoardInWorld>(image, pace, plan, ports);
                  }} {}

BoardFlight::BoardFlight(const Image& image, const sim::Scenario& scenario, const std::function<void(Board&)>& spoil)
    : BoardFlight{scenario, [&](const core::FlightPlan& plan, const sim::BoardPorts& ports) {
                    auto made = std::make_unique<BoardInWorld>(image, Pace{}, flash_with(plan), ports);
                    spoil(made->board());
                    return made;
                  }} {}

BoardFlight::BoardFlight(const sim::Scenario& scenario, const Make& make)
    : world_{std::make_unique<sim::World>(
          scenario, sim::World::large_flash,
          [&](const core::FlightPlan& plan, const sim::BoardPorts& ports, const avionics::Identity& /*identity*/) {
            auto made = make(
                plan, {.can_bus = ports.can_bus, .flash = ports.flash, .console = console_, .entropy = ports.entropy});
            in_world_ = made.get();
            return made;
          })} {
  step();
}

bool BoardFlight::fly_to(core::Phase phase, double at_most_s) {
  for (double flown_s = 0.0; record().phase != phase; flown_s += tick_s) {
    if (flown_s > at_most_s) {
      return false;
    }
    step();
  }
  return true;
}

void BoardFlight::step() {
  record_ = &world_->tick();
  move_servos();
  world_->advance();
}

void BoardFlight::fly_for(double time_s) {
  for (double flown_s = 0.0; flown_s < time_s - 0.5 * tick_s; flown_s += tick_s) {
    step();
  }
}

std::string BoardFlight::faults() const {
  std::string text;
  for (std::size_t i = 0; in_world_->report() && i < hal::board_faults; ++i) {
    if ((in_world_->report()->faults >> i & 1U) != 0) {
      text += (text.empty() ? "" : " ") + std::string{hal::name(static_cast<hal::BoardFault>(i))};
    }
  }
  return text;
}

void BoardFlight::Servo::pass_tick() {
  const double most = rate_deg_s * tick_s;
  const double wanted = (told_deg - is_deg) * (1.0 - std::exp(-tick_s / lag_s));
  is_deg = std::clamp(is_deg + std::clamp(wanted, -most, most), -stop_deg, stop_deg);
}

void BoardFlight::move_servos() {
  const std::vector<HeardPulse>& pulses = board().chip.pulses();
  for (; heard_ < pulses.size(); ++heard_) {
    const HeardPulse& pulse = pulses[heard_];
    servos_[pulse.line].told_deg = (pulse.width_us - centre_us) / us_per_deg;
    if (pulse.whole) {
      deaf_to_cut_[pulse.line].told_deg = servos_[pulse.line].told_deg;
    }
  }
  for (std::size_t i = 0; i < hal::canards; ++i) {
    servos_[i].pass_tick();
    deaf_to_cut_[i].pass_tick();
    most_servo_deg_ = std::max(most_servo_deg_, std::abs(servos_[i].is_deg));
    most_astray_deg_ = std::max(most_astray_deg_, std::abs(servos_[i].is_deg - deaf_to_cut_[i].is_deg));
  }
}

namespace {

void look_at_pulses(const Board& board, double event_s, double end_s, Aftermath& after) {
  const double restart_s = board.restarts.size() > 1 ? board.restarts.back().time_s : 0.0;
  double last_end_s = event_s;
  after.narrowest_us = 1e9;
  for (const HeardPulse& pulse : board.chip.pulses()) {
    if (pulse.end_s() < event_s - 1e-6) {  // one that the event itself cuts off ends with it
      continue;
    }
    const double begin_s = pulse.begin_s;
    after.cut_pulses += pulse.whole ? 0 : 1;
    if (pulse.whole && begin_s >= event_s) {
      after.narrowest_us = std::min(after.narrowest_us, pulse.width_us);
      after.widest_us = std::max(after.widest_us, pulse.width_us);
    }
    if (pulse.line == 0 && begin_s >= event_s) {
      after.silence_ms = std::max(after.silence_ms, 1e3 * (begin_s - last_end_s));
      last_end_s = pulse.end_s();
      if (restart_s >= event_s && begin_s > restart_s && after.boot_ms == 0.0) {
        after.boot_ms = 1e3 * (begin_s - restart_s);
      }
    }
  }
  after.silence_ms = std::max(after.silence_ms, 1e3 * (end_s - last_end_s));
}

Aftermath find_out(BoardFlight& flight, const std::string& name_of_event, double delay_s, double time_s,
                   const std::function<void(Board&)>& event) {
  Board& board = flight.board();
  Aftermath after;
  put(name_of_event, after.event);
  after.at_ms = 1e3 * delay_s;
  const std::size_t restarts = board.restarts.size();
  flight.forget_most_servo();
  const double event_s = board.now_s() + delay_s;
  const auto happening = board.timeline.add([&] { event(board); });
  board.timeline.schedule(happening, event_s);
  for (double flown_s = 0.0; flown_s < time_s; flown_s += tick_s) {
    flight.step();
    const bool again = board.restarts.size() > restarts && board.now_s() > board.restarts.back().time_s + 2e-3;
    if (after.control_after_ms < 0.0 && again && flight.record().phase == core::Phase::controlling &&
        flight.had_tick()) {
      after.control_after_ms = 1e3 * (board.now_s() - event_s);
    }
  }
  after.restarts = static_cast<int>(board.restarts.size() - restarts);
  if (after.restarts > 0) {
    put(name(board.restarts.back().kind), after.restart);
  }
  look_at_pulses(board, event_s, board.now_s(), after);
  after.most_servo_deg = flight.most_servo_deg();
  after.most_astray_deg = flight.most_astray_deg();
  after.phase = static_cast<int>(flight.record().phase);
  after.command_status = static_cast<int>(flight.record().command_status);
  put(flight.faults(), after.named);
  after.is_there = true;
  return after;
}

}  // namespace

Aftermath what_if(BoardFlight& flight, const std::string& name, double delay_s, double time_s,
                  const std::function<void(Board&)>& event) {
  const auto found = in_fork<Aftermath>(60, [&] { return find_out(flight, name, delay_s, time_s, event); });
  Aftermath after = found.value_or(Aftermath{});
  put(name, after.event);
  return after;
}

}  // namespace fantail::board
