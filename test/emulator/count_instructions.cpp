// SPDX-License-Identifier: MIT
// Usage: count_instructions [COUNTS.txt [--write]]
// Counts the instructions of every tick and of the flight law in it, on the emulated processor, prints them, and
// compares them with a file (exit code 1 beyond 2 %) or writes that file. Exit code 77: there is no image.
#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "emulator/images.hpp"
#include "input/scenario_file.hpp"
#include "sil/bench_at_world.hpp"
#include "sim/world.hpp"

namespace fantail::test {
namespace {

constexpr double most_change = 0.02;

struct Mode {
  std::string name;
  double most;                       ///< instructions that it may add to the step of a tick under control
  std::vector<std::string> changes;  ///< as after --set
};

/// Each alone, beside a flight without any.
const std::array<Mode, 4> modes{
    Mode{"with_schedule", 40.0, {"gain_schedule.speeds_m_s=[20,40,60,80]", "gain_schedule.factors=[1.5,1.2,0.9,0.7]"}},
    Mode{"with_integral", 57.5, {"offset.rejection=integral"}},
    Mode{"with_observer",
         71.0,
         {"offset.rejection=observer", "roll_model.roll_inertia_kg_m2=0.00393",
          "roll_model.reference_area_m2=5.0265e-5", "roll_model.damping_m2=23", "roll_model.torque_m=9"}},
    Mode{"with_gate_and_capture",
         190.0,
         {"dormancy.until=max_dynamic_pressure and height", "dormancy.height_m=100", "controller.entry=capture",
          "roll_model.roll_inertia_kg_m2=0.00393", "roll_model.reference_area_m2=5.0265e-5", "roll_model.damping_m2=23",
          "roll_model.torque_m=9"}}};

/// Of one kind of section: mean, and the longest one.
struct Count {
  void add(std::uint32_t instructions, double time_s) {
    number += 1;
    sum += instructions;
    if (instructions > worst) {
      worst = instructions;
      worst_s = time_s;
    }
  }
  [[nodiscard]] double mean() const {
    return number == 0 ? 0.0 : static_cast<double>(sum) / static_cast<double>(number);
  }

  std::uint64_t number = 0;
  std::uint64_t sum = 0;
  std::uint32_t worst = 0;
  double worst_s = 0.0;  ///< since power-up
};

struct Phase {
  std::string name;
  Count step{};
  Count tick{};
};

class Counter {
 public:
  explicit Counter(const hil::Target& target) : target_{target} {}

  void add(Phase& phase, const core::TickRecord& record) {
    const double time_s = 1e-6 * static_cast<double>(record.time.count());
    phase.step.add(instructions(target_.times().step), time_s);
    phase.tick.add(instructions(target_.times().tick), time_s);
  }

 private:
  // Exact: an instruction takes 64 ns of the emulated time, which are more than ten counts of the clock.
  [[nodiscard]] std::uint32_t instructions(std::uint32_t counts) const {
    const hil::TargetIdentity& known = target_.identity();
    return static_cast<std::uint32_t>(
        std::lround(static_cast<double>(counts) * static_cast<double>(known.instructions) / known.counts));
  }

