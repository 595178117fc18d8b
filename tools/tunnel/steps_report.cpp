// SPDX-License-Identifier: MIT
#include "tunnel/steps_report.hpp"

#include <fmt/core.h>

#include "text/degrees.hpp"
#include "tunnel/json.hpp"

namespace fantail::tunnel {
namespace {

using text::degrees;

const char* name(identify::result::Method method) {
  return method == identify::result::Method::grid ? "grid" : "continuous";
}

Json step_json(const StepResult& result) {
  const identify::model::RollModel& model = result.identified.model;
  const identify::model::Simulation& simulation = result.identified.simulation;
  Json one = {{"step", result.number},
              {"begin_s", rounded(result.step.begin_s)},
              {"from_deg", angle(result.step.from_rad)},
              {"to_deg", angle(result.step.to_rad)},
              {"alpha_m2", rounded(model.alpha_m2)},
              {"beta_m", rounded(model.beta_m)},
              {"disturbance_begin_deg", angle(model.node_rad.front())},
              {"disturbance_end_deg", angle(model.node_rad.back())},
              {"mean_abs_angle_error_deg", angle(simulation.mean_abs_angle_error_rad)},
              {"mean_abs_rate_error_deg_s", angle(simulation.mean_abs_rate_error_rad_s)},
              {"samples", result.identified.samples},
              {"seconds", rounded(result.identified.seconds)}};
  if (const auto& known = result.identified.uncertainty; known && known->standard_deviation.size() >= 2) {
    one["alpha_standard_deviation_m2"] = rounded(known->standard_deviation[0]);
    one["beta_standard_deviation_m"] = rounded(known->standard_deviation[1]);
    one["alpha_identifiable"] = known->alpha_identifiable;
  }
  return one;
}

Json row_of(const StepTable& table, double Spread::* value) {
  return {{"alpha_m2", rounded(table.alpha_m2.*value)},
          {"beta_m", rounded(table.beta_m.*value)},
          {"disturbance_begin_deg", angle(table.disturbance_begin_rad.*value)},
          {"disturbance_end_deg", angle(table.disturbance_end_rad.*value)},
          {"mean_abs_angle_error_deg", angle(table.mean_abs_angle_error_rad.*value)},
          {"mean_abs_rate_error_deg_s", angle(table.mean_abs_rate_error_rad_s.*value)}};
}

std::string row_text(const std::string& first, double alpha_m2, double beta_m, double begin_rad, double end_rad,
                     double angle_rad, double rate_rad_s) {
  return fmt::format("{:<22}{:8.3f} {:8.3f}   {:8.3f} {:8.3f}   {:8.3f} {:8.3f}\n", first, alpha_m2, beta_m,
                     degrees(begin_rad), degrees(end_rad), degrees(angle_rad), degrees(rate_rad_s));
}

std::string row_text(const std::string& first, const StepTable& table, double Spread::* value) {
  return row_text(first, table.alpha_m2.*value, table.beta_m.*value, table.disturbance_begin_rad.*value,
                  table.disturbance_end_rad.*value, table.mean_abs_angle_error_rad.*value,
                  table.mean_abs_rate_error_rad_s.*value);
}

}  // namespace

std::string steps_basis(const StepsHeading& heading) {
  const std::string speed = heading.speed_m_s ? fmt::format("{:.3f} m/s", *heading.speed_m_s) : "the speed of each row";
  return fmt::format(
      "{}: inertia {:g} kg m2, reference area {:g} m2; {} ({}), density {:g} kg/m3; the first {:g} s of each step, "
      "method "
      "{}.",
      heading.vehicle, heading.airframe.inertia_kg_m2, heading.airframe.reference_area_m2, speed, heading.speed_source,
      heading.density_kg_m3, heading.options.seconds, name(heading.options.method));
}

std::string steps_text(const StepsHeading& heading, const StepTable& table) {
  std::string text = fmt::format("{}: {} steps\n{}\n\n", heading.log, table.steps.size(), steps_basis(heading));
  text += "                        alpha     beta     disturbance / deg     mean abs error of\n";
  text += "step                       m2        m      begin      end    angle/deg  rate/deg/s\n";
  for (const StepResult& result : table.steps) {
    const identify::model::RollModel& model = result.identified.model;
    const identify::model::Simulation& simulation = result.identified.simulation;
    text += row_text(fmt::format("{:2} at {:g} s", result.number, result.step.begin_s), model.alpha_m2, model.beta_m,
                     model.node_rad.front(), model.node_rad.back(), simulation.mean_abs_angle_error_rad,
                     simulation.mean_abs_rate_error_rad_s);
  }
  text += row_text("mean", table, &Spread::mean);
  text += row_text("standard deviation", table, &Spread::deviation);
  text += table.remarks.empty() ? "" : "\n";
  for (const std::string& remark : table.remarks) {
    text += "  " + remark + "\n";
  }
  return text;
}

std::string steps_json(const StepsHeading& heading, const StepTable& table) {
  Json steps = Json::array();
  for (const StepResult& result : table.steps) {
    steps.push_back(step_json(result));
  }
  const Json all = {{"log", heading.log},
                    {"vehicle", heading.vehicle},
                    {"inertia_kg_m2", rounded(heading.airframe.inertia_kg_m2)},
                    {"reference_area_m2", heading.airframe.reference_area_m2},
                    {"speed_m_s", rounded(heading.speed_m_s)},
                    {"speed_source", heading.speed_source},
                    {"density_kg_m3", rounded(heading.density_kg_m3)},
                    {"method", name(heading.options.method)},
                    {"seconds", rounded(heading.options.seconds)},
                    {"steps", steps},
                    {"mean", row_of(table, &Spread::mean)},
                    {"standard_deviation", row_of(table, &Spread::deviation)},
                    {"remarks", table.remarks}};
  return all.pretty();
}

}  // namespace fantail::tunnel
