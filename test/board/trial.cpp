#include "board.hpp"
#include <cstdio>
#include <ctime>
#include <map>
using namespace fantail::board;
int main(int argc, char** argv) {
  const Image image{argv[1]};
  Board board{image, {}};
  board.imu.force_g = board.second_imu.force_g = board.accelerometer.force_g = {1, 0, 0};
  board.switch_on();
  const double end = argc > 2 ? atof(argv[2]) : 2;
  std::map<unsigned, int> frames;
  const clock_t begun = clock();
  for (int ms = 1; ms < end * 1000; ++ms) {
    board.run_until(ms * 1e-3);
    for (int i = 0; i < 4; ++i) board.encoders[i].angle = std::uint16_t(i * 3 + ms * 7) % 5;
    for (auto& f : board.take_sent()) frames[f.id]++;
  }
  printf("%s\n", board.console.c_str());
  for (auto& c : board.processor.complaints) printf("complaint %s\n", c.c_str());
  for (auto& c : board.violations()) printf("violation %s\n", c.c_str());
  for (auto& [id, n] : frames) printf("%03x %d\n", id, n);
  printf("pulses %zu restarts %zu instructions %lu CPU %.2f\n", board.chip.servo_timer.pulses().size(), board.restarts.size(), board.processor.instructions(), double(clock() - begun) / CLOCKS_PER_SEC);
}
