// SPDX-License-Identifier: MIT
#include "fantail/compare_results.hpp"

#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "fantail/deliver.hpp"
#include "fantail/terminal.hpp"
#include "json/value.hpp"
#include "text/degrees.hpp"
#include "text/layout.hpp"
#include "text/output_folder.hpp"
#include "text/quoting.hpp"

namespace fantail::tool {
namespace {

using json::rounded;
using text::degrees;

std::string too_large(std::string_view what, double mean_rad, double required_rad, std::string_view unit) {
  return fmt::format("mean {} difference {:.3g} {} is larger than the {:.3g} {} required", what, degrees(mean_rad),
                     unit, degrees(required_rad), unit);
}

}  // namespace

void CompareResults::take_warnings(const logs::RollLog& log_a, const logs::RollLog& log_b) {
  for (const auto& [name, log] : {std::pair{"A", &log_a}, std::pair{"B", &log_b}}) {
    for (const std::string& warning : log->warnings) {
      warnings.push_back(fmt::format("{}: {}", name, warning));
    }
  }
  warnings.insert(warnings.end(), comparison.warnings.begin(), comparison.warnings.end());
}

std::vector<std::string> CompareResults::objections() const {
  std::vector<std::string> sentences;
  if (required() && !is_known()) {
    sentences.push_back(fmt::format(
        "time that both logs know, {:.3f} s of {:.3f} s, is less than the nine in ten that a requirement needs",
        comparison.known_s, comparison.asked_s));
  }
  if (required_angle_rad && comparison.angle.mean_abs > *required_angle_rad) {
    sentences.push_back(too_large("angle", comparison.angle.mean_abs, *required_angle_rad, "deg"));
  }
  if (required_rate_rad_s && comparison.rate.mean_abs > *required_rate_rad_s) {
    sentences.push_back(too_large("rate", comparison.rate.mean_abs, *required_rate_rad_s, "deg/s"));
  }
  return sentences;
}

std::string compare_text(const CompareResults& results) {
  const logs::Comparison& c = results.comparison;
  std::string text = fmt::format("A  {}\nB  {}\n\n", text::printable(results.a), text::printable(results.b));
  text += fmt::format("{} samples, {:.3f} s to {:.3f} s of A{}\n", c.time_s.size(), c.time_s.front(), c.time_s.back(),
                      results.window.empty() ? "" : ", window " + results.window);
  text += fmt::format("B's clock shows {:+.4f} s at A's zero ({})\n", c.shift_s + 0.0,
                      results.shift_found ? "found from the roll rates"
                      : c.shift_s == 0.0  ? "the clocks as they are"
                                          : "as stated");
  if (c.offset_rad != 0.0) {
    text += fmt::format("B's angles moved by {:+.3g} deg, so that both begin alike\n", degrees(c.offset_rad));
  }
  text::Table table{{{.name = "absolute difference"},
                     {.name = "mean"},
                     {.name = "rms", .goes_as = 1},
                     {.name = "largest"},
                     {.name = "at", .goes_as = 2}}};
  const auto right = [](std::string_view word) { return fmt::format("{:>10}", word); };
  table.row({fmt::format("{:<24}", "absolute difference"), right("mean"), right("rms"), right("largest"),
             fmt::format("{:>12}", "at")});
  const auto row = [&](std::string_view label, const logs::Difference& d) {
    const auto figure = [&](double radians) { return right(fmt::format("{:.3g}", degrees(radians))); };
    table.row({fmt::format("{:<24}", label), figure(d.mean_abs), figure(d.rms), figure(d.max_abs),
               fmt::format("{:>10.3f} s", d.max_at_s)});
  };
  row("  roll angle / deg", c.angle);
  row("  roll rate / (deg/s)", c.rate);
  text += "\n" + table.text(output_columns());
  for (const std::string& sentence : results.warnings) {
    text += "\nNote: " + sentence;
  }
  return text + (results.warnings.empty() ? "" : "\n");
}

std::string compare_json(const CompareResults& results) {
  using Json = json::Value;
  const logs::Comparison& c = results.comparison;
  Json json = {{"a", results.a},
               {"b", results.b},
               {"window", results.window.empty() ? Json{} : Json(results.window)},
               {"mean_abs_angle_difference_deg", rounded(degrees(c.angle.mean_abs))},
               {"rms_angle_difference_deg", rounded(degrees(c.angle.rms))},
               {"max_abs_angle_difference_deg", rounded(degrees(c.angle.max_abs))},
               {"max_angle_difference_at_s", rounded(c.angle.max_at_s)},
               {"mean_abs_rate_difference_deg_s", rounded(degrees(c.rate.mean_abs))},
               {"rms_rate_difference_deg_s", rounded(degrees(c.rate.rms))},
               {"max_abs_rate_difference_deg_s", rounded(degrees(c.rate.max_abs))},
               {"max_rate_difference_at_s", rounded(c.rate.max_at_s)},
               {"samples", c.time_s.size()},
               {"from_s", rounded(c.time_s.front())},
               {"to_s", rounded(c.time_s.back())},
               {"seconds", rounded(c.time_s.back() - c.time_s.front())},
               {"shift_s", rounded(c.shift_s)},
               {"offset_deg", rounded(degrees(c.offset_rad))},
               {"requirement_met", results.required() ? Json(results.objections().empty()) : Json{}},
               {"notes", results.warnings},
               {"version", FANTAIL_VERSION}};
  const auto answer = !results.required()            ? result::Answer::none
                      : results.objections().empty() ? result::Answer::yes
                                                     : result::Answer::no;
  result::put_answer(
      json, answer,
      fmt::format("The roll angles differ by {:.3g} deg in the mean and {:.3g} deg at most, the rates by {:.3g} deg/s.",
                  degrees(c.angle.mean_abs), degrees(c.angle.max_abs), degrees(c.rate.mean_abs)),
      made_with(results.logs));
  return json.pretty();
}

std::string compare_csv(const logs::Comparison& c) {
  fmt::memory_buffer out;
  fmt::format_to(std::back_inserter(out),
                 "time_s,a_roll_angle_deg,b_roll_angle_deg,roll_angle_difference_deg,"
                 "a_roll_rate_deg_s,b_roll_rate_deg_s,roll_rate_difference_deg_s\n");
  for (std::size_t i = 0; i < c.time_s.size(); ++i) {
    fmt::format_to(std::back_inserter(out), "{:.6f}", rounded(c.time_s[i]));
    for (const double value : {c.a_angle_rad[i], c.b_angle_rad[i], c.angle_difference_rad[i], c.a_rate_rad_s[i],
                               c.b_rate_rad_s[i], c.rate_difference_rad_s[i]}) {
      fmt::format_to(std::back_inserter(out), ",{:.6f}", rounded(degrees(value)));
    }
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

void write_compare_results(const CompareResults& results, const std::filesystem::path& folder) {
  const std::array<text::NamedFile, 3> files{{{"compare.html", compare_html(results)},
                                              {"compare.json", compare_json(results)},
                                              {"differences.csv", compare_csv(results.comparison)}}};
  text::OutputFolder{folder, results.logs}.write(files);
}

}  // namespace fantail::tool
