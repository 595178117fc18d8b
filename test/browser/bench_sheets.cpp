// SPDX-License-Identifier: MIT
// Usage: bench_sheets FOLDER | --live
// What `fantail bench limits` makes, without a bus: the sheets of a healthy rocket and of one with a reversed canard in
// FOLDER with the odd pages, or the page of that second rocket while its canards move, four times as fast.
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string_view>
#include <thread>

#include "bench/sheet.hpp"
#include "bench/synthetic.hpp"
#include "browser/odd_pages.hpp"
#include "fantail/bench_page.hpp"
#include "page/page.hpp"
#include "text/output_folder.hpp"

namespace {

using namespace fantail;

const bench::Heading heading{
    .vehicle = "Tasha <b>III</b>", .plan = "tasha3_launch2", .plan_crc = "1234abcd", .version = "test"};

bench::Bench reversed_rocket() {
  bench::Bench rocket;
  rocket.canards[2].gain = -1.0;
  return rocket;
}

void write_sheets(const char* folder, const bench::Exercise& exercise) {
  const auto sheet = [&](bench::Bench rocket) {
    const link::Recording recording = rocket.record(exercise);
    return bench::sheet_html(bench::examine(recording, exercise, {}, heading), recording, exercise);
  };
  const std::array<text::NamedFile, 2> files{
      {{"healthy.html", sheet({})}, {"reversed.html", sheet(reversed_rocket())}}};
  text::OutputFolder{folder}.write(files);
  text::OutputFolder{folder}.write(test::odd_pages());
}

void show_live(const bench::Exercise& exercise) {
  constexpr std::chrono::microseconds between_ticks{250};
  bench::Bench rocket = reversed_rocket();
  const link::Recording recording = rocket.record(exercise);
  page::set_made_by("bench_sheets --live", "test");
  tool::BenchPage page{{.at = "127.0.0.1:0"}, heading.vehicle + " on no bus"};
  page.wait_for_viewer();
  page.begin(exercise, {}, heading);
  auto next = std::chrono::steady_clock::now();
  for (const link::Tick& tick : recording.ticks()) {
    page.take(tick);
    page.progress(1e-3 * static_cast<double>(tick.number - recording.ticks().front().number));
    std::this_thread::sleep_until(next += between_ticks);
  }
  std::printf("%s\n", page.finish(bench::examine(recording, exercise, {}, heading), recording, exercise).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    return 64;
  }
  try {
    const bench::Exercise exercise = bench::Exercise::limits(bench::six_degrees());
    if (std::string_view{argv[1]} == "--live") {
      show_live(exercise);
    } else {
      write_sheets(argv[1], exercise);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_sheets: %s\n", error.what());
    return 70;
  }
  return 0;
}
