// SPDX-License-Identifier: MIT
// Usage: bench_sheets FOLDER
// Sheets of a healthy rocket and of one with a reversed canard, as `fantail bench limits` makes them, without a bus.
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>

#include "bench/sheet.hpp"
#include "bench/synthetic.hpp"
#include "text/output_folder.hpp"

int main(int argc, char** argv) {
  using namespace fantail;
  if (argc != 2) {
    return 64;
  }
  try {
    const bench::Exercise exercise = bench::Exercise::limits(bench::six_degrees());
    bench::Bench healthy;
    bench::Bench reversed;
    reversed.canards[2].gain = -1.0;
    const bench::Heading heading{
        .vehicle = "Tasha III", .plan = "tasha3_launch2", .plan_crc = "1234abcd", .version = "test"};
    const auto sheet = [&](bench::Bench& rocket) {
      const link::Recording recording = rocket.record(exercise);
      return bench::sheet_html(bench::examine(recording, exercise, {}, heading), recording, exercise);
    };
    const std::array<text::NamedFile, 2> files{{{"healthy.html", sheet(healthy)}, {"reversed.html", sheet(reversed)}}};
    text::OutputFolder{argv[1]}.write(files);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_sheets: %s\n", error.what());
    return 70;
  }
  return 0;
}
