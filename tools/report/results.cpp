// SPDX-License-Identifier: MIT
#include "report/results.hpp"

#include <array>

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
  const std::array<NamedFile, 3> files{{{"flight.csv", csv(flight)},
                                        {"summary.json", results.summary},
                                        {"report.html", html(flight, results.figures, results.verdict)}}};
  OutputFolder{folder}.write(files);
}

}  // namespace fantail::report
