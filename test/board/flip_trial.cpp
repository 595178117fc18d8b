// SPDX-License-Identifier: MIT
#include "flip_trial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numbers>
#include <optional>
#include <string>

#include "in_fork.hpp"

namespace fantail::board {
namespace {

constexpr std::size_t shortest_ticks = 450;  ///< the watchdog's 50 ms, a boot, and the bus that tells of both
constexpr std::size_t standing_ticks = 100;  ///< without one for so long, nobody will come
constexpr unsigned most_seconds = 60;        ///< of this program, for one flip
constexpr float same_us = 0.05F;
constexpr float same_s = 2e-6F;

template <std::size_t n>
void put(const std::string& text, std::array<char, n>& place) {
  std::strncpy(place.data(), text.c_str(), n - 1);
}

/// Writes down what a flight shows.
class Diarist {
 public:
  explicit Diarist(BoardFlight& flight)
      : flight_{flight}, begin_s_{flight.board().now_s()}, seen_{flight.board().chip.pulses().size()} {}

  void step(Course& course) {
    flight_.step();
    const std::vector<HeardPulse>& pulses = flight_.board().chip.pulses();
    for (; seen_ < pulses.size() && heard_ < Course::most_pulses; ++seen_) {
      course.pulses[heard_++] = {.line = static_cast<std::uint8_t>(pulses[seen_].line),
                                 .begin_s = static_cast<float>(pulses[seen_].begin_s - begin_s_),
                                 .width_us = static_cast<float>(pulses[seen_].width_us)};
    }
    course.phases[course.ticks] = static_cast<std::uint8_t>(flight_.record().phase);
    course.roll_deg[course.ticks] =
        static_cast<float>(flight_.world().truth().roll_angle_rad * 180.0 / std::numbers::pi);
    course.heard_by[course.ticks++] = static_cast<std::uint16_t>(heard_);
  }

 private:
  BoardFlight& flight_;
  double begin_s_;
  std::size_t seen_;
  std::size_t heard_ = 0;
};

bool same_pulses(const Course& course, const Course& plain) {
  const std::size_t heard = course.heard_by[course.ticks - 1];
  return heard == plain.heard_by[course.ticks - 1] &&
         std::equal(course.pulses.begin(), course.pulses.begin() + static_cast<std::ptrdiff_t>(heard),
                    plain.pulses.begin(), [](const Course::Heard& a, const Course::Heard& b) {
                      return a.line == b.line && std::abs(a.begin_s - b.begin_s) < same_s &&
                             std::abs(a.width_us - b.width_us) < same_us;
                    });
}

bool is_fault(core::PhaseReason reason) {
  using enum core::PhaseReason;
  return reason == gyro_failed || reason == timing_fault || reason == canard_fault || reason == memory_fault ||
         reason == gyro_failed_before_control || reason == timing_fault_before_control || reason == aborted;
}

class Flying {
 public:
  Flying(BoardFlight& flight, const Image& image, const MemoryMap& map, const Course& plain, const Flip& flip)
      : flight_{flight}, image_{image}, map_{map}, plain_{plain}, flip_{flip} {}

  Trial fly(const core::FlightPlan& plan) {
    Board& board = flight_.board();
    const double event_s = board.now_s() + flip_.delay_s();
    PinWatch watch{flight_, plan, event_s};
    Diarist diarist{flight_};
    arrange(event_s);
    while (course_.ticks < shortest_ticks || (is_other() && !is_named() && course_.ticks < Course::most_ticks)) {
      diarist.step(course_);
      watch.follow();
      without_tick_ = flight_.had_tick() ? 0 : without_tick_ + 1;
      if (!ended_by_ && flight_.record().phase == core::Phase::finished && board.restarts.size() == restarts_before_) {
        ended_by_ = flight_.record().reason;
      }
      trial_.silence_ms = std::max(trial_.silence_ms, static_cast<float>(without_tick_));
      trial_.roll_error_deg = std::max(
          trial_.roll_error_deg, std::abs(course_.roll_deg[course_.ticks - 1] - plain_.roll_deg[course_.ticks - 1]));
    }
    trial_.pins = watch.pins();
    trial_.outcome = outcome();
    if (!board.processor.complaints.empty()) {
      put(board.processor.complaints.back().what, trial_.complaint);
    }
    if (board.restarts.size() != restarts_before_) {
      put(board::name(board.restarts.back().kind), trial_.restart);
    }
    put(is_named()           ? flight_.faults()
        : !is_in_its_phase() ? std::string{core::name(flight_.record().reason)}
                             : std::string{},
        trial_.named);
    return trial_;
  }