  const hil::Target& target_;
};

using Phases = std::vector<Phase>;

// The place of the phase that the modes are compared with.
constexpr std::size_t controlling = 1;

bool controls_with_chirp(const core::TickRecord& record) {
  return record.phase == core::Phase::controlling && record.excitation != core::Angle{};
}

Phase count(hil::Target& target, const Mode& mode) {
  std::vector<input::Override> overrides;
  std::ranges::transform(mode.changes, std::back_inserter(overrides), input::parse_override);
  sim::World world{input::load_scenario("tasha3_launch2", overrides), sim::World::large_flash, target.maker()};
  Phase phase{mode.name};
  Counter counter{target};
  while (!world.over()) {
    if (const core::TickRecord& record = world.tick(); controls_with_chirp(record)) {
      counter.add(phase, record);
    }
    world.advance();
  }
  return phase;
}

Phases count(hil::Target& target) {
  Phases phases{Phase{"pad"}, Phase{"controlling_with_chirp"}, Phase{"rest_of_flight"}, Phase{"bench_session"}};
  Counter counter{target};
  const sim::Scenario launch = input::load_scenario("tasha3_launch2", {});
  sim::World world{launch, sim::World::large_flash, target.maker()};
  while (!world.over()) {
    const core::TickRecord& record = world.tick();
    if (record.phase == core::Phase::safe || record.phase == core::Phase::armed) {
      counter.add(phases[0], record);
    } else if (controls_with_chirp(record)) {
      counter.add(phases[controlling], record);
    } else {
      counter.add(phases[2], record);
    }
    world.advance();
  }
  sil::BenchAtWorld bench{"bench_healthy", 1, target.maker()};
  bench.after_tick = [&] { counter.add(phases[3], bench.record); };
  (void)bench.limits();
  for (const Mode& mode : modes) {
    phases.push_back(count(target, mode));
  }
  return phases;
}

bool modes_are_cheap(const Phases& phases) {
  bool cheap = true;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const double more = phases[phases.size() - modes.size() + i].step.mean() - phases[controlling].step.mean();
    std::printf("%s: %.1f instructions more in a step under control; allowed: %.0f\n", modes[i].name.c_str(), more,
                modes[i].most);
    cheap = cheap && more <= modes[i].most;
  }
  return cheap;
}

bool agrees(std::string_view what, double now, double before) {
  const bool same = std::abs(now - before) <= most_change * before;
  if (!same) {
    std::printf("%.*s: %.0f instructions, and %.0f before\n", static_cast<int>(what.size()), what.data(), now, before);
  }
  return same;
}

/// "GCC: (15:12.2.rel1-1) 12.2.1 20221205", from the section .comment.
std::string compiler_of(const std::string& image) {
  std::ifstream file{image, std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  const std::size_t begin = bytes.find("GCC: (");
  return begin == std::string::npos ? "a compiler that is not named"
                                    : bytes.substr(begin, bytes.find('\0', begin) - begin);
}

bool compare(const Phases& phases, const std::string& path, const std::string& compiler) {
  std::ifstream file{path};
  std::string line;
  std::getline(file, line);
  if (line != compiler) {
    std::printf("not compared: %s has the counts of %s, and this is %s\n", path.c_str(), line.c_str(),
                compiler.c_str());
    return true;
  }
  std::getline(file, line);  // the names of the columns
  bool same = true;
  for (const Phase& phase : phases) {
    std::string name;
    double step = 0.0;
    double step_worst = 0.0;
    double tick = 0.0;
    double tick_worst = 0.0;
    if (!(file >> name >> step >> step_worst >> tick >> tick_worst) || name != phase.name) {
      std::printf("%s has no counts of %s\n", path.c_str(), phase.name.c_str());
      return false;
    }
    same = agrees(name + ", mean step", phase.step.mean(), step) && same;
    same = agrees(name + ", worst step", phase.step.worst, step_worst) && same;
    same = agrees(name + ", mean tick", phase.tick.mean(), tick) && same;
    same = agrees(name + ", worst tick", phase.tick.worst, tick_worst) && same;
  }
  if (!same) {
    std::printf("if that is meant: count_instructions %s --write\n", path.c_str());
  }
  return same;
}

bool write(const Phases& phases, const std::string& path, const std::string& compiler) {
  std::ofstream file{path};
  file << compiler << "\nphase step_mean step_worst tick_mean tick_worst\n";
  for (const Phase& phase : phases) {
    file << phase.name << ' ' << std::lround(phase.step.mean()) << ' ' << phase.step.worst << ' '
         << std::lround(phase.tick.mean()) << ' ' << phase.tick.worst << '\n';
  }
  return file.good();
}

int run(int argc, char** argv) {
  if (const std::string objection = objection_to_images(); !objection.empty()) {
    std::printf("%s\n", objection.c_str());
    return 77;
  }
  const std::string counted = image("fantail-count.elf");
  hil::Target target{
      std::make_unique<hil::Emulator>(hil::EmulatorOptions{.image = counted, .icount = "shift=6,sleep=off"})};
  const Phases phases = count(target);
  std::printf("instructions           ticks   step mean   worst at s       tick mean   worst at s\n");
  for (const Phase& phase : phases) {
    std::printf("%-22s %5llu %11.1f %7u %8.3f %11.1f %7u %8.3f\n", phase.name.c_str(),
                static_cast<unsigned long long>(phase.step.number), phase.step.mean(), phase.step.worst,
                phase.step.worst_s, phase.tick.mean(), phase.tick.worst, phase.tick.worst_s);
  }
  const bool cheap = modes_are_cheap(phases);
  if (argc < 2) {
    return cheap ? 0 : 1;
  }
  const bool to_write = argc > 2 && std::string_view{argv[2]} == "--write";
  const std::string compiler = compiler_of(counted);
  return (to_write ? write(phases, argv[1], compiler) : compare(phases, argv[1], compiler)) && cheap ? 0 : 1;
}

}  // namespace
}  // namespace fantail::test

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // an emulator that dies is told of in words
  try {
    return fantail::test::run(argc, argv);
  } catch (const std::exception& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
