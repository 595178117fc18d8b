// SPDX-License-Identifier: MIT
// What becomes of a flight of the flashed image when one bit of its memory or of its processor flips.
//
//   board_flips IMAGE COUNT [SEED [FLIP]]
//
// COUNT flips, each in a flight of its own; FLIP: only that one of them, and what the console says then. Two flights at
// a time.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "flip_table.hpp"
#include "input/scenario_file.hpp"
#include "program.hpp"
#include "two_workers.hpp"

namespace {

using namespace fantail::board;
using fantail::core::Phase;

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
void work(const Image& image, const fantail::sim::Scenario& scenario, const std::vector<Flip>& flips, bool aloud,
          const std::function<void(const Trial&)>& tell) {
  if (flips.empty()) {
    return;
  }
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
    if (std::ranges::none_of(flips, [i](const Flip& flip) { return flip.moment(weights()) == i; })) {
      continue;
    }
    const MemoryMap map{image, flight.board()};
    const auto plain = fly_as_it_is(flight);
    if (!plain) {
      throw std::runtime_error{std::string{"the flight itself came to no end: "} + moments[i].name};
    }
    for (const Flip& flip : flips) {
      if (flip.moment(weights()) == i) {
        Trial trial = fly_with(flight, image, scenario.plan, map, *plain, flip, aloud);
        trial.moment = i;
        tell(trial);
      }
    }
  }
}

int run(int argc, char** argv) {
  const Image image{argv[1]};
  const auto seed = static_cast<std::uint64_t>(argc > 3 ? whole_word(argv[3], "SEED", 0) : 1);
  const int count = whole_word(argv[2], "COUNT", 1);
  const bool only_one = argc > 4;
  const int begin = only_one ? whole_word(argv[4], "FLIP", 0) : 0;
  const int end = only_one ? begin + 1 : count;
  std::vector<Flip> flips;
  for (int i = begin; i < end; ++i) {
    flips.emplace_back(seed, i);
  }
  std::printf("seed %llu, tasha3_launch2\n", static_cast<unsigned long long>(seed));
  std::fflush(stdout);
  const auto scenario = fantail::input::load_scenario("tasha3_launch2", {});
  const auto began = std::chrono::steady_clock::now();
  std::vector<Trial> trials =
      by_two_workers<Trial>(flips.size(), "flips", [&](int worker, const std::function<void(const Trial&)>& tell) {
        std::vector<Flip> mine;
        std::ranges::copy_if(flips, std::back_inserter(mine),
                             [&](const Flip& flip) { return flip.number() % workers == worker; });
        work(image, scenario, mine, only_one, tell);
      });
  std::ranges::sort(trials, {}, &Trial::number);
  std::printf("%zu flips in %.0f s\n\n", trials.size(),
              std::chrono::duration<double>{std::chrono::steady_clock::now() - began}.count());
  std::fputs(table_of(trials, moments).c_str(), stdout);
  return trials.size() != flips.size() || std::ranges::any_of(trials, is_beyond) ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(argc, argv, 2, 4, "board_flips IMAGE COUNT [SEED [FLIP]]", [&] { return run(argc, argv); });
}
