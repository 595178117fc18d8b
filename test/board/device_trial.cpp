// SPDX-License-Identifier: MIT
#include "device_trial.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "in_fork.hpp"
#include "replies/sentence.hpp"

namespace fantail::board {
namespace {

constexpr unsigned most_seconds = 120;  ///< of this program
constexpr double arm_s = 3.0;           ///< after power-up: the IMU has tested itself, and the board was at rest
constexpr double most_pad_s = 20.0;
constexpr double watched_s = 1.5;  ///< on after the arming: the board tells its faults once a second

template <std::size_t n>
void put(const std::string& text, std::array<char, n>& place) {
  std::strncpy(place.data(), text.c_str(), n - 1);
}

double roll_deg(const BoardFlight& flight) { return flight.world().truth().roll_angle_rad * 180.0 / std::numbers::pi; }

/// Who told of a fault since it began: the bus, the console, and what a record has beside them.
class Names {
 public:
  explicit Names(const BoardFlight& flight) : flight_{flight}, said_before_{flight.said().size()} {}

  /// After each step: a verdict may be taken back.
  void note_record() {
    const core::TickRecord& record = flight_.record();
    for (std::size_t i = 0; i < record.verdicts.size(); ++i) {
      if (record.verdicts[i] != core::CanardVerdict::healthy) {
        add(fmt::format("canard_{}_{}", i + 1, core::name(record.verdicts[i])));
      }
    }
    if (record.gyro_vote && *record.gyro_vote != core::GyroVote::both) {
      add(fmt::format("gyro_vote_{}", core::name(*record.gyro_vote)));
    }
    const auto barometer = record.barometer_state.value_or(core::BarometerState::used);
    if (barometer == core::BarometerState::silent || barometer == core::BarometerState::disagrees) {
      add(fmt::format("barometer_{}", core::name(barometer)));
    }
  }

  /// At the end.
  [[nodiscard]] std::string all() {
    const std::string_view said = std::string_view{flight_.said()}.substr(said_before_);
    const std::string on_bus = ' ' + flight_.faults() + ' ';
    for (std::size_t i = 0; i < hal::board_faults; ++i) {
      const std::string name = ' ' + std::string{hal::name(static_cast<hal::BoardFault>(i))};  // one ends another
      if (said.find(name) != std::string_view::npos || on_bus.find(name + ' ') != std::string::npos) {
        add(name.substr(1));
      }
    }
    if (said.find("flash: does not answer") != std::string_view::npos) {
      add("flash_failed");
    }
    return fmt::format("{}", fmt::join(names_, " "));
  }

 private:
  void add(const std::string& name) {
    if (std::ranges::find(names_, name) == names_.end()) {
      names_.push_back(name);
    }
  }

  const BoardFlight& flight_;
  std::size_t said_before_;
  std::vector<std::string> names_;
};

void note_end(BoardFlight& flight, const TickMeter& meter, Names& names, DeviceTrial& trial) {
  trial.came_to_an_end = true;
  trial.phase = flight.record().phase;
  trial.reason = flight.record().reason;
  trial.longest_tick_us = 1e6 * meter.longest_s();
  put(names.all(), trial.named);
  if (const auto& complaints = flight.board().processor.complaints; !complaints.empty()) {
    put(complaints.back().what, trial.complaint);
  }
}

DeviceTrial boot(const Image& image, sim::Scenario scenario, const DeviceFault& fault) {
  scenario.arm_time_s = arm_s;
  scenario.pad_time_s = 2.0 * most_pad_s;
  std::optional<BoardWires> wires;
  std::optional<TickMeter> meter;
  BoardFlight flight{image, scenario, [&](Board& board) {
                       wires.emplace(board);
                       meter.emplace(image, board);
                       fault.begin(board, *wires);
                     }};
  DeviceTrial trial;
  PinWatch watch{flight, scenario.plan, 0.0};
  Names names{flight};
  double left_s = most_pad_s;
  for (bool answered = false; left_s > 0.0; left_s -= 1e-3) {
    if (fault.go_on) {
      fault.go_on(flight.board());
    }
    flight.step();
    watch.follow();
    names.note_record();
    const bool has_answer = flight.record().phase != core::Phase::safe || flight.world().refusal_to_arm();
    left_s = has_answer && !answered ? watched_s : left_s;
    answered = answered || has_answer;
  }
  note_end(flight, *meter, names, trial);
  trial.pins = watch.pins();
  trial.restarts = static_cast<int>(flight.board().restarts.size()) - 1;
  trial.ticks_missing = static_cast<int>(flight.record().overruns);
  if (const auto reply = flight.world().refusal_to_arm()) {
    put(reply->failure != protocol::SelfTestFailure::none ? replies::sentence(reply->failure, reply->canard)
                                                          : replies::sentence(reply->refusal),
        trial.refusal);
  } else if (meter->ticks() == 0) {
    put("no tick ever", trial.refusal);
  }
  return trial;
}

DeviceTrial fly(ControlledFlight& flown, const DeviceFault& fault) {
  BoardFlight& flight = flown.flight;
  DeviceTrial trial;
  PinWatch watch{flight, flown.scenario.plan, flight.board().now_s()};
  flown.meter.forget();
  Names names{flight};
  const std::size_t restarts = flight.board().restarts.size();
  const std::uint32_t missed = flight.record().overruns;
  if (fault.in_flight) {
    fault.in_flight(flight.board());
  } else {
    fault.begin(flight.board(), flown.wires);
  }
  for (const float plain_deg : flown.roll_deg) {
    if (fault.go_on) {
      fault.go_on(flight.board());
    }
    flight.step();
    watch.follow();
    names.note_record();
    trial.roll_deg = std::max(trial.roll_deg, std::abs(roll_deg(flight) - double{plain_deg}));
  }
  note_end(flight, flown.meter, names, trial);
  trial.restarts = static_cast<int>(flight.board().restarts.size() - restarts);
  trial.ticks_missing = trial.restarts > 0 ? 0 : static_cast<int>(flight.record().overruns - missed);
  trial.pins = watch.pins();
  return trial;
}

}  // namespace

DeviceTrial boot_with(const Image& image, const sim::Scenario& scenario, const DeviceFault& fault) {
  return in_fork<DeviceTrial>(most_seconds, [&] { return boot(image, scenario, fault); }).value_or(DeviceTrial{});
}

ControlledFlight::ControlledFlight(const Image& image, const sim::Scenario& flown)
    : scenario{flown}, flight{image, flown}, meter{image, flight.board()}, wires{flight.board()} {
  if (!flight.fly_to(core::Phase::controlling, 60.0)) {
    throw std::runtime_error{"the flight did not come under control"};
  }
  flight.fly_for(0.5);
  using Rolls = std::array<float, 1500>;
  roll_deg = in_fork<Rolls>(most_seconds, [this] {
               Rolls rolls{};
               for (float& roll : rolls) {
                 flight.step();
                 roll = static_cast<float>(board::roll_deg(flight));
               }
               return rolls;
             }).value_or(Rolls{});
}

DeviceTrial fly_with(ControlledFlight& flown, const DeviceFault& fault) {
  return in_fork<DeviceTrial>(most_seconds, [&] { return fly(flown, fault); }).value_or(DeviceTrial{});
}

}  // namespace fantail::board