 private:
  // Where the processor is can be seen when it has been left: stopped once, and looked at two blocks later.
  void arrange(double event_s) {
    Board& board = flight_.board();
    event_ = board.timeline.add([this, &board] {
      if (++calls_ < 3) {
        board.processor.stop();
        board.timeline.schedule_at_counts(event_, board.timeline.counts() + 1);
        return;
      }
      trial_.pc = board.processor.program_counter();
      const std::string place = flip_.happen(board, map_);
      put(place, trial_.place);
      put(image_.where(!is_memory(flip_.region()) ? trial_.pc
                                                  : static_cast<std::uint32_t>(std::stoul(place, nullptr, 16))),
          trial_.symbol);
    });
    board.timeline.schedule(event_, event_s);
  }

  [[nodiscard]] bool is_named() const { return flight_.faults() != faults_before_; }
  [[nodiscard]] bool is_other() const {
    return flight_.board().restarts.size() != restarts_before_ || !same_pulses(course_, plain_) ||
           course_.phases[course_.ticks - 1] != plain_.phases[course_.ticks - 1];
  }

  // A flight that a reset held up comes a little later into its next phase.
  [[nodiscard]] bool is_in_its_phase() const {
    const auto plain = static_cast<core::Phase>(plain_.phases[course_.ticks - 1]);
    const core::Phase phase = flight_.record().phase;
    return phase == plain || (core::is_flight(phase) && core::is_flight(plain));
  }

  [[nodiscard]] Outcome outcome() const {
    const Board& board = flight_.board();
    if (without_tick_ > standing_ticks) {
      return Outcome::stands;
    }
    if (board.restarts.size() != restarts_before_) {
      return ended_by_ && is_fault(*ended_by_) ? Outcome::ended_for_fault  // and what is over need not go on
             : is_in_its_phase()
                 ? board.restarts.back().kind == ResetKind::watchdog ? Outcome::watchdog : Outcome::crashed
             : flight_.record().phase == core::Phase::safe ? Outcome::safe
                                                           : Outcome::ended_for_fault;
    }
    if (!is_in_its_phase()) {
      return is_fault(flight_.record().reason) || is_named() ? Outcome::ended_for_fault : Outcome::ended_for_flight;
    }
    return is_named() ? Outcome::named : is_other() ? Outcome::unnamed : Outcome::nothing;
  }

  BoardFlight& flight_;
  const Image& image_;
  const MemoryMap& map_;
  const Course& plain_;
  const Flip& flip_;
  std::string faults_before_ = flight_.faults();
  std::size_t restarts_before_ = flight_.board().restarts.size();
  Timeline::Event event_ = 0;
  int calls_ = 0;
  std::size_t without_tick_ = 0;
  std::optional<core::PhaseReason> ended_by_;  ///< before any reset
  Course course_;
  Trial trial_;
};

}  // namespace

const char* name(Outcome outcome) {
  switch (outcome) {
    case Outcome::nothing: return "nothing seen";
    case Outcome::unnamed: return "other pulses, no fault named";
    case Outcome::named: return "flew on, fault named";
    case Outcome::crashed: return "crashed and resumed";
    case Outcome::watchdog: return "watchdog and resumed";
    case Outcome::ended_for_fault: return "phase ended, fault named";
    case Outcome::ended_for_flight: return "other phase, no fault named";
    case Outcome::safe: return "reset, then Safe";
    case Outcome::stands: return "no ticks and no reset";
    case Outcome::no_end: return "emulator came to no end";
  }
  return "?";
}

std::optional<Course> fly_as_it_is(BoardFlight& flight) {
  return in_fork<Course>(most_seconds, [&] {
    Course course;
    for (Diarist diarist{flight}; course.ticks < Course::most_ticks;) {
      diarist.step(course);
    }
    return course;
  });
}

Trial fly_with(BoardFlight& flight, const Image& image, const core::FlightPlan& plan, const MemoryMap& map,
               const Course& plain, const Flip& flip, bool aloud) {
  const auto found = in_fork<Trial>(most_seconds, [&] {
    const std::size_t said = flight.said().size();
    const Trial flown = Flying{flight, image, map, plain, flip}.fly(plan);
    if (aloud) {
      std::fputs(flight.said().c_str() + said, stderr);
    }
    return flown;
  });
  Trial trial = found.value_or(Trial{});
  trial.number = flip.number();
  trial.region = flip.region();
  trial.region_bytes = map.bytes(flip.region());
  return trial;
}

}  // namespace fantail::board
