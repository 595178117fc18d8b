// SPDX-License-Identifier: MIT
#include "identify/write_study.hpp"

#include <fmt/core.h>

#include "identify/model_csv.hpp"
#include "identify/result_html.hpp"
#include "identify/result_json.hpp"
#include "report/output_folder.hpp"

namespace fantail::identify {

std::vector<std::string> model_csv_names(const Study& study) {
  std::vector<std::string> names;
  for (const WindowFindings& window : study.windows) {
    for (std::size_t k = 0; k < window.results.size(); ++k) {
      names.push_back(fmt::format("model_{}.csv", names.size() + 1));
    }
  }
  return names.size() == 1 ? std::vector<std::string>{"model.csv"} : names;
}

void write_study(const Study& study, const std::filesystem::path& folder) {
  std::vector<report::NamedFile> files{{"report.html", result_html(study)},
                                       {"identification.json", result_json(study)}};
  const std::vector<std::string> names = model_csv_names(study);
  std::size_t next = 0;
  for (const WindowFindings& window : study.windows) {
    for (const Identification& result : window.results) {
      files.push_back({names[next++], model_csv(window.record, result.model, result.simulation)});
    }
  }
  report::OutputFolder{folder}.write(files);
}

}  // namespace fantail::identify
