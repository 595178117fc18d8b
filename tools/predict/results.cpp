// SPDX-License-Identifier: MIT
#include "predict/results.hpp"

#include <array>

#include "text/output_folder.hpp"

namespace fantail::predict {

void write_prediction(const Prediction& prediction, const Decision& decision, std::string_view version,
                      const std::filesystem::path& folder) {
  const std::array<text::NamedFile, 4> files{{{"predict.html", prediction_html(prediction, decision, version)},
                                              {"predict.json", prediction_json(prediction, decision, version)},
                                              {"runs.csv", runs_csv(prediction)},
                                              {"band.csv", band_csv(prediction)}}};
  text::OutputFolder{folder}.write(files);
}

}  // namespace fantail::predict
