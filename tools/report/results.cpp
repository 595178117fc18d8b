// SPDX-License-Identifier: MIT
#include "report/results.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "flight/write_csv.hpp"
#include "report/html.hpp"
#include "report/summary_json.hpp"
#include "text/output_folder.hpp"

namespace fantail::report {
namespace {

std::string text(std::span<const std::byte> bytes) {
  std::string out(bytes.size(), '\0');
  std::ranges::transform(bytes, out.begin(), [](std::byte byte) { return static_cast<char>(byte); });
  return out;
}

}  // namespace

Results results(const flight::Flight& flight) {
  Results r;
  r.figures = figures(flight);
  r.verdict = verdict(flight, r.figures);
  r.summary = summary_json(flight, r.figures, r.verdict);
  return r;
}

void write_results(const flight::Flight& flight, const Results& results, const std::filesystem::path& folder) {
  std::vector<text::NamedFile> files{{"flight.csv", csv(flight)},
                                     {"summary.json", results.summary},
                                     {"report.html", html(flight, results.figures, results.verdict)}};
  std::vector<std::string> of_others;
  const auto add = [&](const char* name, bool there, const auto& content) {
    if (there) {
      files.push_back({name, content()});
    } else {
      of_others.emplace_back(name);
    }
  };
  add("flight.ftl", !flight.log.empty(), [&] { return text(flight.log); });
  add("tunnel.csv", !flight.tunnel_readings.empty(), [&] { return flight::tunnel_csv(flight); });
  text::OutputFolder{folder}.write(files, of_others);
}

}  // namespace fantail::report
