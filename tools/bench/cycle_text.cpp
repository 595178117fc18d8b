// SPDX-License-Identifier: MIT
#include <string_view>

#include <fmt/core.h>

#include "bench/cycle.hpp"
#include "bench/sheet_parts.hpp"
#include "text/degrees.hpp"
#include "text/number.hpp"

namespace fantail::bench {
namespace {

class Page {
 public:
  explicit Page(const Cycle& cycle) : cycle_{cycle} {}

  std::string write() {
    heading();
    table("lag and delay, ms", lag_course, 1e3, 0);
    table("tracking error, rms, deg", tracking_rms_course, text::degrees(1.0), 2);
    table("tracking error, largest, deg", tracking_error_course, text::degrees(1.0), 2);
    if (knows_battery(cycle_)) {
      title("battery, V");
      row("lowest", battery_course(cycle_), 1.0, 2);
    }
    out_ += fmt::format("\n{}\n", display_name(judgement(cycle_)));
    for (const std::string& conclusion : conclusions(cycle_)) {
      out_ += "  " + conclusion + "\n";
    }
    return out_;
  }

 private:
  void heading() {
    const Heading& h = cycle_.heading;
    out_ += fmt::format("Canards in endurance: {} of {} laps of {} s\n", cycle_.laps.size(), cycle_.planned_laps,
                        text::fixed(cycle_.lap_s, 1));
    for (const auto& [label, value] : {std::pair{"vehicle", h.vehicle},
                                       {"plan", h.plan},
                                       {"plan CRC", h.plan_crc},
                                       {"date", h.date},
                                       {"avionics", h.avionics}}) {
      if (!value.empty()) {
        out_ += fmt::format("  {:<10}{}\n", label, printable(value));
      }
    }
  }

  void title(std::string_view what) {
    out_ += fmt::format("\n{:<30}{:>6}{:>7}{:>7}   each tenth of the laps\n", what, "first", "last", "worst");
  }

  void table(std::string_view what, Course (*course)(const Cycle&, std::size_t), double unit, int decimals) {
    title(what);
    for (std::size_t canard = 0; canard < core::canard_count; ++canard) {
      row(fmt::format("canard {}", canard + 1), course(cycle_, canard), unit, decimals);
    }
  }

  void row(std::string_view name, const Course& course, double unit, int decimals) {
    const auto cell = [&](const std::optional<double>& value) {
      return value ? text::fixed(unit * *value, decimals) : std::string{"-"};
    };
    out_ += fmt::format("  {:<28}{:>6}{:>7}{:>7}  ", name, cell(course.first), cell(course.last), cell(course.worst));
    for (const auto& tenth : course.tenths) {
      out_ += fmt::format("{:>5}", cell(tenth));
    }
    out_ += '\n';
  }

  const Cycle& cycle_;
  std::string out_;
};

}  // namespace

std::string cycle_text(const Cycle& cycle) { return Page{cycle}.write(); }

}  // namespace fantail::bench
