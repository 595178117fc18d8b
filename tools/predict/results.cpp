// SPDX-License-Identifier: MIT
#include "predict/results.hpp"

#include <array>

#include <fmt/core.h>

#include "text/number.hpp"
#include "text/output_folder.hpp"

namespace fantail::predict {
namespace {

using text::degrees;
using text::fixed;

std::string cell(const std::optional<double>& value) { return value ? fixed(*value, 6) : ""; }
std::string angle(const std::optional<double>& radians) { return radians ? fixed(degrees(*radians), 6) : ""; }

}  // namespace

void write_prediction(const Prediction& prediction, const Decision& decision, std::string_view version,
                      const std::filesystem::path& folder, const std::vector<std::filesystem::path>& made_from) {
  const std::array<text::NamedFile, 4> files{{{"predict.html", prediction_html(prediction, decision, version)},
                                              {"predict.json", prediction_json(prediction, decision, version)},
                                              {"runs.csv", runs_csv(prediction)},
                                              {"band.csv", band_csv(prediction)}}};
  text::OutputFolder{folder, made_from}.write(files);
}

std::string runs_csv(const Prediction& p) {
  std::string text =
      "run,seed,alpha_m2,beta_m,offset_begin_deg,offset_end_deg,authority_margin_deg,outcome,largest_hold_error_deg,"
      "settle_deg,saturated_share,top_speed_m_s,apogee_m,spin_rate_deg_s,wind_m_s,wind_from_deg,"
      "drift_m\n";
  std::size_t number = 0;
  for (const Run& run : p.runs) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", number++, run.seed,
                        fixed(run.airframe.damping_m2, 6), fixed(run.airframe.torque_m, 6),
                        angle(run.airframe.offset_begin_rad), angle(run.airframe.offset_end_rad),
                        angle(run.authority_margin_rad), report::name(run.outcome), angle(run.largest_hold_error_rad),
                        angle(run.settle_rad), cell(run.saturated_share), cell(run.top_speed_m_s), cell(run.apogee_m),
                        angle(run.spin_rate_rad_s), cell(run.wind ? std::optional{run.wind->speed_m_s} : std::nullopt),
                        angle(run.wind ? std::optional{run.wind->from_rad} : std::nullopt), cell(run.drift_m));
  }
  return text;
}

std::string band_csv(const Prediction& p) {
  std::string text =
      "time_s,roll_angle_p5_deg,roll_angle_p50_deg,roll_angle_p95_deg,roll_rate_p5_deg_s,roll_rate_p50_deg_s,"
      "roll_rate_p95_deg_s\n";
  for (std::size_t i = 0; i < p.band.time_s.size(); ++i) {
    const Quantiles& roll = p.band.roll_angle_rad[i];
    const Quantiles& rate = p.band.roll_rate_rad_s[i];
    text += fmt::format("{},{},{},{},{},{},{}\n", fixed(p.band.time_s[i], 2), angle(roll.p5), angle(roll.p50),
                        angle(roll.p95), angle(rate.p5), angle(rate.p50), angle(rate.p95));
  }
  return text;
}

}  // namespace fantail::predict
