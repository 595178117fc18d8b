// SPDX-License-Identifier: MIT
#include "report/results.hpp"

#include <vector>

#include "report/csv.hpp"
#include "report/html.hpp"
#include "report/output_folder.hpp"
#include "report/summary_json.hpp"

namespace fantail::report {

Results results(const Flight& flight) {
  Results r;
  r.figures = figures(flight);
  r.verdict = verdict(flight, r.figures);
  r.summary = summary_json(flight, r.figures, r.verdict);
  return r;
}

void write_results(const Flight& flight, const Results& results, const std::filesystem::path& folder) {
  std::vector<NamedFile> files{{"flight.csv", csv(flight)},
                               {"summary.json", results.summary},
                               {"report.html", html(flight, results.figures, results.verdict)}};
  if (!flight.tunnel_readings.empty()) {
    files.push_back({"tunnel.csv", tunnel_csv(flight)});
  }
  OutputFolder{folder}.write(files);
}

}  // namespace fantail::report
