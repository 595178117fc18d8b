#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <fstream>
#include "board_in_world.hpp"
#include "fly/fly_scenario.hpp"
#include "input/scenario_file.hpp"
using namespace fantail;
int main(int argc, char** argv) {
  const board::Image image{argv[1]};
  const auto scenario = input::load_scenario(argv[2], {});
  board::BoardInWorld* one = nullptr;
  board::Pace pace;
  if (argc > 3) pace.cycles_per_instruction = atof(argv[3]);
  const clock_t begun = clock();
  int shown = 0;
  core::Phase before = core::Phase::safe;
  const auto look = [&](const core::TickRecord& r) { if (r.phase != before || shown++ % 500 == 0) { printf("%.3f phase %d reason %d rate %f sensor %d acc %d\n", double(r.time.count()) * 1e-6, int(r.phase), int(r.reason), double(r.motion.roll_rate_rad_s), int(r.motion.gyro), int(r.motion.accelerometer)); before = r.phase; } };
  const auto flight = fly::fly_scenario(scenario, {}, look, fly::Log::kept, [&](const core::FlightPlan& plan, const sim::BoardPorts& ports, const avionics::Identity&) {
    auto made = std::make_unique<board::BoardInWorld>(image, pace, plan, ports);
    one = made.get();
    return made;
  });
  printf("rows %zu log %zu armed: %s\n", flight.rows.size(), flight.log.size(), flight.why_not_armed.c_str());
  for (auto& n : flight.notes) printf("note %s\n", n.c_str());
  const auto& last = flight.rows.back();
  printf("last %f truth %f\n", last.time_s, last.truth ? last.truth->roll_angle_rad : -1);
  std::ofstream("flight.ftl", std::ios::binary).write(reinterpret_cast<const char*>(flight.log.data()), static_cast<std::streamsize>(flight.log.size()));
  printf("CPU %.2f\n", double(clock() - begun) / CLOCKS_PER_SEC);
}
