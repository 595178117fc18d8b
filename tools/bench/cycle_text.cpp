// SPDX-License-Identifier: MIT
#include <string_view>

#include <fmt/core.h>

#include "bench/cycle.hpp"
#include "bench/sheet_parts.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

class Page {
 public:
  Page(const Cycle& cycle, std::size_t columns) : cycle_{cycle}, columns_{columns} {}

  std::string write() {
    heading();
    table("lag and delay, ms", lag_course, 1e3, 0);
    table("tracking error, rms, deg", tracking_rms_course, text::degrees(1.0), 2);
    table("tracking error, largest, deg", tracking_error_course, text::degrees(1.0), 2);
    if (knows_battery(cycle_)) {
      title("battery, V");
      row("lowest", battery_course(cycle_), 1.0, 2);
      finish();
    }
    out_ += fmt::format("\n{}\n", display_name(judgement(cycle_)));
    for (const std::string& conclusion : conclusions(cycle_)) {
      out_ += "  " + conclusion + "\n";
    }
    return out_;
  }

 private:
  void heading() {
    out_ += fmt::format("Endurance of the canards: {} of {} laps of {} s\n", cycle_.laps.size(), cycle_.planned_laps,
                        text::fixed(cycle_.lap_s, 1));
    out_ += heading_lines(cycle_.heading);
  }

  void title(std::string_view what) {
    out_ += '\n';
    table_.row({fmt::format("{:<30}", what), fmt::format("{:>6}", "first"), fmt::format("{:>7}", "last"),
                fmt::format("{:>7}", "worst"), "   each tenth of the laps"});
  }

  void finish() {
    out_ += table_.text(columns_);
    table_ = empty_table();
  }

  void table(std::string_view what, Course (*course)(const Cycle&, std::size_t), double unit, int decimals) {
    title(what);
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      row(fmt::format("canard {}", canard + 1), course(cycle_, canard), unit, decimals);
    }
    finish();
  }

  void row(std::string_view name, const Course& course, double unit, int decimals) {
    const auto cell = [&](const std::optional<double>& value) {
      return value ? text::fixed(unit * *value, decimals) : std::string{"-"};
    };
    std::string tenths = "  ";
    for (const auto& tenth : course.tenths) {
      tenths += fmt::format("{:>5}", cell(tenth));
    }
    table_.row({fmt::format("  {:<28}", name), fmt::format("{:>6}", cell(course.first)),
                fmt::format("{:>7}", cell(course.last)), fmt::format("{:>7}", cell(course.worst)), tenths});
  }

  static text::Table empty_table() {
    return text::Table{{{""}, {"first"}, {"last"}, {"worst"}, {"each tenth of the laps", 1}}};
  }

  const Cycle& cycle_;
  std::size_t columns_;
  text::Table table_ = empty_table();
  std::string out_;
};

}  // namespace

std::string cycle_text(const Cycle& cycle, std::size_t columns) { return Page{cycle, columns}.write(); }

}  // namespace fantail::bench
