#include <cstdio>

#include "board_flight.hpp"
#include "input/scenario_file.hpp"
using namespace fantail::board;
int main(int argc, char** argv) {
  const Image image{argv[1]};
  BoardFlight flight{image, fantail::input::load_scenario("tasha3_launch2", {})};
  if (!flight.fly_to(fantail::core::Phase::controlling, 60.0)) return 1;
  flight.fly_for(0.5);
  Board& board = flight.board();
  const double at = board.now_s();
  double reset_s = at;
  for (int i = 2; i < argc; ++i) {
    const auto a = image.address_of(argv[i]);
    if (!a) {
      printf("no %s\n", argv[i]);
      continue;
    }
    board.processor.on_return_of(*a, [&, i](std::uint32_t) {
      if (board.now_s() - reset_s < 0.03) printf("%8.3f ms %s\n", 1e3 * (board.now_s() - reset_s), argv[i]);
    });
  }
  board.reset(ResetKind::software);
  if (argc > 100) return 0;
  flight.step();
  reset_s = board.restarts.back().time_s;
  for (int i = 0; i < 25; ++i) flight.step();
  for (auto& p : board.chip.pulses())
    if (p.begin_s > reset_s && p.begin_s < reset_s + 0.025)
      printf("pulse %zu %.3f ms %.1f %d\n", p.line, 1e3 * (p.begin_s - reset_s), p.width_us, p.whole);
}
