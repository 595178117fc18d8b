// SPDX-License-Identifier: MIT
// What becomes of a flight of the flashed image when one bit of its memory or of its processor flips.
//
//   board_flips IMAGE COUNT [SEED [FLIP]]
//
// COUNT flips, each in a flight of its own; FLIP: only that one of them. Two flights at a time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include "flip_table.hpp"
#include "input/scenario_file.hpp"

namespace {

using namespace fantail::board;
using fantail::core::Phase;

constexpr int workers = 2;
constexpr int progress_ms = 10'000;
constexpr std::array moments{Moment{"armed", Phase::armed, 1.0, 10},
                             Moment{"launched", Phase::launched, 0.05, 10},
                             Moment{"control + 0 s", Phase::controlling, 0.0, 14},
                             Moment{"control + 1 s", Phase::controlling, 1.0, 14},
                             Moment{"control + 2 s", Phase::controlling, 2.0, 14},
                             Moment{"control + 3 s", Phase::controlling, 3.0, 14},
                             Moment{"control + 5 s", Phase::controlling, 5.0, 14},
                             Moment{"finished", Phase::finished, 0.1, 10}};

constexpr std::array<int, moments.size()> weights() {
  std::array<int, moments.size()> all{};
  std::ranges::transform(moments, all.begin(), &Moment::weight);
  return all;
}

/// The board tells its faults once a second, 77 ms after each on its clock: what flips now is told soon.
void await_report(BoardFlight& flight) {
  using namespace std::chrono_literals;
  while (flight.record().time % 1s / 1ms != 800) {
    flight.step();
  }
}

/// One of those who work: flies, and at each moment tries its part of the flips.
void work(const Image& image, const fantail::sim::Scenario& scenario, const std::vector<Flip>& flips, int pipe) {
  BoardFlight flight{image, scenario};
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const bool begins = i == 0 || moments[i - 1].phase != moments[i].phase;
    if (begins && !flight.fly_to(moments[i].phase, 60.0)) {
      throw std::runtime_error{std::string{"the flight never came to: "} + moments[i].name};
    }
    flight.fly_for(begins ? moments[i].after_s : moments[i].after_s - moments[i - 1].after_s - 0.5);
    if (moments[i].phase == Phase::controlling || moments[i].phase == Phase::armed) {
      await_report(flight);
    }
    const MemoryMap map{image, flight.board()};
    const auto plain = fly_as_it_is(flight);
    if (!plain) {
      throw std::runtime_error{std::string{"the flight itself came to no end: "} + moments[i].name};
    }
    for (const Flip& flip : flips) {
      if (flip.moment(weights()) == i) {
        Trial trial = fly_with(flight, image, scenario.plan, map, *plain, flip);
        trial.moment = i;
        (void)!::write(pipe, &trial, sizeof trial);
      }
    }
  }
}

/// All trials, as they come from those who work.
std::vector<Trial> gather(int pipe, std::size_t wanted) {
  using Clock = std::chrono::steady_clock;
  std::vector<Trial> trials;
  const auto began = Clock::now();
  const auto passed_s = [&] { return std::chrono::duration<double>{Clock::now() - began}.count(); };
  double told_s = 0.0;
  for (;;) {
    pollfd waiting{.fd = pipe, .events = POLLIN, .revents = 0};
    if (::poll(&waiting, 1, progress_ms) > 0) {
      Trial trial;
      if (::read(pipe, &trial, sizeof trial) != sizeof trial) {
        break;
      }
      trials.push_back(trial);
    }
    if (passed_s() > told_s + 1e-3 * progress_ms) {
      told_s = passed_s();
      const double rate = static_cast<double>(trials.size()) / told_s;
      std::fprintf(stderr, "%zu of %zu flips, %.1f a second, %.0f s left\n", trials.size(), wanted, rate,
                   static_cast<double>(wanted - trials.size()) / std::max(rate, 1e-3));
    }
  }
  std::ranges::sort(trials, {}, &Trial::number);
  std::printf("%zu flips in %.0f s\n\n", trials.size(), passed_s());
  return trials;
}

int run(int argc, char** argv) {
  const Image image{argv[1]};
  const int count = std::atoi(argv[2]);
  const std::uint64_t seed = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
  std::vector<Flip> flips;
  for (int i = argc > 4 ? std::atoi(argv[4]) : 0; i < (argc > 4 ? std::atoi(argv[4]) + 1 : count); ++i) {
    flips.emplace_back(seed, i);
  }
  std::printf("seed %llu, tasha3_launch2\n", static_cast<unsigned long long>(seed));
  std::fflush(stdout);
  const auto scenario = fantail::input::load_scenario("tasha3_launch2", {});
  int ends[2]{};
  if (::pipe(ends) != 0) {
    throw std::runtime_error{"no pipe"};
  }
  std::vector<pid_t> children;
  for (int worker = 0; worker < workers; ++worker) {
    children.push_back(::fork());
    if (children.back() == 0) {
      ::close(ends[0]);
      std::vector<Flip> mine;
      std::ranges::copy_if(flips, std::back_inserter(mine),
                           [&](const Flip& flip) { return flip.number() % workers == worker; });
      try {
        work(image, scenario, mine, ends[1]);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        ::_exit(1);
      }
      ::_exit(0);
    }
  }
  ::close(ends[1]);
  const std::vector<Trial> trials = gather(ends[0], flips.size());
  for (const pid_t child : children) {
    ::waitpid(child, nullptr, 0);
  }
  std::fputs(table_of(trials, moments).c_str(), stdout);
  return trials.size() != flips.size() || std::ranges::any_of(trials, is_beyond) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("board_flips IMAGE COUNT [SEED [FLIP]]\n", stderr);
    return 2;
  }
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
